//! Hearth natively, as a program of the benchmarks.
//!
//!     native N STEPS      one line as README.md describes it, of a block of N particles
//!     native peak         one line: the peak rate on four numbers at once
//!     native fire N STIFFNESS STEPS  JSON: a fire of the combustion model and the time of its steps
//!     native gas N STEPS  JSON: a block, and the same block STEPS steps later

use std::env;
use std::time::Instant;

use hearth_benches::{Scene, peak, scenes};

/// Steps before those that are measured.
const WARM_UP: u32 = 3;

fn main() -> Result<(), String> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let number = |at: usize| -> Option<u32> { arguments.get(at)?.parse().ok() };
    match (arguments.first().map(String::as_str), number(0)) {
        (Some("peak"), _) => {
            println!("Hearth,where=native,gflops={:.3}", gigaflops());
            Ok(())
        }
        (Some("fire"), _) => fire(number(1), number(2), number(3)),
        (Some("gas"), _) => gas(number(1).unwrap_or(1000), number(2).unwrap_or(20)),
        (_, Some(count)) => steps(count, number(1).unwrap_or(20).max(1)),
        _ => Err("usage: native N STEPS | native peak | native fire N STIFFNESS STEPS | native gas N STEPS".to_owned()),
    }
}

fn steps(count: u32, steps: u32) -> Result<(), String> {
    let mut scene = Scene::block(count, scenes::NEIGHBOURS)?;
    let (median, least) = times(&mut scene, steps);
    println!(
        "Hearth,where=native,N={count},neigh={:.2},median_ms={median:.4},min_ms={least:.4}",
        scene.neighbours()
    );
    Ok(())
}

fn fire(count: Option<u32>, stiffness: Option<u32>, steps: Option<u32>) -> Result<(), String> {
    let stiffness = f64::from(stiffness.unwrap_or(6));
    let mut scene = Scene::combustion(count.unwrap_or(3000), stiffness)?;
    let (median, _) = times(&mut scene, steps.unwrap_or(100).max(1));
    println!(
        "{{\"particles\":{},\"neighbours\":{:.2},\"substeps\":{},\"stepsPerFrame\":{},\"stepMs\":{median:.4}}}",
        scene.particles(),
        scene.neighbours(),
        scene.substeps(),
        scene.steps_per_frame()
    );
    Ok(())
}

/// Median and least time of a step \[ms\].
fn times(scene: &mut Scene, steps: u32) -> (f64, f64) {
    scene.step(WARM_UP);
    let milliseconds = (0..steps)
        .map(|_| {
            let start = Instant::now();
            scene.step(1);
            start.elapsed().as_secs_f64() * 1e3
        })
        .collect();
    median_and_least(milliseconds)
}

fn median_and_least(mut values: Vec<f64>) -> (f64, f64) {
    values.sort_by(f64::total_cmp);
    let median = values.get(values.len() / 2).copied().unwrap_or_default();
    (median, values.first().copied().unwrap_or_default())
}

/// Billions of operations a second, in the best of some rounds.
fn gigaflops() -> f64 {
    const ROUNDS: u32 = 500_000;
    let nanoseconds = (0..15)
        .map(|_| {
            let start = Instant::now();
            std::hint::black_box(peak::compute(ROUNDS));
            start.elapsed().as_secs_f64() * 1e9
        })
        .fold(f64::INFINITY, f64::min);
    f64::from(ROUNDS) * f64::from(peak::operations_a_round()) / nanoseconds
}

/// What the baselines in JavaScript must compute too.
fn gas(count: u32, steps: u32) -> Result<(), String> {
    let mut scene = Scene::block(count, scenes::NEIGHBOURS)?;
    let (positions, velocities) = (scene.positions(), scene.velocities());
    scene.step(steps);
    println!(
        "{{\"steps\":{steps},\"start\":{{\"positions\":{positions:?},\"velocities\":{velocities:?}}},\
         \"end\":{{\"densities\":{:?},\"velocities\":{:?}}}}}",
        scene.densities(),
        scene.velocities()
    );
    Ok(())
}
