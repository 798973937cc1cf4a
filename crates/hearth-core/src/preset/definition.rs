//! The type of a preset, and the reader of their table.

use std::sync::{LazyLock, OnceLock};

use crate::params::{IN_DOMAIN, Input, Parameters};
use crate::scene::{KIND, Scene};

/// The table of presets. `cargo xtask codegen` writes it from the files of `scenes/`.
///
/// A line is a name, a blank and a value, which extends to the end of the line. `preset` begins a preset; the values
/// that differ from the defaults follow. `kind` begins an object; the fields that differ from the defaults follow.
const TABLE: &str = include_str!("scenes.txt");

/// A line for each preset: its name, its label and its description, divided by tabulators. A program that shows none
/// of them does not contain this table.
const TEXTS: &str = include_str!("texts.txt");

/// Names and their values.
type Fields = Vec<(&'static str, Input<'static>)>;

/// A named set of values that differ from the defaults.
#[derive(Debug, Default)]
pub struct Preset {
    /// Its name in attributes and URLs.
    pub name: &'static str,
    /// The values of the world that differ from the defaults.
    values: Fields,
    /// The fields of each object.
    objects: Vec<Fields>,
    /// The scene, once it is made.
    scene: OnceLock<Scene>,
}

impl Preset {
    /// Every preset: the default one, then those of each model by their names.
    pub fn all() -> &'static [Preset] {
        static PRESETS: LazyLock<Vec<Preset>> = LazyLock::new(|| read(TABLE));
        &PRESETS
    }

    /// The preset with this name.
    pub fn find(name: &str) -> Option<&'static Preset> {
        Preset::all().iter().find(|preset| preset.name == name)
    }

    /// Its name for people.
    pub fn label(&self) -> &'static str {
        self.texts().0
    }

    /// The appearance of the fire, in a sentence.
    pub fn description(&self) -> &'static str {
        self.texts().1
    }

    /// Label and description.
    fn texts(&self) -> (&'static str, &'static str) {
        let texts = |line: &'static str| {
            line.strip_prefix(self.name)?
                .strip_prefix('\t')?
                .split_once('\t')
        };
        TEXTS.lines().find_map(texts).unwrap_or_default()
    }

    /// The values of its world that differ from the defaults.
    pub fn values(&self) -> impl Iterator<Item = (&'static str, Input<'static>)> + Clone {
        self.values.iter().copied()
    }

    /// The world of its [scene](Preset::scene), with its resolution, without sources and solids.
    pub fn world(&self) -> Parameters {
        self.scene().world().clone()
    }

    /// Whether it sets this parameter.
    pub fn names(&self, id: &str) -> bool {
        self.values().any(|(known, _)| known == id)
    }

    /// Its scene.
    pub fn scene(&self) -> Scene {
        self.scene.get_or_init(|| self.make()).clone()
    }

    fn make(&self) -> Scene {
        let mut world = Parameters::default();
        let set = world.set_all(self.values());
        debug_assert!(set.is_ok(), "preset {}: {set:?}", self.name);
        world.complete(&|id| self.names(id), IN_DOMAIN);
        let mut scene = Scene::new(world);
        scene.clear();
        for fields in &self.objects {
            let added = scene.add(fields);
            debug_assert!(added.is_ok(), "preset {}: {added:?}", self.name);
        }
        scene
    }
}

/// The presets of a table.
fn read(table: &'static str) -> Vec<Preset> {
    let mut presets: Vec<Preset> = Vec::new();
    for (name, text) in table.lines().filter_map(|line| line.split_once(' ')) {
        if name == "preset" {
            presets.push(Preset {
                name: text,
                ..Preset::default()
            });
        }
        let Some(preset) = presets.last_mut() else {
            continue;
        };
        match name {
            "preset" => {}
            _ => {
                if name == KIND {
                    preset.objects.push(Fields::new());
                }
                let fields = preset.objects.last_mut().unwrap_or(&mut preset.values);
                fields.push((name, Input::from_decimal(text)));
            }
        }
    }
    presets
}
