//! What several tests use, and fingerprints of whole runs: the measure behind "same seed, same bits".
//!
//! A run of a thousand steps is folded into one number, over every bit of
//! every particle. Two runs are the same exactly if their fingerprints are,
//! wherever they were made: natively, in Node, in a browser. No fingerprint is
//! written down anywhere; runs are compared with runs, so that better physics
//! needs no new numbers here.

pub mod fires;
#[cfg(not(target_arch = "wasm32"))]
pub mod plain;
pub mod sweep;
pub mod valid;
pub mod validation;

use std::num::NonZero;
use std::sync::{Mutex, PoisonError};
use std::thread;

use hearth_core::params::{Input, PARAMETERS};
use hearth_core::preset::Preset;
use hearth_core::sound::{Mix, Synthesis};
use hearth_core::{IgnitionTarget, Particle, Scene, Simulation, Vec2};

/// Runs each case once, on as many threads as the machine has cores: the last test of a program
/// would leave the others idle. A case that panics fails the test.
pub fn on_all_cores<T: Send>(cases: Vec<T>, run: impl Fn(T) + Sync) {
    let cores = thread::available_parallelism().map_or(1, NonZero::get);
    let cases = Mutex::new(cases.into_iter());
    let next = || cases.lock().unwrap_or_else(PoisonError::into_inner).next();
    thread::scope(|scope| {
        for _ in 0..cores {
            scope.spawn(|| {
                while let Some(case) = next() {
                    run(case);
                }
            });
        }
    });
}

/// Steps in a fingerprinted run: about two seconds of either model, so that particles
/// have been born, have pushed each other, and have died, and the combustion's fire has
/// puffed and embers have died.
pub const STEPS: u32 = 500;

/// Runs a fire of these parameters for [`STEPS`] steps and folds its time and
/// every bit of its particles, in the order of their birth, and of its embers
/// into one number.
pub fn fingerprint(scene: impl Into<Scene>) -> u64 {
    fingerprint_of(Simulation::new(scene), STEPS)
}

/// The same of a fire that may burn already, after so many steps.
fn fingerprint_of(mut simulation: Simulation, steps: u32) -> u64 {
    for _ in 0..steps {
        simulation.step();
    }
    let mut hash = Fnv::new();
    hash.write(&simulation.time().to_bits().to_le_bytes());
    for particle in simulation.particles() {
        let Particle {
            position,
            velocity,
            temperature,
            age,
            lifetime,
            fuel,
            oxygen,
            soot,
        } = particle;
        let motion = [position.x, position.y, velocity.x, velocity.y];
        let rest = [temperature, age, lifetime, fuel, oxygen, soot];
        for number in motion.into_iter().chain(rest) {
            hash.write(&number.to_bits().to_le_bytes());
        }
    }
    let mut embers = Vec::new();
    simulation.write_embers(&mut embers);
    for number in embers.into_iter().flatten() {
        hash.write(&number.to_bits().to_le_bytes());
    }
    hash.finish()
}

/// The fingerprint of every preset, and of fires that take the ways that no
/// preset takes, a line each: for comparison between platforms.
pub fn fingerprints() -> String {
    let presets = Preset::all()
        .iter()
        .map(|preset| (preset.name, preset.scene()));
    let printed = PARAMETERS
        .iter()
        .filter(|param| param.id.starts_with("printed_"))
        .map(|param| (param.id, Input::Flag(true)));
    let others = [
        ("as printed", fires::with(printed)),
        (
            "periodic",
            fires::with([
                ("walls", Input::Text("periodic")),
                ("domain_width", Input::Number(0.4)),
                ("emission_noise", Input::Number(1.0)),
                ("turbulence", Input::Number(3.0)),
            ]),
        ),
        (
            "solid",
            fires::with([
                ("walls", Input::Text("solid")),
                ("domain_width", Input::Number(0.3)),
                ("printed_pressure", Input::Flag(true)),
                ("printed_viscosity", Input::Flag(true)),
            ]),
        ),
        ("few", fires::combustion(&[])),
        (
            "narrow",
            fires::combustion(&[
                ("domain_width", 0.25),
                ("domain_height", 6.0),
                ("vorticity_confinement", 1.0),
                ("wind", -1.0),
            ]),
        ),
        ("everything", fires::everything()),
        ("open", fires::in_the_open(fires::everything(), 1500)),
        (
            "open, few on a floor",
            fires::on_floor(fires::in_the_open(
                fires::combustion(&[("source_height", 0.0), ("wind", -0.7)]),
                400,
            )),
        ),
    ];
    let beside = fires::in_the_open(fires::combustion(&[]), 900);
    let beside = [("outlines", fires::beside_outlines(beside))];
    let falling = fires::on_floor(fires::in_the_open(fires::combustion(&[]), 900));
    let falling = [
        ("free solids", free_solids(falling)),
        ("free solids, closed", free_solids(fires::combustion(&[]))),
        ("classic free solids", free_solids(fires::with([]))),
    ];
    let lit = presets.chain(others).chain(beside).chain(burning_solids());
    let lit = lit.chain(falling);
    let lit = lit.map(|(name, parameters)| (name, fingerprint(parameters)));
    // Taken up as it is, and by fewer particles.
    let kept = [
        ("breaking", breaking()),
        ("hinges", hinged()),
        ("sound", sound()),
        ("kept", kept(FIRESIDE, None)),
        ("kept coarse", kept(FIRESIDE, Some(1200))),
    ];
    let around = [
        ("solids", around_solids(fires::combustion(&[]))),
        (
            "solids in the open",
            around_solids(fires::in_the_open(fires::combustion(&[]), 800)),
        ),
        ("classic solids", around_solids(fires::with([]))),
        ("water", sprayed()),
        ("candle in frames", in_frames("candle")),
        ("classic in frames", in_frames("classic")),
    ];
    lit.chain(kept)
        .chain(around)
        .map(|(name, print)| format!("{name} {print:016x}\n"))
        .collect()
}

/// The fingerprint of a second of a scene in frames, whose last steps are shorter.
fn in_frames(name: &str) -> u64 {
    let mut fire = Simulation::new(Preset::find(name).map(Preset::scene).unwrap_or_default());
    (0..30).for_each(|_| fire.advance(1.0 / 30.0));
    fingerprint_of(fire, 0)
}

/// The fingerprint of the sound of a fire before a wall.
fn sound() -> u64 {
    let scene = Preset::find("fireside").map_or_else(|_| Scene::default(), Preset::scene);
    let half_width = 0.5 * scene.world().domain_width;
    let mut fire = Simulation::new(scene);
    fire.record_series(true);
    for _ in 0..300 {
        fire.step();
    }
    let rate = 48_000.0;
    let mut sound = Synthesis::new(rate, 1, Mix::default());
    sound.push(&fire.read_series(), 1.0, half_width);
    let frames = (sound.ahead() * rate) as usize;
    let (mut left, mut right) = (vec![0.0; frames], vec![0.0; frames]);
    sound.render(&mut left, &mut right);
    let mut hash = Fnv::new();
    for sample in left.iter().chain(&right) {
        hash.write(&sample.to_bits().to_le_bytes());
    }
    hash.finish()
}

/// Fires around a burning solid of each fuel.
fn burning_solids() -> impl Iterator<Item = (&'static str, Scene)> {
    ["wood", "paper", "coal", "wax", "cloth"]
        .into_iter()
        .map(|fuel| {
            let mut scene = fires::in_the_open(fires::combustion(&[("source_height", 0.2)]), 1200);
            let added = scene.add(&[
                ("kind", Input::Text("solid")),
                ("shape", Input::Text("line")),
                ("angle", Input::Number(20.0)),
                ("y", Input::Number(0.5)),
                ("fuel", Input::Text(fuel)),
                ("load", Input::Number(0.6)),
            ]);
            assert!(added.is_ok(), "{added:?}");
            (fuel, scene)
        })
}

/// A fire onto which free solids of several shapes fall, one of which burns.
fn free_solids(mut scene: Scene) -> Scene {
    for (number, shape) in ["circle", "box", "line", "polygon", "box"]
        .into_iter()
        .enumerate()
    {
        let added = scene.add(&[
            ("kind", Input::Text("solid")),
            ("motion", Input::Text("free")),
            ("shape", Input::Text(shape)),
            ("points", Input::Text("0,0.06 -0.05,-0.03 0.05,-0.03")),
            ("width", Input::Number(0.1)),
            ("height", Input::Number(0.05)),
            ("angle", Input::Number(25.0)),
            ("x", Input::Number(0.03 * number as f64)),
            ("y", Input::Number(0.1 + 0.12 * number as f64)),
            ("density", Input::Number(40.0)),
            (
                "fuel",
                Input::Text(if number == 2 { "paper" } else { "none" }),
            ),
            ("load", Input::Number(0.4)),
        ]);
        debug_assert!(added.is_ok(), "{added:?}");
    }
    scene
}

/// The fingerprint of a stick that falls, burns and breaks; 0 if it does not.
fn breaking() -> u64 {
    let unlit = fires::combustion(&[("fuel_power", 0.0)]);
    let mut scene = fires::on_floor(fires::in_the_open(unlit, 900));
    let added = scene.add(&[
        ("kind", Input::Text("solid")),
        ("motion", Input::Text("free")),
        ("shape", Input::Text("box")),
        ("width", Input::Number(0.8)),
        ("height", Input::Number(0.04)),
        ("angle", Input::Number(10.0)),
        ("y", Input::Number(0.8)),
        ("fuel", Input::Text("paper")),
        ("load", Input::Number(0.6)),
    ]);
    let mut fire = Simulation::new(scene);
    let lit = fire.ignite(IgnitionTarget::Place(Vec2::new(0.0, 0.8), 0.07));
    debug_assert!(added.is_ok() && lit.is_ok(), "{added:?} {lit:?}");
    let mut whole = fire.clone();
    for _ in 0..STEPS {
        whole.step();
    }
    match whole.free_solids().len() {
        0 | 1 => 0,
        _ => fingerprint_of(fire, STEPS),
    }
}

/// The fingerprint of a fire whose source and whose burning log are sprayed; 0 if none of the water
/// evaporates, boils off or wets them.
fn sprayed() -> u64 {
    let source = [("source_height", 0.1), ("source_width", 0.3)];
    let mut scene = fires::on_floor(fires::in_the_open(fires::combustion(&source), 900));
    for (x, name, value) in [(-0.25, "fuel", "wood"), (0.3, "thermal", "conducting")] {
        let added = scene.add(&[
            ("kind", Input::Text("solid")),
            ("shape", Input::Text("box")),
            (name, Input::Text(value)),
            ("x", Input::Number(x)),
            ("y", Input::Number(0.2)),
            ("width", Input::Number(0.2)),
            ("temperature", Input::Number(700.0)),
        ]);
        debug_assert!(added.is_ok(), "{added:?}");
    }
    let mut fire = Simulation::new(scene);
    let lit = fire.ignite(IgnitionTarget::Object(2));
    debug_assert_eq!(lit, Ok(()));
    for call in 0..STEPS / 10 {
        let across = 0.01 * (call % 60) as f32 - 0.3;
        let wet = fire.spray(Vec2::new(across, 0.8), Vec2::new(0.3, -2.0), 0.003);
        debug_assert_eq!(wet, Ok(()));
        for _ in 0..10 {
            fire.step();
        }
    }
    let all = fire.sprayed().unwrap_or_default();
    let parts = [
        all.evaporated,
        all.boiled,
        all.soaked,
        all.held,
        all.run_off,
    ];
    match parts.iter().all(|part| *part > 0.0) {
        true => fingerprint_of(fire, STEPS / 10),
        false => 0,
    }
}

/// The fingerprint of a rope that hangs, burns and lets go; 0 if it does not.
fn hinged() -> u64 {
    let unlit = fires::combustion(&[("fuel_power", 0.0)]);
    let mut scene = fires::on_floor(fires::in_the_open(unlit, 900));
    let number = |n: f64| Input::Number(n);
    let hook = [("kind", Input::Text("solid")), ("y", number(1.3))];
    let mut from = scene.add(&hook).unwrap_or_default();
    for link in 0..8 {
        let along = 0.07 * (f64::from(link) + 0.5);
        let added = scene.add(&[
            ("kind", Input::Text("solid")),
            ("motion", Input::Text("free")),
            ("shape", Input::Text("line")),
            ("hangs_from", number(from.into())),
            ("x", number(0.5 * along)),
            ("y", number(1.3 - 0.866 * along)),
            ("angle", number(120.0)),
            ("width", number(0.07)),
            ("height", number(0.03)),
            ("fuel", Input::Text("paper")),
            ("load", number(0.4)),
        ]);
        debug_assert!(added.is_ok(), "{added:?}");
        from = added.unwrap_or_default();
    }
    let mut fire = Simulation::new(scene);
    let lit = fire.ignite(IgnitionTarget::Object(6));
    debug_assert_eq!(lit, Ok(()));
    let mut whole = fire.clone();
    for _ in 0..STEPS {
        whole.step();
    }
    match whole.free_solids().last() {
        Some(last) if last.place.y < 0.6 => fingerprint_of(fire, STEPS),
        _ => 0,
    }
}

/// The fingerprint of a fire around solids of every shape, one of which moves.
fn around_solids(mut scene: Scene) -> u64 {
    for (shape, x) in [("circle", -0.2), ("box", 0.2), ("line", 0.0)] {
        let added = scene.add(&[
            ("kind", Input::Text("solid")),
            ("shape", Input::Text(shape)),
            ("thermal", Input::Text("fixed")),
            ("x", Input::Number(x)),
            ("y", Input::Number(0.6)),
            ("angle", Input::Number(30.0)),
        ]);
        debug_assert!(added.is_ok(), "{added:?}");
    }
    let mut fire = Simulation::new(scene.clone());
    for step in 0..20 {
        let moved = scene.change(3, &[("x", Input::Number(0.2 + 0.005 * f64::from(step)))]);
        debug_assert_eq!(moved, Ok(()));
        fire.set_scene(scene.clone());
        for _ in 0..10 {
            fire.step();
        }
    }
    fingerprint_of(fire, STEPS / 10)
}

/// The scene that is kept burning.
const FIRESIDE: &str = "fireside";

/// The fingerprint of a scene that burns on from where it is kept; 0 where it does not.
fn kept(name: &str, particles: Option<u32>) -> u64 {
    let bytes = include_bytes!("../../web/prewarmed/fireside.fire");
    let mut scene = Preset::find(name).map(Preset::scene).unwrap_or_default();
    if let Some(number) = particles {
        let mut world = scene.world().clone();
        world.set_domain_particles(number);
        scene.set_world(world);
    }
    let mut fire = Simulation::new(scene);
    match fire.restore_burning(bytes) {
        Ok(()) => fingerprint_of(fire, STEPS / 5),
        Err(_) => 0,
    }
}

/// FNV-1a with 64 bits: any bit that differs changes it.
struct Fnv(u64);

impl Fnv {
    fn new() -> Fnv {
        Fnv(0xcbf2_9ce4_8422_2325)
    }

    fn write(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    fn finish(&self) -> u64 {
        self.0
    }
}
