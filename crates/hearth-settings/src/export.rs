//! Settings as a [settings file](crate::file).

use crate::apply::{OBJECTS, objects, of_model, other_model};
use crate::file::{CHILDREN, FIRST, ORDER, VERSION};
use crate::settings::{Settings, StatedResolution};
use crate::untrusted::Untrusted;
use hearth_core::Scene;
use hearth_core::params::{Model, PARAMETERS};
use hearth_core::preset::Preset;
use hearth_core::scene::Kind;

/// The fields of [whole] settings.
pub const FIELDS: [&str; 9] = [
    "hearth",
    "preset",
    FIRST,
    "values",
    "classic",
    "combustion",
    OBJECTS,
    CHILDREN,
    ORDER,
];

/// The values of `model` that differ from the preset, and the stated resolution: all, those of that model
/// alone, or those that both share. Without `source`, no property of the first source.
fn differences(
    settings: &Settings,
    model: Model,
    of_model_alone: Option<bool>,
    source: bool,
) -> Untrusted {
    let preset = &settings.preset().parameters();
    let now = &of_model(settings.parameters(), model);
    // Each model has its own defaults.
    let base = &of_model(preset, model);
    let mut fields = Vec::new();
    for param in PARAMETERS {
        let Some(domain) = param.domain(model) else {
            continue;
        };
        let mut properties = Kind::SOURCE.properties();
        let of_source = !source && properties.any(|property| property.id == param.id);
        let before = if param.id == "model" { preset } else { base };
        let value = param.get(now);
        let differs = if StatedResolution::is_part(param.id) {
            settings.states(param.id)
        } else {
            value != param.get(before)
        };
        let is_part = of_model_alone.is_none_or(|alone| alone == domain.model.is_some());
        if differs && !of_source && is_part {
            fields.push(Untrusted::named(param.id, Untrusted::of_value(value)));
        }
    }
    Untrusted::Object(fields)
}

/// The other objects and the name of the first source, if the preset has them too.
fn has_objects_of_preset(settings: &Settings) -> bool {
    let without_values = |scene: &Scene| objects(scene, Some(scene.settings()), false);
    without_values(settings.scene()) == without_values(&settings.preset().scene())
}

/// Writes settings as a settings file: the preset and the differences from it.
pub fn export(settings: &Settings) -> Untrusted {
    let settings = &settings.numbered_in_file();
    let now = settings.parameters();
    let number = Untrusted::Number(VERSION.into());
    let mut fields = vec![Untrusted::named("hearth", number)];
    if settings.preset().name != Preset::all()[0].name {
        let name = Untrusted::Text(settings.preset().name.to_owned());
        fields.push(Untrusted::named("preset", name));
    }
    let lists_objects = !has_objects_of_preset(settings);
    let mut objects_now = settings.scene().objects();
    let lists_source = lists_objects && objects_now.any(|object| object.is_first_source());
    let values = differences(settings, now.model(), None, !lists_source);
    fields.push(Untrusted::named("values", values));
    let other = other_model(now.model());
    let values = differences(settings, other, Some(true), true);
    if !values.fields().is_empty() {
        fields.push(Untrusted::named(other.name(), values));
    }
    if lists_objects {
        let base = of_model(&settings.preset().parameters(), now.model());
        let list = objects(settings.scene(), Some(&base), false);
        fields.push(Untrusted::named(OBJECTS, list));
    }
    Untrusted::Object(fields)
}

/// Writes settings as a settings file each of whose parts has a place of its own: the values that both models share,
/// those of each model, all objects with their ids, the children of the element, and the order of all. The first source
/// is among both. A part that changes leaves the others.
pub fn whole(settings: &Settings) -> Untrusted {
    let bare = settings.bare();
    let model = bare.parameters().model();
    let base = of_model(&bare.preset().parameters(), model);
    let name = Untrusted::Text(bare.preset().name.to_owned());
    let of = |model: Model, alone| differences(&bare, model, Some(alone), true);
    let children = settings.children.as_ref();
    let [children, order] = children.map_or(
        [Untrusted::List(Vec::new()), Untrusted::Text(String::new())],
        |children| children.write(settings.scene()),
    );
    let values = [
        ("values", of(model, false)),
        (Model::Classic.name(), of(Model::Classic, true)),
        (Model::Combustion.name(), of(Model::Combustion, true)),
        (OBJECTS, objects(bare.scene(), Some(&base), true)),
        (CHILDREN, children),
        (ORDER, order),
    ];
    let mut fields = vec![
        Untrusted::named("hearth", Untrusted::Number(VERSION.into())),
        Untrusted::named("preset", name),
        Untrusted::named(FIRST, Untrusted::Number(bare.first_id.into())),
    ];
    fields.extend(values.map(|(field, value)| Untrusted::named(field, value)));
    Untrusted::Object(fields)
}
