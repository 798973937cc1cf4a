//! Scenes of objects, and their names.

use hearth_core::params::{AnyValue, Input, Model, Parameters, Property, Value};
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

/// Whether a property has a row in `model`.
pub fn has_row(property: Property, model: Model) -> bool {
    property.param(model).is_some()
}

fn find(scene: &Scene, subject: Subject) -> Option<AnyValue<'_>> {
    let owner = subject.object?;
    let mut all = scene.objects();
    let object = all.find(|one| one.id == owner.id && one.kind.name == owner.kind)?;
    let mut values = object.properties();
    let (.., value) = values.find(|(name, ..)| *name == owner.property)?;
    Some(value)
}

/// The text of a property in a scene; none of a property with another value.
pub fn text_in(scene: &Scene, subject: Subject) -> Option<&str> {
    match find(scene, subject)? {
        AnyValue::Text(text) => Some(text),
        _ => None,
    }
}

/// The value of a property in a scene; none of a text, which [`text_in`] reads.
pub fn value_in(scene: &Scene, subject: Subject) -> Option<Value> {
    match find(scene, subject)? {
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
                || object.name() != other.name()
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

/// An object in a list: "Source 1", "Solid 2 · wood line", "Back log · Solid 3 · off".
pub fn name_of(object: Object<'_>) -> String {
    let (first, rest) = object.kind.name.split_at(1);
    let numbered = format!("{}{rest} {}", first.to_uppercase(), object.id);
    let text = match (object.name(), object.solid()) {
        ("", None) => numbered,
        ("", Some(solid)) => {
            let material = match solid.material.name() {
                "none" => "invisible",
                name => name,
            };
            format!("{numbered} · {material} {}", solid.shape.name())
        }
        (name, _) => format!("{name} · {numbered}"),
    };
    match is_on(object) {
        true => text,
        false => text + " · off",
    }
}

/// Whether an object acts and is drawn.
pub fn is_on(object: Object<'_>) -> bool {
    let source = object.source().is_none_or(|source| source.source_enabled);
    source && object.solid().is_none_or(|solid| solid.enabled)
}
