//! Unstable interfaces grow at the rates of linear theory.

use std::f64::consts::TAU;

use hearth_core::{Particle, Simulation, Vec2};

use super::boxes::{closed, fill, run, wide};
use super::plot::{Plot, Series};
use super::{Case, Expected, Outcome, Pace, Row};

pub(super) const CASES: &[Case] = &[
    Case {
        name: "rayleigh-taylor",
        pace: Pace::Long(15),
        run: rayleigh_taylor,
    },
    Case {
        name: "kelvin-helmholtz",
        pace: Pace::Long(15),
        run: kelvin_helmholtz,
    },
];

/// Columns and rows of the cold upper half and of the hot lower half, both on
/// square lattices of the same mass.
const COLD: (u32, u32) = (96, 48);
const HOT: (u32, u32) = (68, 34);

/// Ambient temperature \[K\]: one half is colder, the other hotter, so that
/// together they fill the box as air would, without a pressure of its own.
const AMBIENT: f64 = 293.0;

/// Wave number of the disturbance: one wave across the box [1/m].
const K: f64 = TAU;

/// Speed of the disturbance at first [m/s].
const DISTURBANCE: f64 = 0.05;

/// Two layers of an ideal gas in a box of 1 m × 1 m: hot below, cold above,
/// at one pressure, so that densities are as the numbers of particles.
struct Layers {
    fire: Simulation,
    cold_density: f64,
    hot_density: f64,
}

/// The layers with these velocities along x of the hot and of the cold
/// one, and a disturbance of their interface that dies away from it
/// as a potential flow does.
fn layers(hot_speed: f64, cold_speed: f64, values: &[(&str, f64)]) -> Layers {
    let (cold, hot) = (COLD.0 * COLD.1, HOT.0 * HOT.1);
    let total = cold + hot;
    let rest = |n: u32| AMBIENT * f64::from(total) / (2.0 * f64::from(n));
    let mut gas = Vec::new();
    let mut lay = |(columns, rows): (u32, u32), bottom: f64, temperature: f64, speed: f64| {
        for row in 0..rows {
            for column in 0..columns {
                let x = (f64::from(column) + 0.5) / f64::from(columns) - 0.5;
                let y = bottom + 0.5 * (f64::from(row) + 0.5) / f64::from(rows);
                let near = DISTURBANCE * (-K * (y - 0.5).abs()).exp();
                let side = if y < 0.5 { -near } else { near };
                let along = side * (K * x).sin();
                let mut particle = Particle::at(Vec2::new(x as f32, y as f32));
                particle.velocity =
                    Vec2::new((speed + along) as f32, (near * (K * x).cos()) as f32);
                particle.temperature = temperature as f32;
                gas.push(particle);
            }
        }
    };
    lay(HOT, 0.0, rest(hot), hot_speed);
    lay(COLD, 0.5, rest(cold), cold_speed);

    let alone = [
        ("domain_width", 1.0),
        ("domain_height", 1.0),
        ("particles", f64::from(total)),
        // Wide enough that the thinner gas has its neighbours as well.
        ("smoothing_ratio", 1.8),
        ("ambient_temperature", AMBIENT),
        ("ambient_density", 1.0),
        ("gas_expansion", 1.0),
        ("stiffness", 8.0),
        // Without a seam nothing would be lifted; this one is thinner than a
        // particle, and lies where the layers are stable.
        ("seam", 0.003),
        ("fuel_power", 0.0),
        ("ember_rate", 0.0),
        ("radiative_cooling", 0.0),
        ("eddy_viscosity", 0.0),
        ("artificial_viscosity", 0.02),
        ("kinematic_viscosity", 0.0),
        ("diffusion", 0.0),
    ];
    let mut fire = Simulation::new(closed(alone.iter().chain(values).copied()));
    fill(&mut fire, &gas);
    Layers {
        fire,
        cold_density: 2.0 * f64::from(cold) / f64::from(total),
        hot_density: 2.0 * f64::from(hot) / f64::from(total),
    }
}

/// How far the interface is from flat \[m\]: the wave of the area that the
/// hot gas has up to it. Where that is counted from does not matter, as gas
/// fills its place; it begins softly, since rows of particles are coarse.
fn displacement(fire: &Simulation) -> f64 {
    let mass = f64::from(fire.parameters().ambient_density) / fire.count() as f64;
    let (mut re, mut im) = (0.0, 0.0);
    let state = fire.positions().into_iter().zip(fire.temperatures());
    for ((position, temperature), density) in state.zip(fire.densities()) {
        let (x, y) = wide(position);
        if f64::from(temperature) > AMBIENT && y < 0.75 {
            let counted = ((y - 0.1) / 0.3).clamp(0.0, 1.0);
            let counted = counted * counted * (3.0 - 2.0 * counted);
            let area = counted * mass / f64::from(density);
            re += area * (K * x).cos();
            im += area * (K * x).sin();
        }
    }
    2.0 * f64::hypot(re, im)
}

/// Where linear theory has the interface that was flat and moving at first.
fn linear(rate: f64, time: f64) -> f64 {
    DISTURBANCE / rate * (rate * time).sinh()
}

/// The rate at which linear theory comes to that place at that time.
fn rate_of(place: f64, time: f64) -> f64 {
    let (mut low, mut high) = (1e-6, 20.0 / time);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if linear(middle, time) < place {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// Lets the disturbance grow until it is no longer small, and compares the
/// rate with that of theory.
fn growth(mut layers: Layers, rate: f64, id: &str, what: &str, law: &str) -> Outcome {
    // A slope of a quarter: what linear theory leaves out is its square.
    const SMALL: f64 = 0.04;
    let end = (SMALL * rate / DISTURBANCE).asinh() / rate;
    let mut course = Vec::new();
    run(&mut layers.fire, 2.0 * end, |fire| {
        fire.step();
        course.push((fire.time(), displacement(fire)));
    });
    let reached = course.iter().copied().find(|(_, place)| *place > SMALL);
    let measured = reached.map_or(f64::NAN, |(time, place)| rate_of(place, time));
    let theory = (1..=40).map(|i| f64::from(i) / 40.0 * end);
    let shown = course.iter().copied().filter(|(_, place)| *place > 5e-4);
    let plot = Plot::new(id, what, "t [s]", "displacement of the interface [m]")
        .logarithmic_y()
        .showing(Series::line(law, theory.map(|t| (t, linear(rate, t)))))
        .showing(Series::dots(
            "measured",
            shown.take_while(|p| p.1 < 2.0 * SMALL),
        ));
    Outcome::rows([Row::new(
        id,
        format!("{what}: rate of growth / {law}"),
        Expected::Value {
            value: 1.0,
            tolerance: 0.25,
        },
        measured / rate,
    )
    .noting(format!(
        "densities {:.2} : {:.2}, {rate:.2}/s without viscosity",
        layers.cold_density, layers.hot_density
    ))])
    .with(plot)
}

/// Cold gas over hot gas, driven by the solver's own buoyancy, which for the
/// ideal gas is gravity less what holds up the whole box.
fn rayleigh_taylor() -> Outcome {
    const GRAVITY: f64 = 9.81;
    let layers = layers(0.0, 0.0, &[("gravity", GRAVITY), ("buoyancy", 1.0)]);
    let (cold, hot) = (layers.cold_density, layers.hot_density);
    let atwood = (cold - hot) / (cold + hot);
    let rate = (atwood * GRAVITY * K).sqrt();
    growth(layers, rate, "rayleigh-taylor", "Rayleigh–Taylor", "√(Agk)")
}

/// The two halves slide along each other.
fn kelvin_helmholtz() -> Outcome {
    const SPEED: f64 = 1.0;
    let layers = layers(-0.5 * SPEED, 0.5 * SPEED, &[("gravity", 0.0)]);
    let (cold, hot) = (layers.cold_density, layers.hot_density);
    let rate = K * SPEED * (cold * hot).sqrt() / (cold + hot);
    growth(
        layers,
        rate,
        "kelvin-helmholtz",
        "Kelvin–Helmholtz",
        "kΔU√(ρ₁ρ₂)/(ρ₁+ρ₂)",
    )
}
