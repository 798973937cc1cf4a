//! The type of a preset, and the reader of their table.

use std::fmt;
use std::sync::{LazyLock, OnceLock};

use crate::params::{IN_DOMAIN, Input, Parameters, nearest, quoted};
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
    ///
    /// # Errors
    /// There is none. The error names a similar one or, if no name is similar, all.
    pub fn find(name: &str) -> Result<&'static Preset, UnknownPreset> {
        let name = name.trim_ascii();
        let found = Preset::all().iter().find(|preset| preset.name == name);
        found.ok_or_else(|| UnknownPreset::new(name))
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

    /// Its scene: the values, with the first source and every other object.
    ///
    /// ```
    /// # use hearth_core as hearth_fire;
    /// use hearth_fire::{Simulation, preset::Preset};
    ///
    /// let campfire = Simulation::new(Preset::find("campfire")?.scene());
    /// assert_eq!(campfire.scene().objects().count(), 8);
    /// # Ok::<(), hearth_fire::preset::UnknownPreset>(())
    /// ```
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

/// The error of an unknown preset.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownPreset {
    /// The requested name, cut if it is long.
    pub name: String,
    /// A similar name, if there is one.
    pub nearest: Option<&'static str>,
}

impl UnknownPreset {
    #[cold]
    fn new(name: &str) -> UnknownPreset {
        UnknownPreset {
            name: quoted(name),
            nearest: nearest(name, &mut Preset::all().iter().map(|preset| preset.name)),
        }
    }
}

impl fmt::Display for UnknownPreset {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "there is no preset \"{}\"; ", self.name)?;
        if let Some(nearest) = self.nearest {
            return write!(f, "did you mean \"{nearest}\"?");
        }
        // All names are longer than what a message may be.
        const SHOWN: usize = 12;
        let names = Preset::all().iter().map(|preset| preset.name);
        let shown: Vec<_> = names.clone().take(SHOWN).collect();
        let more = names.len().saturating_sub(SHOWN);
        write!(f, "there are {} and {more} more", shown.join(", "))
    }
}

impl std::error::Error for UnknownPreset {}

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
