//! The fast solver does what the plain one does, within rounding.
//!
//! Random scenes of both models are stepped by both. The domains are often
//! but a few kernels wide; particles crowd, lie in the same place, on the edges, in
//! the corners and on the borders of the grid's cells.

mod scenes;

use std::fmt::Debug;

use glam::DVec2;
use hearth_core::params::{Input, Model};
use hearth_core::random::Random;
use hearth_core::{Parameters, Particle, Scene, Simulation, Vec2};
use hearth_tests::plain::{Classic, Combustion, Crowd, PARTS, Plain, Sum};

use scenes::{Case, Spread, case, classic, combustion, corner};

/// Rounding between two searches for neighbours, as a share of the terms that a figure is the sum
/// of. A number in single precision is exact to 6e-8, a sum of fifty pairs to 1e-6.
const ROUNDING: f64 = 3e-6;
/// Rounding of an offset, as a share of the domain: of two places, each of which may
/// have been scaled and moved beyond an edge, and a number is exact to 6e-8.
const PLACING: f64 = 2.5e-7;
/// After more searches than this nothing would be left to compare.
const MOST_SEARCHES: u32 = 40;

/// What rounding may come to after so many searches. Places are as exact as so large
/// a domain lets them be, and each step makes more of what the ones before it left: ten
/// leave twenty times as much as one, thirty a hundred times, so the square is on
/// the safe side.
fn allowed(searches: u32, parameters: &Parameters) -> f64 {
    let largest = parameters.domain_width.max(parameters.domain_height);
    let placing = PLACING * f64::from(largest / parameters.smoothing_length());
    (ROUNDING + placing) * f64::from(searches).powi(2)
}

/// A plain solver of either model.
enum Oracle {
    Classic(Classic),
    Combustion(Combustion),
}

impl Oracle {
    fn new(case: &Case) -> Oracle {
        match case.scene.model() {
            Model::Classic => Oracle::Classic(Classic::new(&case.particles)),
            Model::Combustion => Oracle::Combustion(Combustion::new(&case.particles)),
        }
    }

    fn step(&mut self, scene: &Scene) {
        match self {
            Oracle::Classic(classic) => classic.step(scene.world()),
            Oracle::Combustion(gas) => gas.step(scene),
        }
    }

    /// Into how many parts it divided the last step.
    fn parts(&self) -> u32 {
        match self {
            Oracle::Classic(classic) => classic.substeps,
            Oracle::Combustion(_) => PARTS,
        }
    }

    /// How often it searched for neighbours in the last step.
    fn searches(&self) -> u32 {
        match self {
            Oracle::Classic(classic) => classic.substeps,
            Oracle::Combustion(_) => 1,
        }
    }

    fn particles(&self) -> &[Plain] {
        match self {
            Oracle::Classic(classic) => &classic.particles,
            Oracle::Combustion(gas) => &gas.particles,
        }
    }

    fn crowd(&self) -> &Crowd {
        match self {
            Oracle::Classic(classic) => &classic.crowd,
            Oracle::Combustion(gas) => &gas.crowd,
        }
    }

    fn take_over(&mut self, particles: &[Particle]) {
        match self {
            Oracle::Classic(classic) => classic.take_over(particles),
            Oracle::Combustion(gas) => gas.take_over(particles),
        }
    }
}

/// What the fast solver and the plain one differ by, against what is allowed.
struct Difference<'a> {
    scene: &'a str,
    step: u32,
    /// Searches for neighbours since both were the same.
    searches: u32,
    allowed: f64,
}

impl Difference<'_> {
    /// Compares all that can be read out of the fire.
    fn look(&self, fire: &Simulation, oracle: &Oracle) {
        let plain = oracle.particles();
        let p = fire.parameters();
        assert_eq!(fire.count(), plain.len(), "{}", self.scene);
        // A place beyond an edge counts from the other edge.
        let size = DVec2::new(p.domain_width.into(), p.domain_height.into());
        let turn = |off: DVec2| {
            let up = p.model() == Model::Combustion;
            let turns = (off / size).round() * DVec2::new(1.0, if up { 1.0 } else { 0.0 });
            (off - turns * size).length()
        };
        let far = |place: Sum<DVec2>| Sum {
            size: place.size + size.length(),
            ..place
        };
        let between = |a: DVec2, b: DVec2| a.distance(b);
        let apart = |a: f64, b: f64| (a - b).abs();

        let positions = fire.positions().into_iter().map(Vec2::as_dvec2);
        self.each(
            "position",
            positions,
            plain,
            |q| far(q.position),
            |a, b| turn(a - b),
        );
        let velocities = fire.velocities().into_iter().map(Vec2::as_dvec2);
        self.each("velocity", velocities, plain, |q| q.velocity, between);
        type Figure = (&'static str, Vec<f32>, fn(&Plain) -> Sum<f64>);
        let figures: [Figure; 8] = [
            ("density", fire.densities(), |q| q.density),
            ("pressure", fire.pressures(), |q| q.pressure),
            ("temperature", fire.temperatures(), |q| q.mixture[0]),
            ("fuel", fire.fuels().unwrap_or_default(), |q| q.mixture[1]),
            ("oxygen", fire.oxygens().unwrap_or_default(), |q| {
                q.mixture[2]
            }),
            ("soot", fire.soots().unwrap_or_default(), |q| q.mixture[3]),
            ("burning", fire.burn_rates().unwrap_or_default(), |q| q.burn),
            ("age", fire.ages(), |q| Sum::new(q.age)),
        ];
        for (what, fast, of) in figures {
            if p.model() == Model::Combustion && what == "age" {
                continue;
            }
            self.each(what, fast.into_iter().map(f64::from), plain, of, apart);
        }

        let report = fire.report();
        assert_eq!(report.substeps, oracle.parts(), "{}", self.scene);
        if self.searches == 1 {
            self.count(fire, oracle);
        }
        if let Oracle::Combustion(gas) = oracle {
            for (what, fast, plain) in [
                ("length", report.length, Sum::new(gas.length)),
                ("power", report.power.unwrap_or_default(), gas.power),
                ("preheat", report.preheat.unwrap_or_default(), gas.preheat),
            ] {
                let far = apart(fast.into(), plain.value);
                let name = self.scene;
                assert!(
                    far <= self.allowed * plain.size,
                    "{what}: {fast} is not {plain:?} in '{name}'"
                );
            }
        }
    }

    /// Compares how many neighbours there are.
    fn count(&self, fire: &Simulation, oracle: &Oracle) {
        let (report, crowd) = (fire.report(), oracle.crowd());
        let [low, high] = [0, 1].map(|k| crowd.iter().map(|count| count[k]).max());
        let most = Some(report.max_neighbours);
        let all = f64::from(report.mean_neighbours) * crowd.len() as f64;
        let [fewest, greatest] = [0, 1].map(|k| {
            let sum: u32 = crowd.iter().map(|count| count[k]).sum();
            f64::from(sum)
        });
        let mean = fewest - 1e-6 * all <= all && all <= greatest + 1e-6 * all;
        assert!(
            crowd.is_empty() || low <= most && most <= high && mean,
            "{report:?} is not of {low:?} to {high:?} and {fewest} to {greatest} in '{}'",
            self.scene
        );
    }

    fn each<T: Copy + Debug>(
        &self,
        what: &str,
        fast: impl Iterator<Item = T>,
        plain: &[Plain],
        of: impl Fn(&Plain) -> Sum<T>,
        distance: impl Fn(T, T) -> f64,
    ) {
        for (i, (fast, plain)) in fast.zip(plain.iter().map(of)).enumerate() {
            let off = distance(fast, plain.value);
            let Difference {
                scene,
                step,
                allowed,
                ..
            } = self;
            assert!(
                off <= allowed * plain.size,
                "{what} of particle {i} of '{scene}' in step {step}: {fast:?} is not {plain:?}"
            );
        }
    }
}

/// One step, more of them that each start where the fast solver is, and all in a row.
fn agree(case: &Case, steps: u32) {
    let name = case.name.as_str();
    let mut fire = Simulation::new(case.scene.clone());
    assert_eq!(fire.set_particles(&case.particles), Ok(()), "{name}");
    let (mut beside, mut alone) = (Oracle::new(case), Oracle::new(case));
    let mut searches = 0;
    for step in 1..=steps {
        fire.step();
        let compare = |oracle: &Oracle, searches: u32| {
            let allowed = allowed(searches, case.scene.world());
            let difference = Difference {
                scene: name,
                step,
                searches,
                allowed,
            };
            difference.look(&fire, oracle);
        };
        beside.step(&case.scene);
        compare(&beside, beside.searches());
        searches += beside.searches();
        if searches <= MOST_SEARCHES {
            alone.step(&case.scene);
            compare(&alone, searches);
        }
        // Where most have left, others would be born.
        if fire.count() < case.particles.len() / 2 {
            return;
        }
        beside.take_over(&fire.particles());
    }
}

const WALLS: [&str; 3] = ["open", "solid", "periodic"];

#[test]
fn classic_gas_follows_the_equations() {
    let narrow = [("domain_width", 0.25), ("domain_height", 0.3)];
    for (seed, walls) in (1..).zip(WALLS) {
        for (values, count, spread) in [
            (&[][..], 1501, Spread::Even),
            (&[("smoothing_radius", 0.005)], 603, Spread::Clumped),
            (
                &[narrow[0], narrow[1], ("smoothing_radius", 0.05)],
                302,
                Spread::Even,
            ),
            (
                &[narrow[0], narrow[1], ("smoothing_radius", 0.06)],
                401,
                Spread::Clumped,
            ),
        ] {
            agree(&case(classic(walls, values), count, spread, seed), 10);
        }
    }
}

#[test]
fn a_few_particles_follow_the_equations() {
    for walls in WALLS {
        for count in 1..=9 {
            let parameters = classic(
                walls,
                &[
                    ("domain_width", 0.16),
                    ("domain_height", 0.1),
                    ("smoothing_radius", 0.04),
                    // So heavy that even two of them press.
                    ("particle_mass", 2e-3),
                    ("rest_density", 0.5),
                    // So short that no birth is due in eight of them.
                    ("time_step", 0.002),
                ],
            );
            agree(&case(parameters, count, Spread::Even, count as u32), 8);
        }
    }
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn each_printed_form_follows_its_equation() {
    let forms = [
        "printed_kernel",
        "printed_pressure",
        "printed_viscosity",
        "printed_divisor",
        "printed_euler",
    ];
    let alone = forms.iter().map(|&form| vec![form]);
    let pairs = [
        vec![forms[1], forms[3]],
        vec![forms[2], forms[3]],
        forms.to_vec(),
    ];
    for (seed, chosen) in (1..).zip(alone.chain(pairs)) {
        for walls in ["open", "periodic"] {
            let mut parameters = classic(
                walls,
                &[
                    ("domain_width", 0.3),
                    ("domain_height", 0.4),
                    ("time_step", 0.002),
                ],
            );
            for form in &chosen {
                parameters.set(form, Input::Flag(true)).expect(form);
            }
            agree(&case(parameters, 307, Spread::Even, seed), 10);
        }
    }
}

#[test]
fn combustion_gas_follows_the_equations() {
    // One column of cells, two, three; one row.
    let narrow = [("domain_width", 0.1), ("smoothing_ratio", 1.9)];
    let two = [("domain_width", 0.25), ("domain_height", 6.0)];
    let three = [("domain_width", 0.5), ("domain_height", 6.0)];
    let low = [("domain_width", 6.0), ("domain_height", 0.2), ("wind", 1.0)];
    let vortices = [("vorticity_confinement", 0.7), ("wind", -0.3)];
    let closed = [("seam", 0.0), ("vorticity_confinement", 1.0)];
    let rolls = [("roll_mixing", 0.2), ("fuel_power", 400.0)];
    let narrow = [&narrow[..], &two[1..]].concat();
    let scenes = [
        (&[][..], 1500, Spread::Even),
        (&[], 999, Spread::Clumped),
        (&narrow, 1001, Spread::Even),
        (&narrow, 502, Spread::Clumped),
        (&two, 700, Spread::Even),
        (&three, 1002, Spread::Clumped),
        (&low, 1003, Spread::Even),
        (&low, 600, Spread::Clumped),
        (&vortices, 1203, Spread::Even),
        (&closed, 801, Spread::Clumped),
        (&rolls, 1001, Spread::Even),
        (&rolls, 704, Spread::Clumped),
    ];
    for (seed, (values, count, spread)) in (1..).zip(scenes) {
        agree(&case(combustion(values), count, spread, seed), 10);
    }
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn both_models_follow_the_equations_at_corners_of_all_ranges() {
    let mut random = Random::new(5);
    for seed in 0..16 {
        for model in [Model::Classic, Model::Combustion] {
            let parameters = corner(model, &mut random);
            let count = match model {
                Model::Classic => 251,
                // From half to twice as many as asked for, and no multiple of four.
                Model::Combustion => parameters.world().particles.min(800) as usize + 5,
            };
            agree(&case(parameters, count, Spread::Even, seed), 5);
        }
    }
}
