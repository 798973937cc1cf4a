//! Random scenes of both models.

use hearth_core::params::{Input, Model};
use hearth_core::random::Random;
use hearth_core::{Particle, Scene, Vec2};
use hearth_tests::{fires, sweep};

/// A fire before its first step.
pub struct Case {
    pub name: String,
    pub scene: Scene,
    pub particles: Vec<Particle>,
}

/// Where particles are put.
#[derive(Clone, Copy, Debug)]
pub enum Spread {
    /// Anywhere.
    Even,
    /// Many of them in a few clumps.
    Clumped,
}

/// A fire of so many particles in random motion, of every mixture.
pub fn case(scene: Scene, count: usize, spread: Spread, seed: u32) -> Case {
    let p = scene.world();
    let size = Vec2::new(p.domain_width, p.domain_height);
    let support = 2.0 * p.smoothing_length();
    let cells = (size / support).floor().max(Vec2::ONE);
    let corner = Vec2::new(-0.5 * size.x, 0.0);
    let mut random = Random::new(seed);
    let mut places: Vec<Vec2> = Vec::new();
    for i in 0..count {
        let mut any = |low: f32, high: f32| random.between(low, high);
        let free = corner + Vec2::new(any(0.0, 1.0), any(0.0, 1.0)) * size;
        let border = (any(0.0, 1.0) * cells.x).round() / cells.x * size.x + corner.x;
        let shelf = (any(0.0, 1.0) * cells.y).round() / cells.y * size.y;
        let place = match any(0.0, 20.0) as u32 {
            0 => Vec2::new(border, free.y),
            1 => Vec2::new(free.x, shelf),
            2 => Vec2::new(border, shelf),
            3 => Vec2::new(if free.x < 0.0 { corner.x } else { -corner.x }, free.y),
            4 => Vec2::new(free.x, if free.y < 0.5 * size.y { 0.0 } else { size.y }),
            5 if i > 0 => places[any(0.0, i as f32) as usize % i],
            6..11 if matches!(spread, Spread::Clumped) && i > 8 => {
                places[i % 4] + 0.1 * support * Vec2::new(any(-1.0, 1.0), any(-1.0, 1.0))
            }
            _ => free,
        };
        places.push(place.clamp(corner, corner + size));
    }
    let particles = places.into_iter().map(|place| {
        let mut any = |low: f32, high: f32| random.between(low, high);
        let lasts = any(0.02, 2.0);
        let burns = p.model() == Model::Combustion;
        let mixed = Particle {
            velocity: Vec2::new(any(-1.0, 1.0), any(-1.0, 1.0)),
            temperature: any(280.0, 2000.0),
            ..Particle::at(place)
        };
        if burns {
            Particle {
                fuel: any(0.0, 1.0),
                oxygen: any(0.0, 1.0),
                soot: any(0.0, 2.0),
                ..mixed
            }
        } else {
            Particle {
                lifetime: lasts,
                ..mixed
            }
        }
    });
    Case {
        name: format!(
            "{spread:?}, seed {seed}: {count} in {}",
            sweep::described(&scene)
        ),
        particles: particles.collect(),
        scene,
    }
}

/// Classic parameters without births: there are already more particles than may be.
pub fn classic(walls: &str, values: &[(&str, f64)]) -> Scene {
    let few = [("max_particles", 100.0), ("emission_rate", 50.0)];
    let numbers = few.iter().chain(values);
    let numbers = numbers.map(|&(id, value)| (id, Input::Number(value)));
    fires::with(numbers.chain([("walls", Input::Text(walls))]))
}

/// Combustion parameters without chance.
pub fn combustion(values: &[(&str, f64)]) -> Scene {
    fires::combustion(&[&[("emission_noise", 0.0), ("ember_rate", 0.0)], values].concat())
}

/// A corner of all ranges, without what the plain solver leaves out.
pub fn corner(model: Model, random: &mut Random) -> Scene {
    let mut scene = sweep::corner(model, random);
    let burner = [
        ("seam", scene.world().seam),
        ("source_height", fires::source(&scene).y),
    ];
    let mut set = |id: &str, value: f64| {
        assert_eq!(scene.set(id, value), Ok(()));
    };
    set("turbulence", 0.0);
    if model == Model::Combustion {
        set("emission_noise", 0.0);
        set("ember_rate", 0.0);
        // Otherwise the border of a cell is at the edge of the burner, and rounding
        // decides which particles are in the burner.
        for (id, value) in burner {
            set(id, 0.99 * f64::from(value));
        }
    } else {
        set("max_particles", 100.0);
        // Small, for rounding is a share of it, and wide enough that beyond the edge there
        // are no images of images.
        for side in ["domain_width", "domain_height"] {
            set(side, f64::from(random.between(0.25, 0.5)));
        }
    }
    scene
}
