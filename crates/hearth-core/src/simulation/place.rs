//! The position of a source in each model.

use glam::Vec2;

use crate::classic;
use crate::combustion::Burner;
use crate::params::{Model, Parameters};
use crate::source::Source;

impl Source {
    /// The first source of these parameters.
    pub fn of(parameters: &Parameters) -> Source {
        match parameters.model() {
            Model::Classic => classic::source(parameters),
            Model::Combustion => {
                let burner = Burner::of(parameters);
                Source {
                    base: Vec2::new(burner.middle, burner.bottom),
                    width: 2.0 * burner.half_width,
                }
            }
        }
    }
}
