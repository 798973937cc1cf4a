//! A fire's settings as one small piece of data: to be kept, sent and opened again.
//!
//! `{"hearth": 2, "preset": "seed", "values": {"viscosity": 0.02}, "objects": [{"kind":
//! "source", "x": 0.1}]}`: the preset it starts from, where that is not the default one,
//! and what differs from it. It holds what a fire burns with and nothing of the device
//! that it burns on. A scene's file is one too: its label and its description are for
//! people.
//!
//! `objects` are all that there are, and left out where the preset's one source burns as
//! it does there. Each has its kind and what differs from the preset, of the first source,
//! or from the defaults, of others. Version 1 has no objects: what is said of its one
//! source stands in `values`, where version 2 reads it as well; of two words about the
//! same property the later one counts.

use hearth_core::params::{Input, Model, PARAMETERS};
use hearth_core::preset::PRESETS;
use hearth_core::scene::KINDS;

use crate::fields::Fields;
use crate::message::{Refused, SentValues};
use crate::raw::Raw;
use crate::scene::{self, OBJECTS};
use crate::wanted::{NUMBER, Wanted};

/// The version of the form.
pub const VERSION: u32 = 2;

/// The fields that there are.
const FIELDS: [&str; 6] = [
    "hearth",
    "preset",
    "values",
    OBJECTS,
    "label",
    "description",
];

/// Settings whose form is right. Their values are not checked yet.
#[derive(Clone, Debug, PartialEq)]
pub struct Config {
    /// The preset.
    pub preset: Option<String>,
    /// What differs from it, `objects` among it, in the order in which they stand.
    pub values: SentValues,
}

impl Config {
    /// Checks the form.
    ///
    /// # Errors
    /// The first field that is not as described above.
    pub fn parse(raw: &Raw) -> Result<Config, Refused> {
        let Raw::Object(sent) = raw else {
            let allowed = "an object with the fields preset, values and objects";
            return Err(Refused::field("config", raw, allowed));
        };
        for (name, value) in sent {
            if !FIELDS.contains(&name.as_str()) {
                return Err(unknown_field(name, value));
            }
        }
        let mut fields = Fields::of(raw);
        match raw.field("hearth") {
            Raw::Missing => {}
            Raw::Number(version) if *version == 1.0 || *version == f64::from(VERSION) => {}
            _ => fields.refuse("hearth", "1 or 2, the version of the form"),
        }
        for words in ["label", "description"] {
            fields.optional_text(words);
        }
        let mut values = fields.optional_values("values");
        for (id, _) in &values {
            if id == OBJECTS {
                fields.refuse("values", "values of parameters; objects stand beside it");
            }
        }
        let objects = (OBJECTS.to_owned(), raw.field(OBJECTS).clone());
        let at = |name| sent.iter().position(|(known, _)| known == name);
        if objects.1 != Raw::Missing {
            let first = at(OBJECTS) < at("values");
            values.insert(if first { 0 } else { values.len() }, objects);
        }
        let config = Config {
            preset: fields.optional_text("preset"),
            values,
        };
        fields.refused().map_or(Ok(config), Err)
    }

    /// What a fire with these settings burns with.
    ///
    /// # Errors
    /// Everything in them that is refused.
    pub fn wanted(&self) -> Result<Wanted, Vec<Refused>> {
        let base = match &self.preset {
            Some(name) => Wanted::of_preset(name)?,
            None => Wanted::default(),
        };
        let mut scene = base.scene.clone();
        scene::set(&mut scene, &self.values)?;
        let named = self.values.iter().any(|(id, _)| id == NUMBER);
        Ok(Wanted {
            own_number: named && scene.settings().model() == Model::Combustion,
            scene,
            ..base
        })
    }
}

/// The settings of a fire as data, which [`Config::parse`] reads: what has to be set of
/// its preset to have the fire again.
pub fn export(wanted: &Wanted) -> Raw {
    let now = wanted.parameters();
    let preset = wanted.of_its_preset();
    let preset = preset.settings();
    let mut base = preset.clone();
    // Another model has other defaults.
    let set = base.set("model", Input::Text(now.model.name()));
    debug_assert_eq!(set, Ok(()));
    let has_source = wanted.scene.objects().len() > 0;
    let mut values = Vec::new();
    for param in PARAMETERS {
        let mut properties = KINDS.iter().flat_map(|kind| kind.properties);
        let of_source = has_source && properties.any(|one| one.id == param.id);
        let before = if param.id == "model" { preset } else { &base };
        let value = param.get(now);
        let differs = value != param.get(before) || param.id == NUMBER && wanted.names_number();
        // The first source has what is its own.
        if differs && !of_source && param.domain(now.model()).is_some() {
            values.push(Raw::named(param.id, Raw::of_value(value)));
        }
    }
    let mut fields = vec![Raw::named("hearth", Raw::Number(VERSION.into()))];
    if wanted.preset != PRESETS[0].name {
        fields.push(Raw::named("preset", Raw::text(wanted.preset)));
    }
    fields.push(Raw::named("values", Raw::Object(values)));
    let objects = scene::objects(&wanted.scene, Some(&base));
    // One source without properties, as the preset has.
    let plain = matches!(&objects, Raw::List(all) if matches!(&all[..], [Raw::Object(one)] if one.len() == 1));
    if !plain {
        fields.push(Raw::named(OBJECTS, objects));
    }
    Raw::Object(fields)
}

/// A field that settings have no use for, with the one that may have been meant.
fn unknown_field(name: &str, value: &Raw) -> Refused {
    let known = "one of hearth, preset, values, objects (parameters stand in values)";
    Refused::field(name.get(..40).unwrap_or(name), value, known)
}
