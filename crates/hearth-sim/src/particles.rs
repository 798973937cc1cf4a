//! Particles and embers as rows of numbers: all numbers of one, then of the next.

use hearth_core::{Ember, Particle, Simulation, Vec2};

/// Number of numbers of a particle: position, velocity, temperature, age, lifetime, fuel,
/// oxygen, soot, in the order of `web/sim/particles.js`.
pub const NUMBERS: usize = 10;

/// Most particles in either model. `web/sim/particles.js` throws the same error for more, before
/// it copies them.
pub const MAX_PARTICLES: usize = 400_000;

/// The error for more particles.
pub const TOO_MANY: &str = "the particles are refused: there may be 400000 of them at most";

/// The particles of these numbers, unchecked, without an incomplete last one.
pub fn particles(numbers: &[f32]) -> Vec<Particle> {
    let (whole, _) = numbers.as_chunks::<NUMBERS>();
    whole
        .iter()
        .map(
            |&[x, y, vx, vy, temperature, age, lifetime, fuel, oxygen, soot]| Particle {
                position: Vec2::new(x, y),
                velocity: Vec2::new(vx, vy),
                temperature,
                age,
                lifetime,
                fuel,
                oxygen,
                soot,
            },
        )
        .collect()
}

/// One property of all particles, in the order of birth, by its name in JavaScript; vectors are
/// x and y of each. `embers` gives all numbers of each ember,
/// `fuels` and `freeSolids` those of each such solid. `None`: a property that the model does not
/// have, or an unknown name.
pub fn property(simulation: &Simulation, name: &str) -> Option<Vec<f32>> {
    Some(match name {
        "positions" => pairs(simulation.positions()),
        "velocities" => pairs(simulation.velocities()),
        "temperatures" => simulation.temperatures(),
        "ages" => simulation.ages(),
        "lifetimes" => lifetimes(simulation),
        "densities" => simulation.densities(),
        "pressures" => simulation.pressures(),
        "fuel" => simulation.fuels()?,
        "oxygen" => simulation.oxygens()?,
        "soot" => simulation.soots()?,
        "burnRates" => simulation.burn_rates()?,
        "embers" => embers(simulation.embers()),
        "fuels" => fuels(simulation),
        "freeSolids" => simulation.free_solid_numbers(),
        _ => return None,
    })
}

/// The ids of all particles. An id above 2⁵³ would be inexact, and is out of reach.
pub fn ids(simulation: &Simulation) -> Vec<f64> {
    let ids = simulation.ids().into_iter();
    ids.map(|id| id as f64).collect()
}

fn pairs(vectors: Vec<Vec2>) -> Vec<f32> {
    vectors
        .into_iter()
        .flat_map(|vector| vector.to_array())
        .collect()
}

fn lifetimes(simulation: &Simulation) -> Vec<f32> {
    let particles = simulation.particles().into_iter();
    particles.map(|particle| particle.lifetime).collect()
}

/// Numbers of every solid with fuel: id, state, dry mass at first, fuel, water, char, power, highest
/// temperature.
fn fuels(simulation: &Simulation) -> Vec<f32> {
    let solids = simulation.burning_solids();
    let rows = solids.iter().map(|solid| {
        let masses = [solid.first, solid.fuel, solid.water, solid.char].map(|mass| mass as f32);
        let [first, fuel, water, char] = masses;
        let state = f32::from(solid.state as u8);
        [
            solid.id as f32,
            state,
            first,
            fuel,
            water,
            char,
            solid.power,
            solid.hottest,
        ]
    });
    rows.flatten().collect()
}

/// Numbers of every ember: position, velocity, temperature, size, age, lifetime.
fn embers(embers: &[Ember]) -> Vec<f32> {
    embers
        .iter()
        .flat_map(|ember| {
            [
                ember.position.x,
                ember.position.y,
                ember.velocity.x,
                ember.velocity.y,
                ember.temperature,
                ember.size,
                ember.age,
                ember.lifetime,
            ]
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use hearth_core::Parameters;
    use hearth_core::params::{Input, Model};

    use super::*;

    #[test]
    fn each_number_is_its_property() {
        let numbers: Vec<f32> = (0..25).map(|n| n as f32).collect();
        let second = Particle {
            position: Vec2::new(10.0, 11.0),
            velocity: Vec2::new(12.0, 13.0),
            temperature: 14.0,
            age: 15.0,
            lifetime: 16.0,
            fuel: 17.0,
            oxygen: 18.0,
            soot: 19.0,
        };
        let read = particles(&numbers);
        assert_eq!(read.len(), 2);
        assert_eq!(read[1], second);
    }

    /// A combustion fire and a classic one that have burnt for a while.
    fn fires() -> [Simulation; 2] {
        [Model::Combustion, Model::Classic].map(|model| {
            let mut parameters = Parameters::new(model);
            assert_eq!(
                parameters.set("max_particles", Input::Number(1000.0)),
                Ok(())
            );
            let mut fire = Simulation::new(parameters);
            for _ in 0..100 {
                fire.step();
            }
            fire
        })
    }

    #[test]
    fn properties_that_are_read_make_the_same_particles() {
        for fire in fires() {
            let column = |name: &str| property(&fire, name);
            let vectors = |name: &str| column(name).unwrap_or_default();
            let (at, moves) = (vectors("positions"), vectors("velocities"));
            let scalars = [
                "temperatures",
                "ages",
                "lifetimes",
                "fuel",
                "oxygen",
                "soot",
            ]
            .map(column);
            let mut numbers = Vec::new();
            for i in 0..fire.count() {
                numbers.extend_from_slice(&at[2 * i..2 * i + 2]);
                numbers.extend_from_slice(&moves[2 * i..2 * i + 2]);
                // What the classic model does not have is that of air.
                let of_air = [0.0, 0.0, 0.0, 0.0, 1.0, 0.0];
                let all = scalars.iter().zip(of_air);
                numbers.extend(all.map(|(scalar, air)| scalar.as_ref().map_or(air, |all| all[i])));
            }
            assert!(fire.count() > 0);
            assert_eq!(particles(&numbers), fire.particles());
        }
    }

    #[test]
    fn every_property_of_the_model_has_a_value_per_particle() {
        for fire in fires() {
            let length = |name: &str| property(&fire, name).map(|all| all.len());
            for name in ["densities", "pressures"] {
                assert_eq!(length(name), Some(fire.count()), "{name}");
            }
            let burns = fire.parameters().model() == Model::Combustion;
            for name in ["fuel", "oxygen", "soot", "burnRates"] {
                assert_eq!(length(name), burns.then_some(fire.count()), "{name}");
            }
            for name in ["", "burn_rates", "__proto__"] {
                assert_eq!(property(&fire, name), None);
            }
        }
    }

    #[test]
    fn an_ember_is_its_eight_numbers() {
        let ember = Ember {
            position: Vec2::new(1.0, 2.0),
            velocity: Vec2::new(3.0, 4.0),
            temperature: 5.0,
            size: 6.0,
            age: 7.0,
            lifetime: 8.0,
        };
        assert_eq!(embers(&[ember]), [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]);
    }

    #[test]
    fn the_core_has_the_same_limit_and_error() {
        let particle = Particle {
            lifetime: 1.0,
            ..Particle::at(Vec2::new(0.0, 0.1))
        };
        let mut fire = Simulation::new(Parameters::new(Model::Classic));
        let refused = fire.set_particles(&vec![particle; MAX_PARTICLES + 1]);
        assert_eq!(
            refused.map_err(|error| error.to_string()),
            Err(TOO_MANY.to_owned())
        );
        assert_eq!(fire.set_particles(&vec![particle; MAX_PARTICLES]), Ok(()));
        assert_eq!(property(&fire, "lifetimes"), Some(vec![1.0; MAX_PARTICLES]));
    }
}
