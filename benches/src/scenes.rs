//! The measured fires.

use hearth_core::params::{Input, Model};
use hearth_core::{IgnitionTarget, Particle, Scene, Simulation, Vec2};

/// Smoothing length of a block [m]: as large as lets 400,000 particles fit the
/// widest domain.
pub const SMOOTHING: f64 = 0.012;

/// Density of a block [kg/m³], the largest one, because particles have a minimum mass.
pub const REST_DENSITY: f64 = 2.0;

/// Length of a block's step \[s\], short enough for a single substep.
pub const TIME_STEP: f64 = 1.0 / 480.0;

/// Viscosity of a block [Pa·s].
pub const VISCOSITY: f64 = 0.001;

/// Neighbours of a particle inside a block within 2h, as in the benchmarks of other solvers.
pub const NEIGHBOURS: f64 = 20.0;

/// Bodies of a row, and the time after which they have fallen and burn \[s\].
const COLUMNS: usize = 5;
const FALLEN: f64 = 0.4;

/// Space around a block, in distances between its particles: it expands slightly, and no
/// particle may leave the domain.
const MARGIN: f64 = 6.0;

/// A block of `count` particles at rest, without a source and without gravity,
/// with `neighbours` neighbours per particle: the cost of a step of the classic model.
///
/// # Errors
/// A number of particles out of range.
pub fn block(count: u32, neighbours: f64) -> Result<Simulation, String> {
    let spacing = spacing(neighbours);
    let columns = f64::from(count).sqrt().ceil();
    let side = (columns + 2.0 * MARGIN) * spacing;
    let mut simulation = Simulation::new(with(
        Model::Classic,
        &[
            ("domain_width", side),
            ("domain_height", side),
            ("smoothing_radius", SMOOTHING),
            ("rest_density", REST_DENSITY),
            ("particle_mass", REST_DENSITY * spacing * spacing),
            ("viscosity", VISCOSITY),
            ("gravity", 0.0),
            ("time_step", TIME_STEP),
            ("max_particles", 100.0),
        ],
    )?);
    let particles: Vec<Particle> = (0..count)
        .map(|i| at_rest(i, columns as u32, spacing as f32))
        .collect();
    simulation
        .set_particles(&particles)
        .map_err(|refused| refused.to_string())?;
    // One step, for a report and to grow every buffer.
    simulation.step();
    Ok(simulation)
}

/// Distance between the particles of a block \[m\] with so many neighbours each.
fn spacing(neighbours: f64) -> f64 {
    2.0 * SMOOTHING * (std::f64::consts::PI / (neighbours + 1.0)).sqrt()
}

/// A fire of the classic model that burns with up to `count` particles, with
/// gravity, births and deaths: from a source so wide and over a domain so large
/// that they find room.
///
/// # Errors
/// A number of particles outside the range of `max_particles`.
pub fn plume(count: u32) -> Result<Simulation, String> {
    let scene = with(
        Model::Classic,
        &[
            ("max_particles", f64::from(count)),
            ("emission_rate", 100_000.0),
            ("emission_speed", 2.0),
            ("domain_width", 4.0),
            ("domain_height", 6.0),
            ("lifetime_min", 1.0),
            ("lifetime_max", 3.0),
            ("source_width", 0.6),
            ("particle_mass", 1e-4),
            ("rest_density", REST_DENSITY),
            ("smoothing_radius", SMOOTHING),
        ],
    )?;
    Ok(burnt(scene, 3.0))
}

/// A fire of the combustion model that fills its domain with about so many
/// particles, after three seconds, in its steady state.
///
/// # Errors
/// A value outside its range.
pub fn combustion(particles: u32, stiffness: f64) -> Result<Simulation, String> {
    combustion_after(3.0, particles, stiffness)
}

/// As [`combustion`], after `seconds`.
///
/// # Errors
/// A value outside its range.
pub fn combustion_after(
    seconds: f64,
    particles: u32,
    stiffness: f64,
) -> Result<Simulation, String> {
    let values = [
        ("particles", f64::from(particles)),
        ("stiffness", stiffness),
    ];
    let mut scene = with(Model::Combustion, &values)?;
    let mut world = scene.world().clone();
    world.complete(&|id| id == "particles", particles);
    scene.set_world(world);
    Ok(burnt(scene, seconds))
}

/// The default fire on a floor with so many free bodies of wood, paper, coal, wax and cloth in it,
/// which have fallen and burn.
///
/// # Errors
/// A value outside its range.
pub fn bodies(count: u32) -> Result<Simulation, String> {
    let mut scene = with(Model::Combustion, &[])?;
    for (id, choice) in [("edges", "open"), ("floor", "solid")] {
        let set = scene.set(id, choice);
        set.map_err(|refused| refused.to_string())?;
    }
    for number in 0..count as usize {
        let row = number / COLUMNS;
        let side = (number % COLUMNS) as f64 - 0.5 * (COLUMNS as f64 - 1.0);
        let added = scene.add(&[
            ("kind", Input::Text("solid")),
            ("motion", Input::Text("free")),
            (
                "shape",
                Input::Text(["box", "circle", "polygon", "line"][number % 4]),
            ),
            (
                "fuel",
                Input::Text(["wood", "paper", "coal", "wax", "cloth"][number % 5]),
            ),
            ("points", Input::Text("0,0.06 -0.05,-0.03 0.05,-0.03")),
            ("x", Input::Number(0.16 * side + 0.03 * row as f64)),
            ("y", Input::Number(0.06 + 0.11 * row as f64)),
            ("angle", Input::Number(17.0 * number as f64)),
            ("width", Input::Number(0.12)),
            ("height", Input::Number(0.08)),
        ]);
        added.map_err(|refused| format!("{refused:?}"))?;
    }
    let mut fire = Simulation::new(scene);
    if count > 0 {
        let all = IgnitionTarget::Place(Vec2::new(0.0, 0.3), 1.0);
        fire.ignite(all).map_err(|_| "nothing burns".to_owned())?;
    }
    while fire.time() < FALLEN {
        fire.step();
    }
    Ok(fire)
}

/// The default fire of the classic model after `seconds`.
pub fn classic_after(seconds: f64) -> Simulation {
    burnt(Scene::of_model(Model::Classic), seconds)
}

fn burnt(scene: Scene, seconds: f64) -> Simulation {
    let mut simulation = Simulation::new(scene);
    while simulation.time() < seconds {
        simulation.step();
    }
    simulation
}

/// A model's defaults with some values changed.
fn with(model: Model, values: &[(&str, f64)]) -> Result<Scene, String> {
    let mut scene = Scene::of_model(model);
    for &(id, value) in values {
        scene
            .set(id, value)
            .map_err(|refused| refused.to_string())?;
    }
    Ok(scene)
}

/// One of a block's particles, slightly off its place on the lattice: on an
/// exact lattice, distances at the kernel's edge would make the count of
/// neighbours a matter of rounding.
fn at_rest(index: u32, columns: u32, spacing: f32) -> Particle {
    let jitter = |salt: u32| {
        let mixed = (index ^ salt).wrapping_mul(0x9e37_79b9);
        ((mixed ^ (mixed >> 15)) >> 8) as f32 / 16_777_216.0 - 0.5
    };
    let column = (index % columns) as f32 + 0.2 * jitter(0x51);
    let row = (index / columns) as f32 + MARGIN as f32 + 0.2 * jitter(0xa7);
    let half = 0.5 * (columns as f32 - 1.0);
    Particle {
        temperature: 1000.0,
        lifetime: 1e6,
        ..Particle::at([(column - half) * spacing, row * spacing].into())
    }
}

/// A case whose instructions are counted, and how many steps of it. What comes before them is short, because what
/// counts is slow.
///
/// # Errors
/// There is no such case.
pub fn counted(name: &str) -> Result<(Simulation, u32), String> {
    match name {
        "classic block" => Ok((block(5000, NEIGHBOURS)?, 20)),
        "classic plume" => Ok((classic_after(1.0), 40)),
        "combustion" => Ok((combustion_after(0.3, 3000, 6.0)?, 10)),
        "high" => Ok((combustion_after(0.05, 12_000, 6.0)?, 4)),
        "bodies" => Ok((bodies(20)?, 20)),
        // The same fire without them, to compare by hand.
        "no bodies" => Ok((bodies(0)?, 20)),
        _ => Err(format!("there is no case \"{name}\"")),
    }
}

/// The cases whose instructions in wasm are counted, by their numbers.
pub const IN_WASM: [&str; 3] = ["classic block", "combustion", "high"];

/// Makes the steps that are measured, under a name that callgrind finds. Returns over how many particles they
/// went.
#[inline(never)]
pub fn measured(simulation: &mut Simulation, steps: u32) -> u64 {
    let mut particles = 0;
    for _ in 0..steps {
        simulation.step();
        particles += simulation.count() as u64;
    }
    particles
}
