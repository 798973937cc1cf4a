//! Heat spreads by the law of Fourier.

use hearth_core::Simulation;

use super::boxes::{GasBox, run};
use super::{Case, Expected, Outcome, Pace, Row};

pub(super) const CASES: &[Case] = &[Case {
    name: "heat",
    pace: Pace::Quick,
    run: heat,
}];

const DIFFUSIVITY: f64 = 0.01;

/// Variance of heat along an axis over that of the exact solution, for a bell
/// of temperature that spreads: σ² = σ₀² + 2Dt.
fn spread(jitter: f64) -> f64 {
    let gas_box = GasBox {
        columns: 64,
        rows: 64,
        spacing: 1.0 / 64.0,
    };
    const STARTED: f64 = 0.06;
    let middle = 0.5 * gas_box.height();
    let square = |x: f32, y: f32| f64::from(x).powi(2) + (f64::from(y) - middle).powi(2);
    let gas = gas_box.gas(jitter, |particle| {
        let r2 = square(particle.position.x, particle.position.y);
        particle.temperature = (293.0 + 1000.0 * (-0.5 * r2 / STARTED.powi(2)).exp()) as f32;
    });
    let values = [
        ("stiffness", 4.0),
        ("diffusion", DIFFUSIVITY),
        ("ambient_temperature", 293.0),
    ];
    let mut fire = gas_box.simulation(&values, &gas);
    let came = run(&mut fire, 0.3, Simulation::step);
    let (mut heat, mut moment) = (0.0, 0.0);
    let state = fire.positions().into_iter().zip(fire.temperatures());
    for ((position, temperature), density) in state.zip(fire.densities()) {
        let share = (f64::from(temperature) - 293.0) / f64::from(density);
        heat += share;
        moment += share * square(position.x, position.y);
    }
    if !came {
        return f64::NAN;
    }
    0.5 * moment / heat / (STARTED.powi(2) + 2.0 * DIFFUSIVITY * fire.time())
}

fn heat() -> Outcome {
    let row = |id, what: &str, jitter, tolerance| {
        let expected = Expected::Value {
            value: 1.0,
            tolerance,
        };
        Row::new(id, what, expected, spread(jitter))
    };
    Outcome::rows([
        row(
            "heat-lattice",
            "bell of heat on a lattice, σ² / (σ₀² + 2Dt)",
            0.0,
            0.01,
        ),
        row(
            "heat-jittered",
            "bell of heat, particles off the lattice by up to 0.2 dx",
            0.2,
            0.03,
        ),
    ])
}
