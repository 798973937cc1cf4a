//! The stability of a fire at the corners of the parameter ranges.
//!
//! A corner has every parameter that moves particles at one end of its range.
//! There the fire stays finite, stays inside, and is not clamped by a
//! guard; back at the defaults it recovers. `tests/tests/corners.rs` tests this with a
//! sample of corners, `cargo measure soak` of hundreds. It visits [crowds](crowd) of solids and
//! [heaps](heap) of burning bodies too.

pub mod crowd;
pub mod heap;

use std::fmt::Write as _;

use hearth_core::params::{
    Choice, Edges, Floor, Input, Kind, Model, PARAMETERS, Param, Role, Walls,
};
use hearth_core::random::Random;
use hearth_core::{Particle, Scene, Simulation, Vec2};

use crate::fires;

/// Share of all steps of all particles that a guard may hold.
pub const MAX_CLAMPED: f64 = 0.05;

/// Simulated time after which a fire that was driven to a corner burns as ever
/// again \[s\]: in the classic model the longest life there is, in the combustion
/// model the time in which gas rises through the domain twice.
const fn recovery(model: Model) -> f64 {
    match model {
        Model::Classic => 3.0,
        Model::Combustion => 1.5,
    }
}

/// Time for which it is looked at then \[s\].
const LOOKED_AT: f64 = 1.0;

/// Most steps of a simulated second. The stiffest corner needs half as many: who
/// needs more has steps that shrink to nothing.
const MOST_STEPS: f64 = 200_000.0;

/// Particles of a corner, from and to: enough for every neighbourhood that
/// there is, and few enough for a test.
pub const PARTICLES: (f64, f64) = (1000.0, 1500.0);

/// Spacings of a corner \[m\], from and to.
const SPACINGS: (f64, f64) = (0.03, 0.08);

/// Whether a parameter affects only how a fire is shown or how fast it is played.
pub fn is_shown_only(param: &Param) -> bool {
    param.role != Role::Physics
}

/// The parameters of `model` that move particles and have a range, without those
/// that affect only how the result is shown or how fast it is played, and without
/// the classic model's speed limit, whose own corner is the stricter the lower
/// it is.
pub fn swept(model: Model) -> impl Iterator<Item = &'static Param> {
    PARAMETERS
        .iter()
        .filter(move |p| p.domain(model).is_some())
        .filter(|p| matches!(p.kind, Kind::Number(_) | Kind::Integer(_)))
        .filter(|p| !is_shown_only(p) && p.id != "speed_limit")
}

/// One end of a parameter's range, with as many particles as a test can have.
pub fn end(model: Model, param: &Param, upper: bool) -> f64 {
    let (min, max) = param.any_domain(model).range;
    let end = if upper { max } else { min };
    if ["particles", "max_particles"].contains(&param.id) {
        end.min(if upper { PARTICLES.1 } else { PARTICLES.0 })
    } else if param.id == "spacing" {
        if upper { SPACINGS.1 } else { SPACINGS.0 }
    } else {
        end
    }
}

/// The model's defaults in a closed domain.
fn closed(model: Model) -> Scene {
    let mut scene = Scene::of_model(model);
    fires::set_in_model(&mut scene, "edges", "periodic");
    scene
}

/// The model's defaults with fewer particles in the combustion model and a
/// closed domain, so that it is quick.
pub fn usual(model: Model) -> Scene {
    let mut scene = closed(model);
    let min = Input::Number(PARTICLES.0);
    let number = match model {
        Model::Classic => "max_particles",
        Model::Combustion => "particles",
    };
    set(&mut scene, number, min);
    scene
}

/// The defaults with one slider at its end.
pub fn at_end(model: Model, param: &Param, upper: bool) -> Scene {
    let mut scene = usual(model);
    let end = end(model, param, upper);
    set(&mut scene, param.id, Input::Number(end));
    scene
}

/// Each slider at one of its ends, in a closed domain.
pub fn corner(model: Model, random: &mut Random) -> Scene {
    let mut scene = closed(model);
    for param in swept(model) {
        let end = end(model, param, random.bits() & 1 == 1);
        set(&mut scene, param.id, Input::Number(end));
    }
    if model == Model::Classic {
        let walls = Walls::NAMES[random.bits() as usize % Walls::NAMES.len()];
        set(&mut scene, "walls", Input::Text(walls));
    }
    let seed = f64::from(random.bits());
    set(&mut scene, "seed", Input::Number(seed));
    scene
}

/// A corner of the combustion model in the open, in the air or on a floor.
pub fn open_corner(random: &mut Random) -> Scene {
    let mut scene = corner(Model::Combustion, random);
    let floor = Floor::NAMES[random.bits() as usize % Floor::NAMES.len()];
    set(&mut scene, "floor", Input::Text(floor));
    set(&mut scene, "edges", Input::Text("open"));
    scene
}

/// Every value that is not the default, as one line.
pub fn described(scene: &Scene) -> String {
    let mut text = format!("{:?}", scene.model());
    for param in PARAMETERS {
        let (value, domain) = (scene.value(param), param.domain(scene.model()));
        if domain.is_some_and(|domain| domain.default != value) {
            let _ = write!(text, " {}={value}", param.id);
        }
    }
    text
}

fn set(scene: &mut Scene, id: &str, input: Input<'_>) {
    if let Err(refusal) = scene.set(id, input) {
        panic!("{refusal}");
    }
}

/// The outcome of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outcome {
    /// Share of particles and steps that a limit clamped.
    pub clamped: f64,
    /// The part of it that is due to the speed limit.
    pub speed_limited: f64,
    /// Work that it took, in steps of particles.
    pub work: f64,
    /// Mean power of the combustion [kW/m], after the first tenth of the time, in which it is lit.
    pub power: f64,
    /// The largest share that is no fault.
    pub allowed: f64,
    /// What broke, if anything did.
    pub broken: Option<String>,
}

impl Outcome {
    /// What is wrong, if anything is.
    pub fn fault(&self) -> Option<String> {
        let [all, speed] = [self.clamped, self.speed_limited].map(|share| 100.0 * share);
        let clamped =
            || format!("guards hold {all:.1} % of the particles, that of speed {speed:.1} %");
        self.broken
            .clone()
            .or_else(|| (self.clamped >= self.allowed).then(clamped))
    }
}

/// Burns `seconds` at these values, then returns to the defaults and looks
/// whether it recovers.
pub fn there_and_back(scene: &Scene, seconds: f64) -> Outcome {
    let model = scene.model();
    let mut fire = Simulation::new(scene.clone());
    let mut outcome = burn(&mut fire, seconds);
    if outcome.broken.is_none() {
        let mut usual = usual(model);
        if model == Model::Combustion && scene.world().edges == Edges::Open {
            usual = fires::in_the_open(usual, 1500);
        }
        fire.set_scene(usual);
        outcome.broken = recovers(&mut fire).map(|fault| format!("afterwards, {fault}"));
    }
    outcome
}

/// Simulates for a time and checks the fire.
pub fn burn(fire: &mut Simulation, seconds: f64) -> Outcome {
    watched(fire, seconds, &mut |_| None)
}

/// Simulates for a time and checks the fire. `after_step` returns what else is wrong.
pub fn watched(
    fire: &mut Simulation,
    seconds: f64,
    after_step: &mut dyn FnMut(&mut Simulation) -> Option<String>,
) -> Outcome {
    let until = fire.time() + seconds;
    let (mut steps, mut clamped, mut speed_limited, mut moved) = (0_u32, 0.0, 0.0, 0.0);
    let mut work = 0.0;
    let (lit, mut energy) = (fire.time() + 0.1 * seconds, 0.0);
    let mut broken = None;
    while fire.time() < until && broken.is_none() {
        fire.step();
        steps += 1;
        let report = fire.report();
        clamped += f64::from(report.clamped);
        speed_limited += f64::from(report.speed_limited);
        moved += fire.count() as f64;
        // The classic model divides a step.
        work += fire.count() as f64 * f64::from(report.substeps);
        if fire.time() > lit {
            energy += f64::from(report.power.unwrap_or_default()) * f64::from(report.length);
        }
        broken = after_step(fire);
        if steps.is_multiple_of(256) {
            broken = broken.or_else(|| fault(fire));
        }
        if f64::from(steps) > MOST_STEPS * seconds {
            broken = Some(format!("steps have shrunk to {} s", report.length));
        }
    }
    let moved = f64::max(moved, 1.0);
    Outcome {
        clamped: clamped / moved,
        speed_limited: speed_limited / moved,
        work,
        power: energy / (0.9 * seconds),
        allowed: MAX_CLAMPED,
        broken: broken.or_else(|| fault(fire)),
    }
}

/// What is wrong with the fire as it is now.
fn fault(fire: &Simulation) -> Option<String> {
    let [low, high] = fire.extent();
    let inside = |at: Vec2| at.cmpge(low).all() && at.cmple(high).all();
    for particle in fire.particles() {
        let [x, y] = particle.velocity.to_array();
        let Particle {
            temperature,
            fuel,
            oxygen,
            soot,
            ..
        } = particle;
        let numbers = [x, y, temperature, fuel, oxygen, soot];
        let share = -1e-6..=1.0 + 1e-6;
        let valid = temperature > 0.0
            && soot >= 0.0
            && share.contains(&fuel)
            && share.contains(&oxygen)
            && numbers.iter().all(|number| number.is_finite());
        // A position that is no number is not inside.
        if !valid || !inside(particle.position) {
            return Some(format!("there is {particle:?}"));
        }
    }
    for ember in fire.embers() {
        let [x, y] = ember.velocity.to_array();
        let valid = [x, y, ember.temperature].iter().all(|n| n.is_finite());
        if !valid || !inside(ember.position) {
            return Some(format!("there is {ember:?}"));
        }
    }
    let report = fire.report();
    let power = report.power.unwrap_or_default();
    let valid = power.is_finite() && power >= 0.0 && fire.time().is_finite();
    (!valid).then(|| format!("there is {report:?}"))
}

/// What is wrong with a fire that has the defaults again, a while later.
fn recovers(fire: &mut Simulation) -> Option<String> {
    let model = fire.parameters().model();
    if let Some(fault) = burn(fire, recovery(model)).broken {
        return Some(fault);
    }
    let from = fire.time();
    let (mut energy, mut particle_seconds, mut clamped) = (0.0, 0.0, 0);
    while fire.time() < from + LOOKED_AT {
        let before = fire.time();
        fire.step();
        let length = fire.time() - before;
        energy += f64::from(fire.report().power.unwrap_or_default()) * length;
        particle_seconds += fire.count() as f64 * length;
        clamped += fire.report().clamped;
    }
    if let Some(fault) = fault(fire) {
        return Some(fault);
    }
    if clamped > 0 {
        return Some(format!("limits still clamp particles, {clamped} times"));
    }
    let (power, count) = (energy / LOOKED_AT, particle_seconds / LOOKED_AT);
    let nominal = f64::from(fire.scene().power());
    match model {
        // What the paper's test calls the default's number of particles.
        Model::Classic => (!(700.0..=1000.0).contains(&count))
            .then(|| format!("there are {count:.0} particles, which is not usual")),
        Model::Combustion => ((power / nominal - 1.0).abs() > 0.25)
            .then(|| format!("{power:.0} kW/m burn where {nominal:.0} are fed")),
    }
}
