//! Closed, doubly periodic boxes of gas: no burner, no seam, no gravity.

use hearth_core::params::{Edges, IN_DOMAIN, Input};
use hearth_core::random::Random;
use hearth_core::{Particle, Scene, Simulation, Vec2};

use crate::fires;

/// A box of so many columns and rows of particles, `spacing` apart.
#[derive(Clone, Copy, Debug)]
pub(super) struct GasBox {
    pub columns: u32,
    pub rows: u32,
    /// Distance of neighbours on the lattice \[m\].
    pub spacing: f64,
}

impl GasBox {
    pub(super) fn width(&self) -> f64 {
        f64::from(self.columns) * self.spacing
    }

    pub(super) fn height(&self) -> f64 {
        f64::from(self.rows) * self.spacing
    }

    /// The scene of the closed box: nothing acts but pressure, and what
    /// `values` switch on.
    pub(super) fn scene(&self, values: &[(&str, f64)]) -> Scene {
        let closed = [
            ("domain_width", self.width()),
            ("domain_height", self.height()),
            ("particles", f64::from(self.columns * self.rows)),
            ("seam", 0.0),
            ("gravity", 0.0),
            ("fuel_power", 0.0),
            ("ember_rate", 0.0),
            ("radiative_cooling", 0.0),
            ("turbulence", 0.0),
            ("vorticity_confinement", 0.0),
            ("eddy_viscosity", 0.0),
            ("artificial_viscosity", 0.02),
            ("kinematic_viscosity", 0.0),
            ("diffusion", 0.0),
            ("gas_expansion", 0.0),
        ];
        gas("periodic", closed.iter().chain(values).copied())
    }

    /// Its gas at rest on the lattice, each particle moved by up to `jitter`
    /// spacings in x and y, and then given to `shape`.
    pub(super) fn gas(&self, jitter: f64, shape: impl Fn(&mut Particle)) -> Vec<Particle> {
        let mut random = Random::new(3);
        let mut off = |_| f64::from(random.between(-1.0, 1.0)) * jitter;
        let mut gas = Vec::new();
        for row in 0..self.rows {
            for column in 0..self.columns {
                let x = (f64::from(column) + 0.5 + off(())) * self.spacing - 0.5 * self.width();
                let y = (f64::from(row) + 0.5 + off(())) * self.spacing;
                let mut particle = Particle::at(Vec2::new(x as f32, y as f32));
                shape(&mut particle);
                gas.push(particle);
            }
        }
        gas
    }

    /// A simulation of that gas.
    pub(super) fn simulation(&self, values: &[(&str, f64)], gas: &[Particle]) -> Simulation {
        let mut simulation = Simulation::new(self.scene(values));
        fill(&mut simulation, gas);
        simulation
    }
}

/// The defaults of the combustion model in a closed domain, with these values.
///
/// # Panics
/// As [`combustion`].
pub(super) fn closed<'a>(values: impl IntoIterator<Item = (&'a str, f64)>) -> Scene {
    gas("periodic", values)
}

/// The defaults of the combustion model with these values.
///
/// # Panics
/// If a value is invalid, because the case is wrong.
pub(super) fn combustion<'a>(values: impl IntoIterator<Item = (&'a str, f64)>) -> Scene {
    gas("open", values)
}

fn gas<'a>(edges: &str, values: impl IntoIterator<Item = (&'a str, f64)>) -> Scene {
    let model = [
        ("model", Input::Text("combustion")),
        ("edges", Input::Text(edges)),
    ];
    let values: Vec<_> = values.into_iter().collect();
    let numbers = values.iter().map(|&(id, value)| (id, Input::Number(value)));
    let mut scene = fires::with(model.into_iter().chain(numbers));
    let mut world = scene.world().clone();
    world.complete(&|id| values.iter().any(|&(name, _)| name == id), IN_DOMAIN);
    scene.set_world(world);
    scene
}

/// The same in open air, in a frame and with particles of this spacing \[m\].
pub(super) fn open<'a>(
    frame: (f64, f64),
    spacing: f64,
    values: impl IntoIterator<Item = (&'a str, f64)>,
) -> Scene {
    let fixed = [
        ("domain_width", frame.0),
        ("domain_height", frame.1),
        ("spacing", spacing),
        // More than any case needs.
        ("max_particles", 20_000.0),
    ];
    combustion(fixed.into_iter().chain(values))
}

/// The same on a floor.
pub(super) fn on_floor(mut scene: Scene) -> Scene {
    set(&mut scene, "floor", "solid");
    scene
}

fn set(scene: &mut Scene, id: &str, choice: &str) {
    if let Err(refusal) = scene.set(id, choice) {
        panic!("{refusal}");
    }
}

/// Mass of a particle [kg/m].
pub fn mass(fire: &Simulation) -> f64 {
    let p = fire.parameters();
    let area = match p.edges {
        Edges::Open => f64::from(p.spacing()).powi(2),
        Edges::Periodic => f64::from(p.domain_width * p.domain_height) / fire.count() as f64,
    };
    f64::from(p.ambient_density) * area
}

/// Puts `gas` into `simulation`.
///
/// # Panics
/// Where a particle is refused: the case that made it is wrong.
pub(super) fn fill(simulation: &mut Simulation, gas: &[Particle]) {
    if let Err(refusal) = simulation.set_particles(gas) {
        panic!("{refusal}");
    }
}

/// Most steps of a run: far more than any case needs, so that a run whose
/// steps shrink to nothing ends, and its row fails, rather than never.
const MOST_STEPS: u32 = 3_000_000;

/// Calls `step`, which must make a step, until `until` \[s\]; whether it came
/// there with a finite flow.
pub(super) fn run(
    simulation: &mut Simulation,
    until: f64,
    mut step: impl FnMut(&mut Simulation),
) -> bool {
    for _ in 0..MOST_STEPS {
        if simulation.time() >= until {
            return true;
        }
        step(simulation);
        if !simulation.report().max_speed.is_finite() {
            return false;
        }
    }
    false
}

/// `v` in double precision.
pub(super) fn wide(v: Vec2) -> (f64, f64) {
    (f64::from(v.x), f64::from(v.y))
}
