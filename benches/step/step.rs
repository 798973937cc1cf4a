//! The native cost of a step, with neighbours beside every figure.
//!
//! `cargo bench -p hearth-benches-step`

use std::time::{Duration, Instant};

use criterion::measurement::WallTime;
use criterion::{
    BenchmarkGroup, BenchmarkId, Criterion, Throughput, criterion_group, criterion_main,
};
use hearth_benches::{Scene, scenes};

/// Steps after which a scene returns to its initial state: a block without gravity expands in
/// the thousands of steps of a run.
const STEPS: u64 = 100;

fn fires(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("fire");
    measure(&mut group, "default", Scene::combustion(3000, 6.0));
    measure(&mut group, "high", Scene::combustion(6700, 10.0));
    for count in [1000, 5000, 20_000] {
        measure(&mut group, &format!("plume {count}"), Scene::plume(count));
    }
}

fn blocks(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("block");
    for count in [1_000, 5_000, 20_000, 100_000, 400_000] {
        let scene = Scene::block(count, scenes::NEIGHBOURS);
        measure(&mut group, &count.to_string(), scene);
    }
}

fn measure(group: &mut BenchmarkGroup<'_, WallTime>, name: &str, scene: Result<Scene, String>) {
    let mut scene = match scene {
        Ok(scene) => scene,
        Err(why) => {
            println!("{name} is left out: {why}");
            return;
        }
    };
    println!(
        "{name}: {} particles, {:.1} neighbours, {} substeps",
        scene.particles(),
        scene.neighbours(),
        scene.substeps()
    );
    group
        .sample_size(10)
        .warm_up_time(Duration::from_secs(1))
        .measurement_time(Duration::from_secs(3))
        .throughput(Throughput::Elements(u64::from(scene.particles())))
        .bench_function(BenchmarkId::from_parameter(name), |bencher| {
            bencher.iter_custom(|iterations| {
                let (mut time, mut left) = (Duration::ZERO, iterations);
                while left > 0 {
                    let steps = left.min(STEPS);
                    scene.rewind();
                    scene.step(1);
                    let start = Instant::now();
                    scene.step(steps as u32);
                    time += start.elapsed();
                    left -= steps;
                }
                time
            });
        });
}

criterion_group!(benches, fires, blocks);
criterion_main!(benches);
