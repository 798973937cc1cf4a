//! Scenes of objects, and their names.

use hearth_core::params::{AnyValue, Input, Kind, Model, Parameters, Property, Value};
use hearth_core::scene::{Object, Scene};

use crate::state::entry::Entry;
use crate::state::subject::Subject;

/// The group of the objects, and its name for [`State::reveal`](crate::state::State::reveal).
pub const OBJECTS: &str = "Objects";

/// The name and the value of each field of an object.
pub type Fields = Vec<(String, Entry)>;

/// A scene with these objects. An object that is refused comes from another version of the fire
/// and is missing.
pub fn scene_of(settings: &Parameters, objects: &[Fields]) -> Scene {
    let mut scene = Scene::new(settings.clone());
    scene.clear();
    for fields in objects {
        let fields: Vec<(&str, Input<'_>)> = fields
            .iter()
            .map(|(name, entry)| (name.as_str(), entry.input()))
            .collect();
        let _ = scene.add(&fields);
    }
    scene
}

/// Whether a property has a row in `model`. A field of one line cannot show an outline.
pub fn has_row(property: &Property, model: Model) -> bool {
    let param = property.param(model);
    param.is_some_and(|param| !matches!(param.kind, Kind::Text(_)))
}

/// The value of a property in a scene; none of an outline, which has no row.
pub fn value_in(scene: &Scene, subject: Subject) -> Option<Value> {
    let owner = subject.object?;
    let mut all = scene.objects();
    let object = all.find(|one| one.id == owner.id && one.kind.name == owner.kind)?;
    let mut values = object.properties();
    let (.., value) = values.find(|(name, ..)| *name == owner.property)?;
    match value {
        AnyValue::Number(x) => Some(Value::Number(x)),
        AnyValue::Integer(n) => Some(Value::Integer(n)),
        AnyValue::Choice(name) => Some(Value::Choice(name)),
        AnyValue::Flag(on) => Some(Value::Flag(on)),
        AnyValue::Colour(colour) => Some(Value::Colour(colour)),
        AnyValue::Seed(n) => Some(Value::Seed(n)),
        AnyValue::Text(_) => None,
    }
}

/// Whether the objects of two scenes differ. The properties of the first source are parameters.
pub fn differ(now: &Scene, before: &Scene) -> bool {
    let (now, before) = (now.objects(), before.objects());
    now.len() != before.len()
        || now.zip(before).any(|(object, other)| {
            (object.id, object.kind.name) != (other.id, other.kind.name)
                || !object.is_first_source() && !has_values_of(object, other)
        })
}

/// Whether the properties of `object` have the values of `other`, or the defaults where the model
/// of `other` has no such property.
fn has_values_of(object: Object<'_>, other: Object<'_>) -> bool {
    object.properties().all(|(name, param, value)| {
        let mut others = other.properties();
        let same = others.find(|(known, ..)| *known == name);
        value
            == same.map_or(param.any_domain(object.model()).default, |(.., value)| {
                value
            })
    })
}

/// The name of an object in a list: "Source 1", "Solid 2 · wood line".
pub fn name_of(object: Object<'_>) -> String {
    let (first, rest) = object.kind.name.split_at(1);
    let text = format!("{}{rest} {}", first.to_uppercase(), object.id);
    let choice = |wanted: &str| {
        let mut all = object.properties();
        let (.., value) = all.find(|(name, ..)| *name == wanted)?;
        Some(value.to_string())
    };
    let (Some(shape), Some(material)) = (choice("shape"), choice("material")) else {
        return text;
    };
    let material = match &*material {
        "none" => "invisible",
        name => name,
    };
    format!("{text} · {material} {shape}")
}
