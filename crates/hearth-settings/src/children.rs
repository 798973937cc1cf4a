//! Children of the element: objects that a page states in HTML, laid over the objects of the settings.
//!
//! The element sends its children as a list: `{"id": 1001, "kind": "solid", "values": {"x": 0.1}, "changed":
//! ["x"]}`. `id` is the number of the child and, if it is free, the id of its object. `values` are what the child
//! states; without them, the child has no object now. `changed` names what it states anew: another property keeps
//! what a call has set, and an object that a call has removed stays away.
//!
//! Settings have a list of the children that they know: `child`, the number; `id`, that of its object; `stated`, the
//! names of the properties that it states; `replaced`, what it has replaced in the source of the settings.
//!
//! The first child that is a source replaces the source of the settings, until the last such child leaves.

use crate::apply::fields;
use crate::file::CHILDREN;
use crate::settings::Settings;
use crate::untrusted::{Untrusted, ValidationError};
use hearth_core::Scene;
use hearth_core::params::Input;
use hearth_core::scene::Kind;

/// A value by the name of a property.
type Field = (String, Untrusted);

/// A number of a child.
fn number(child: &Untrusted, field: &str) -> u32 {
    child.field(field).number() as u32
}

/// Whether a child of the element's list is a source.
fn is_source(sent: &Untrusted) -> bool {
    sent.field("kind").text() == Kind::SOURCE.name
}

/// The child of a list with this number.
fn find<'a>(list: &'a [Untrusted], field: &str, wanted: u32) -> Option<&'a Untrusted> {
    list.iter().find(|child| number(child, field) == wanted)
}

/// The kind of an object.
fn kind_of(scene: &Scene, id: u32) -> Option<&'static Kind> {
    let found = scene.objects().find(|object| object.id == id);
    found.map(|object| object.kind)
}

/// Removes an object, unless a call has removed it.
fn remove(scene: &mut Scene, id: u32) {
    if kind_of(scene, id).is_some() {
        let removed = scene.remove(id);
        debug_assert!(removed.is_ok());
    }
}

/// Properties of an object or, without the object, of the next source.
fn properties(scene: &Scene, id: u32, names: &mut dyn Iterator<Item = &str>) -> Vec<Field> {
    let mut fields = Vec::new();
    for name in names {
        let object = scene.objects().find(|object| object.id == id);
        let value = match object {
            Some(object) => {
                let found = object.properties().find(|(known, ..)| *known == name);
                found.map(|(.., value)| value)
            }
            None => {
                let property = Kind::SOURCE.property(name);
                property.and_then(|property| scene.settings().get(property.id))
            }
        };
        let value = value.map_or(Untrusted::Null, Untrusted::of_value);
        fields.push(Untrusted::named(name, value));
    }
    fields
}

/// Changes an object, or adds one, without the properties that are refused; appends an error for each. Returns
/// the id of the object, if there is one.
fn lay(
    scene: &mut Scene,
    id: Option<u32>,
    kind: &str,
    properties: &[Field],
    at: usize,
    errors: &mut Vec<ValidationError>,
) -> Option<u32> {
    let mut inputs = fields(properties);
    if id.is_none() {
        inputs.push(("kind", Input::Text(kind)));
    }
    let mut refused = Vec::new();
    let id = scene.lay(id, &inputs, &mut refused);
    for mut error in refused {
        let name = error.id.split_once('.').map_or("objects", |(_, name)| name);
        let sent = properties.iter().find(|(known, _)| known == name);
        error.id = format!("{CHILDREN}[{at}].{name}");
        let sent = sent.map_or(&Untrusted::Missing, |(_, value)| value);
        errors.push(ValidationError::of_parameter(&error, sent));
    }
    id
}

/// A known child.
fn known(number: u32, id: u32, stated: String, replaced: Untrusted) -> Untrusted {
    Untrusted::Object(vec![
        Untrusted::named("child", Untrusted::Number(number.into())),
        Untrusted::named("id", Untrusted::Number(id.into())),
        Untrusted::named("stated", Untrusted::Text(stated)),
        Untrusted::named("replaced", replaced),
    ])
}

impl Settings {
    /// The settings with this list of children laid over the objects, and an error for each value that is refused.
    pub fn with_children(&self, list: &[Untrusted], errors: &mut Vec<ValidationError>) -> Settings {
        let mut scene = self.scene().clone();
        let old = self.children.list();
        // The first source among the children that stay, and what it replaces after the last one has left.
        let stays =
            |child: &&Untrusted| find(list, "id", number(child, "child")).is_some_and(is_source);
        let mut source = old.iter().find(stays).map(|child| number(child, "child"));
        let mut inherited = None;
        for child in old {
            if find(list, "id", number(child, "child")).is_some() {
                continue;
            }
            let id = number(child, "id");
            let Untrusted::Object(replaced) = child.field("replaced") else {
                remove(&mut scene, id);
                continue;
            };
            let exists = kind_of(&scene, id).is_some_and(Kind::is_of_parameters);
            let mut restored = scene.clone();
            let mut fields = replaced.clone();
            if !exists {
                fields.push(Untrusted::named("id", Untrusted::Number(id.into())));
            }
            let id = exists.then_some(id);
            let laid = lay(&mut restored, id, Kind::SOURCE.name, &fields, 0, errors);
            if let (Some(source), Some(laid)) = (source, laid) {
                let mut names = Kind::SOURCE.names.iter().copied();
                inherited = Some((source, properties(&restored, laid, &mut names)));
                id.into_iter().for_each(|id| remove(&mut scene, id));
            } else {
                scene = restored;
            }
        }
        let mut children = Vec::new();
        for (at, sent) in list.iter().enumerate() {
            let (child, kind) = (number(sent, "id"), sent.field("kind").text());
            let before = find(old, "child", child);
            let mut id = before.map_or(child, |before| number(before, "id"));
            let mut replaced = before.map_or(Untrusted::Missing, |it| it.field("replaced").clone());
            if let Some((source, values)) = &inherited
                && *source == child
            {
                replaced = Untrusted::Object(values.clone());
            }
            if is_source(sent) {
                let mut objects = scene.objects();
                let first = objects.find(|object| object.is_first_source());
                if before.is_none()
                    && source.is_none()
                    && let Some(first) = first
                    && find(old, "id", first.id)
                        .is_none_or(|old| find(list, "id", number(old, "child")).is_none())
                {
                    id = first.id;
                    replaced = Untrusted::Object(Vec::new());
                }
                source = Some(child);
            }
            let exists = kind_of(&scene, id).is_some_and(|known| known.name == kind);
            let mut stated = String::new();
            if let Untrusted::Object(values) = sent.field("values") {
                let mut names = values.iter().map(|(name, _)| name.as_str());
                let now = properties(&scene, id, &mut names);
                for (name, value) in now {
                    stated.push_str(&name);
                    stated.push(' ');
                    if let Untrusted::Object(replaced) = &mut replaced
                        && replaced.iter().all(|(known, _)| *known != name)
                    {
                        replaced.push((name, value));
                    }
                }
                let changed = sent.field("changed").list();
                let is_of_settings = !replaced.is_missing();
                if exists {
                    let mut fields = Vec::new();
                    for name in changed {
                        let name = name.text();
                        let mut all = values.iter().chain(replaced.fields());
                        match all.find(|(known, _)| known == name) {
                            Some(field) => fields.push(field.clone()),
                            None if is_of_settings => {}
                            None => fields.push(Untrusted::named(name, Untrusted::Null)),
                        }
                    }
                    // Settings of the same page hold the object of a new child.
                    if before.is_some() || is_of_settings {
                        lay(&mut scene, Some(id), kind, &fields, at, errors);
                    }
                } else if before.is_none() || !changed.is_empty() {
                    let mut fields = values.clone();
                    // Another object may have its id.
                    if kind_of(&scene, id).is_none() {
                        fields.push(Untrusted::named("id", Untrusted::Number(id.into())));
                    }
                    let Some(laid) = lay(&mut scene, None, kind, &fields, at, errors) else {
                        continue;
                    };
                    id = laid;
                }
            } else if exists {
                remove(&mut scene, id);
            }
            children.push(known(child, id, stated, replaced));
        }
        self.with_objects(scene, children)
    }

    /// These settings, which replace `old`, with the objects of its children. The first of them that is a source
    /// replaces what it states of the source of these.
    #[must_use]
    pub fn keeping_children(&self, old: &Settings) -> Settings {
        let (mut list, mut held) = (Vec::new(), Vec::new());
        let mut has_source = false;
        for child in old.children.list() {
            let id = number(child, "id");
            let kind = kind_of(old.scene(), id);
            let mut values = Untrusted::Null;
            let mut changed = Vec::new();
            if let Some(kind) = kind {
                let mut stated = child.field("stated").text().split_terminator(' ');
                let is_first = kind.is_of_parameters() && !has_source;
                has_source |= is_first;
                values = Untrusted::Object(match is_first {
                    true => properties(old.scene(), id, &mut stated),
                    false => properties(old.scene(), id, &mut kind.names.iter().copied()),
                });
                let same = kind_of(self.scene(), id).is_some_and(|same| same.name == kind.name);
                if same && child.field("replaced").is_missing() {
                    held.push(child.clone());
                } else {
                    let names = values.fields().iter();
                    changed = names
                        .map(|(name, _)| Untrusted::Text(name.clone()))
                        .collect();
                }
            }
            let kind = kind.unwrap_or(Kind::SOLID).name.to_owned();
            list.push(Untrusted::Object(vec![
                Untrusted::named("id", child.field("child").clone()),
                Untrusted::named("kind", Untrusted::Text(kind)),
                Untrusted::named("changed", Untrusted::List(changed)),
                Untrusted::named("values", values),
            ]));
        }
        let mut settings = self.clone();
        settings.children = Untrusted::List(held);
        settings.with_children(&list, &mut Vec::new())
    }

    /// These settings with other objects, and these known children among them, in their order.
    fn with_objects(&self, mut scene: Scene, children: Vec<Untrusted>) -> Settings {
        let ids = children
            .iter()
            .map(|child| child.field("id").number() as u32);
        scene.arrange(&ids.collect::<Vec<_>>());
        let mut settings = self.with(scene, self.resolution);
        settings.children = Untrusted::List(children);
        settings
    }
}
