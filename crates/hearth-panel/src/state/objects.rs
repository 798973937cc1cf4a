//! Scenes of objects, and their names.

use hearth_core::params::{AnyValue, Input, Model, Property};
use hearth_core::scene::{Object, Scene};

use crate::browser_text::is_from_right;
use crate::state::entry::Entry;
use crate::state::subject::Subject;

/// The group of the objects, and its name for [`State::reveal`](crate::state::State::reveal).
pub const OBJECTS: &str = "Objects";

/// The name and the value of each field of an object.
pub type Fields = Vec<(String, Entry)>;

/// Gives a scene these objects and leaves its parameters. An object that is refused comes from another version of
/// the fire and is missing. Of objects that the scene has, only what differs is set, because the
/// distance from an outline takes milliseconds to sample.
pub fn update(scene: &mut Scene, objects: &[Fields]) {
    let wanted: Vec<_> = objects.iter().map(identity).collect();
    let is_wanted = |object: &Object<'_>| objects.iter().any(|fields| describes(fields, *object));
    let kept = scene.objects().filter(is_wanted);
    let mut kept: Vec<_> = kept.map(|object| (object.id, object.kind.name)).collect();
    // Objects of a scene are in the order in which they were added.
    if !wanted.starts_with(&kept) {
        kept.clear();
    }
    let all: Vec<u32> = scene.objects().map(|object| object.id).collect();
    for id in all {
        if !kept.iter().any(|(known, _)| *known == id) {
            let _ = scene.remove(id);
        }
    }
    for (index, (fields, (id, _))) in objects.iter().zip(wanted).enumerate() {
        let object = match index < kept.len() {
            true => scene.objects().find(|object| object.id == id),
            false => None,
        };
        let given: Vec<(&str, Input<'_>)> = fields
            .iter()
            .filter(|field| !object.is_some_and(|object| has(object, field)))
            .map(|(name, entry)| (name.as_str(), entry.input()))
            .collect();
        if object.is_none() {
            let _ = scene.add(&given);
        } else if !given.is_empty() && scene.change(id, &given).is_err() {
            let _ = scene.remove(id);
        }
    }
}

/// The id and the kind of an object.
fn identity(fields: &Fields) -> (u32, &str) {
    let (mut id, mut kind) = (0, "");
    for (name, entry) in fields {
        match (name.as_str(), entry) {
            ("id", Entry::Number(number)) => id = *number as u32,
            ("kind", Entry::Text(text)) => kind = text,
            _ => {}
        }
    }
    (id, kind)
}

/// Whether these are the fields of an object, all of its properties among them.
fn describes(fields: &Fields, object: Object<'_>) -> bool {
    let is_given = |name: &str| fields.iter().any(|(known, _)| known == name);
    identity(fields) == (object.id, object.kind.name)
        && object.properties().all(|(name, ..)| is_given(name))
}

/// Whether an object of the same identity has the value of a field.
fn has(object: Object<'_>, (name, entry): &(String, Entry)) -> bool {
    if matches!(name.as_str(), "id" | "kind") {
        return true;
    }
    let mut values = object.properties();
    let value = values.find(|(known, ..)| known == name);
    value.is_some_and(|(.., value)| Entry::from(value) == *entry)
}

/// Whether a property has a row in `model`.
pub fn has_row(property: Property, model: Model) -> bool {
    property.param(model).is_some()
}

/// The value of a property in a scene.
pub fn value_in(scene: &Scene, subject: Subject) -> Option<AnyValue<'_>> {
    let owner = subject.object?;
    let mut all = scene.objects();
    let object = all.find(|object| object.id == owner.id && object.kind.name == owner.kind)?;
    let mut values = object.properties();
    let (.., value) = values.find(|(name, ..)| *name == owner.property)?;
    Some(value)
}

/// Whether the objects of two scenes differ. The properties of the first source are parameters.
pub fn differ(now: &Scene, before: &Scene) -> bool {
    let first = now.first_source_id();
    now.objects().len() != before.objects().len()
        || now.objects().zip(before.objects()).any(|(object, other)| {
            (object.id, object.kind.name) != (other.id, other.kind.name)
                || object.name() != other.name()
                || first != Some(object.id) && !has_values_of(object, other)
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
    let (initial, tail) = object.kind.name.split_at(1);
    let numbered = format!("{}{tail} {}", initial.to_uppercase(), object.id);
    let text = match (object.name(), object.solid()) {
        ("", None) => numbered,
        ("", Some(solid)) => {
            let material = match solid.material.name() {
                "none" => "invisible",
                name => name,
            };
            format!("{numbered} · {material} {}", solid.shape.name())
        }
        // Isolated, a name from right to left keeps the words behind it in their order.
        (name, _) if is_from_right(name) => format!("\u{2068}{name}\u{2069} · {numbered}"),
        (name, _) => format!("{name} · {numbered}"),
    };
    match is_on(object) {
        true => text,
        false => text + " · off",
    }
}

/// Whether an object acts and is drawn.
pub fn is_on(object: Object<'_>) -> bool {
    let source = object.source().is_none_or(|source| source.enabled);
    source && object.solid().is_none_or(|solid| solid.enabled)
}
