//! What solids add to a step of open air: `solids COUNT` takes steps of the default fire beside so
//! many thin lines, for callgrind, which counts inside of `measured`; `solids COUNT ROUNDS` prints
//! how much longer such steps take a particle than without solids, in alternating rounds.

use std::env;
use std::time::Instant;

use hearth_benches::scenes::measured;
use hearth_core::params::{Input, Model, Parameters};
use hearth_core::{Scene, Simulation};

/// The angle between two lines that follow each other around the flame \[rad\], the golden one.
const TURN: f64 = 2.399_963;

/// The default fire with so many thin lines around its flame.
fn fire(count: u32) -> Result<Simulation, String> {
    let mut scene = Scene::new(Parameters::new(Model::Combustion));
    for i in 0..count {
        let share = f64::from(i) / f64::from(count);
        let (sin, cos) = (TURN * f64::from(i)).sin_cos();
        let away = 0.2 + 0.5 * share.sqrt();
        let line = [
            ("kind", Input::Text("solid")),
            ("shape", Input::Text("line")),
            ("x", Input::Number(away * cos)),
            ("y", Input::Number(0.9 + 0.8 * away * sin)),
            ("width", Input::Number(0.1)),
            ("height", Input::Number(0.01)),
            ("angle", Input::Number(50.0 * f64::from(i) % 180.0)),
        ];
        scene.add(&line).map_err(|refused| format!("{refused:?}"))?;
    }
    Ok(Simulation::new(scene))
}

fn burnt(count: u32, seconds: f64) -> Result<Simulation, String> {
    let mut simulation = fire(count)?;
    while simulation.time() < seconds {
        simulation.step();
    }
    Ok(simulation)
}

fn main() -> Result<(), String> {
    let mut numbers = env::args().skip(1).map(|text| text.parse::<u32>());
    let mut next = || {
        numbers
            .next()
            .transpose()
            .map_err(|error| error.to_string())
    };
    let count = next()?.ok_or("how many solids?")?;
    let Some(rounds) = next()? else {
        println!("{}", measured(&mut burnt(count, 1.2)?, 10));
        return Ok(());
    };
    let mut fires = [burnt(count, 2.0)?, burnt(0, 2.0)?];
    let mut ratios = Vec::new();
    for _ in 0..rounds {
        let [with, without] = fires.each_mut().map(|fire| {
            let start = Instant::now();
            let particles = measured(fire, 60);
            start.elapsed().as_secs_f64() / particles as f64
        });
        ratios.push(with / without);
    }
    ratios.sort_by(f64::total_cmp);
    if let (Some(least), Some(most)) = (ratios.first(), ratios.last()) {
        let median = ratios[ratios.len() / 2];
        println!("{count} solids: {median:.2} times as long ({least:.2} to {most:.2})");
    }
    Ok(())
}
