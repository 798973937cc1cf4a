//! The types of the presets.

use crate::params::{IN_DOMAIN, Input, Parameters};
use crate::scene::{KIND, Scene};

/// A named set of values that differ from the defaults.
#[derive(Debug)]
pub struct Preset {
    /// Its name in attributes and URLs.
    pub name: &'static str,
    /// The values that differ from the defaults, then the fields of each object besides its
    /// source, with an empty line before each object. A line is an id and a value: a table of
    /// inputs costs a kilobyte of download. An object that does not begin with its kind has the
    /// fields of the one before it, but for its own.
    pub(super) text: &'static str,
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
    /// The values that differ from the defaults.
    pub fn values(&self) -> impl Iterator<Item = (&'static str, Input<'static>)> + Clone {
        Fields(self.text).fuse()
    }

    /// Everything but its name, as text: what `cargo xtask build` takes out of a wasm module that
    /// loads it on request.
    pub fn text(&self) -> &'static str {
        self.text
    }

    /// Its values, with their resolution.
    pub fn parameters(&self) -> Parameters {
        let mut parameters = Parameters::default();
        let set = parameters.set_all(self.values());
        debug_assert!(set.is_ok(), "preset {}: {set:?}", self.name);
        let [spacing, number] = ["spacing", "max_particles"].map(|id| self.names(id));
        parameters.complete(spacing, number, IN_DOMAIN);
        parameters
    }

    /// Whether it sets this parameter.
    pub fn names(&self, id: &str) -> bool {
        self.values().any(|(known, _)| known == id)
    }

    /// Its scene: these values, with one source and its other objects.
    pub fn scene(&self) -> Scene {
        let mut scene = Scene::new(self.parameters());
        let mut rest = Fields(self.text);
        rest.by_ref().for_each(drop);
        let mut fields = Vec::new();
        while !rest.0.is_empty() {
            if rest.0.starts_with(KIND) {
                fields.clear();
            }
            // Of two fields of one name the later counts.
            fields.extend(rest.by_ref());
            let added = scene.add(&fields);
            debug_assert!(added.is_ok(), "preset {}: {added:?}", self.name);
        }
        scene
    }
}

/// The fields that a text still holds. After those of the values and of each object comes `None`, once.
#[derive(Clone)]
struct Fields(&'static str);

impl Iterator for Fields {
    type Item = (&'static str, Input<'static>);

    fn next(&mut self) -> Option<Self::Item> {
        let (line, rest) = self.0.split_once('\n').unwrap_or((self.0, ""));
        self.0 = rest;
        let (id, value) = line.split_once(' ')?;
        Some((id, Input::from_decimal(value)))
    }
}
