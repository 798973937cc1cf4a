//! The types of the presets.

use crate::params::{IN_FRAME, Input, Parameters};
use crate::scene::Scene;

/// A named set of values that differ from the defaults.
#[derive(Debug)]
pub struct Preset {
    /// Its name in attributes and URLs.
    pub name: &'static str,
    /// The values that differ from the defaults.
    pub values: &'static [(&'static str, Input<'static>)],
    /// The fields of its objects besides its source.
    pub objects: &'static [&'static [(&'static str, Input<'static>)]],
}

/// The label and description of a preset. A separate array, so that a build without text does
/// not include it.
#[derive(Debug)]
pub struct Caption {
    /// Its name.
    pub label: &'static str,
    /// The appearance of the fire, in a sentence.
    pub description: &'static str,
}

impl Preset {
    /// Its values, with their resolution.
    pub fn parameters(&self) -> Parameters {
        let mut parameters = Parameters::default();
        let set = parameters.set_all(self.values.iter().copied());
        debug_assert!(set.is_ok(), "preset {}: {set:?}", self.name);
        let [spacing, number] = ["spacing", "max_particles"].map(|id| self.names(id));
        parameters.complete(spacing, number, IN_FRAME);
        parameters
    }

    /// Whether it sets this parameter.
    pub fn names(&self, id: &str) -> bool {
        self.values.iter().any(|(known, _)| *known == id)
    }

    /// Its scene: these values, with one source and its other objects.
    pub fn scene(&self) -> Scene {
        let mut scene = Scene::new(self.parameters());
        for fields in self.objects {
            let added = scene.add(fields);
            debug_assert!(added.is_ok(), "preset {}: {added:?}", self.name);
        }
        scene
    }
}
