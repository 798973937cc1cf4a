//! What somebody wants a fire to burn with, and what it burns with at a level of
//! quality.

use hearth_core::params::{Input, Model};
use hearth_core::{Parameters, Simulation};

use crate::message::{
    Order, Refused, Start, of_preset, starting_values, with_defaults, with_values,
};
use crate::quality::Level;

/// The number of particles, which is the level's affair unless somebody sets it.
const NUMBER: &str = "max_particles";

/// A fire's values as somebody asked for them.
#[derive(Clone, Debug, PartialEq)]
pub struct Wanted {
    /// The values.
    pub parameters: Parameters,
    /// Whether somebody set the combustion model's number of particles: the default
    /// one, too, is then kept.
    pub own_number: bool,
}

impl Wanted {
    /// What a new fire starts with, and what was refused of it.
    pub fn at_first(start: &Start) -> (Wanted, Vec<Refused>) {
        let (parameters, errors) = starting_values(start);
        let wanted = Wanted {
            parameters,
            own_number: start.own_number,
        };
        (wanted, errors)
    }

    /// What is wanted after an order; nothing where it is about something else.
    ///
    /// # Errors
    /// What is refused of it.
    pub fn after(&self, order: &Order) -> Option<Result<Wanted, Vec<Refused>>> {
        let (parameters, own) = match order {
            Order::Set(values) => {
                let own = values.iter().any(|(id, _)| id == NUMBER).then_some(true);
                (with_values(&self.parameters, values), own)
            }
            Order::Restore(ids) => {
                let own = ids.iter().any(|id| id == NUMBER).then_some(false);
                (with_defaults(&self.parameters, ids), own)
            }
            Order::Preset(name) => (of_preset(name), Some(false)),
            _ => return None,
        };
        Some(parameters.map(|parameters| {
            // The classic model's number is another one, and nobody else's.
            let about =
                parameters.model() == Model::Combustion || matches!(order, Order::Preset(_));
            let own = own.filter(|_| about);
            Wanted {
                parameters,
                own_number: own.unwrap_or(self.own_number),
            }
        }))
    }

    /// Whether the number of particles is the level's affair.
    pub fn follows_level(&self) -> bool {
        self.parameters.model() == Model::Combustion
            && !self.own_number
            && self.parameters.max_particles == Level::Medium.particles()
    }

    /// The values, with as many particles as the level has where that is its affair.
    pub fn at(&self, level: Level) -> Parameters {
        let mut parameters = self.parameters.clone();
        if self.follows_level() {
            let particles = Input::Number(level.particles().into());
            let set = parameters.set(NUMBER, particles);
            debug_assert_eq!(set, Ok(()));
        }
        parameters
    }

    /// Whether a second of the clock is as much work at the same level: if not,
    /// what frames took says nothing about those to come.
    pub fn works_like(&self, other: &Wanted) -> bool {
        let work = |wanted: &Wanted| {
            let values = &wanted.parameters;
            (values.model(), values.max_particles, values.time_scale)
        };
        work(self) == work(other) && self.follows_level() == other.follows_level()
    }
}

/// Gives a fire these values. One that burns is taken over by other particles where
/// their number changes; one that has not begun is made anew, so that it is the same
/// on every machine, whatever was the guess for it.
pub fn adapt(simulation: &mut Simulation, parameters: Parameters) {
    if simulation.time() > 0.0 {
        simulation.set_parameters(parameters);
    } else {
        *simulation = Simulation::new(parameters);
    }
}
