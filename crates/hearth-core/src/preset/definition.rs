//! What a preset is.

use crate::params::{Input, Parameters};
use crate::scene::Scene;

/// A named set of values: the defaults, with these changed.
#[derive(Debug)]
pub struct Preset {
    /// Its name in attributes and URLs.
    pub name: &'static str,
    /// What differs from the defaults.
    pub values: &'static [(&'static str, Input<'static>)],
}

/// What a person reads about a preset. It stands apart, so that an engine that
/// shows none of it carries none.
#[derive(Debug)]
pub struct Caption {
    /// Its name.
    pub label: &'static str,
    /// What there is to see, in a sentence.
    pub description: &'static str,
}

impl Preset {
    /// Its values.
    pub fn parameters(&self) -> Parameters {
        let mut parameters = Parameters::default();
        let set = parameters.set_all(self.values.iter().copied());
        debug_assert!(set.is_ok(), "preset {}: {set:?}", self.name);
        parameters
    }

    /// Its scene: these values, with one source.
    pub fn scene(&self) -> Scene {
        Scene::new(self.parameters())
    }
}
