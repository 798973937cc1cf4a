//! Objects of children: how they are laid over a scene, and taken out of it.

use super::child::{Child, Field, State, first_source, get, put};
use crate::apply::fields;
use crate::file::CHILDREN;
use crate::untrusted::{Untrusted, ValidationError};
use hearth_core::Scene;
use hearth_core::params::Input;
use hearth_core::scene::{Kind, Object};

/// A child with the names of the properties that change in its object.
pub type Changed = (Child, Vec<String>);

/// A property of the child at this index is refused.
pub type Refused = (usize, String, ValidationError);

/// The properties of an object; of a source, those that the other model alone uses, too.
pub fn values(object: Object<'_>) -> Vec<Field> {
    let Some(source) = object.source() else {
        let properties = object.properties();
        let field = |(name, _, value)| Untrusted::named(name, Untrusted::of_value(value));
        return properties.map(field).collect();
    };
    let properties = object.kind.properties().map(|property| {
        let value = source.get(property.id).map(Untrusted::of_value);
        let value = value.unwrap_or_else(|| Untrusted::Text(object.name().to_owned()));
        Untrusted::named(property.name, value)
    });
    properties.collect()
}

/// The properties of an object that differ from those of another one of its kind.
pub fn differences(now: Object<'_>, before: Object<'_>) -> Vec<Field> {
    let both = values(now).into_iter().zip(values(before));
    let differing = both.filter(|(now, before)| now != before);
    differing.map(|(now, _)| now).collect()
}

pub fn remove(scene: &mut Scene, id: u32) {
    let removed = scene.remove(id);
    debug_assert!(removed.is_ok());
}

pub fn ids(scene: &Scene) -> Vec<u32> {
    scene.objects().map(|object| object.id).collect()
}

pub fn has_source(scene: &Scene) -> bool {
    scene.objects().any(|object| object.source().is_some())
}

/// Puts objects into this order, and others behind them.
pub fn arrange(scene: &mut Scene, order: &[u32]) {
    let mut all = order.to_vec();
    all.extend(ids(scene).iter().filter(|id| !order.contains(id)));
    scene.arrange(&all);
}

/// Changes an object or, without an id, adds one. Returns its id, if there is one. A refused property is what the
/// child states, if a call has set it, and else as it was.
pub fn lay(
    scene: &mut Scene,
    id: Option<u32>,
    (at, child): (usize, &Child),
    values: &[Field],
    refused: &mut Vec<Refused>,
) -> Option<u32> {
    let mut inputs = fields(values);
    if id.is_none() {
        inputs.push(("kind", Input::Text(&child.kind)));
        if child.object != 0 && !ids(scene).contains(&child.object) {
            inputs.push(("id", Input::Number(child.object.into())));
        }
    }
    let mut errors = Vec::new();
    let id = scene.lay(id, &inputs, &mut errors);
    for mut error in errors {
        let name = error.id.split_once('.').map_or("objects", |(_, name)| name);
        let name = name.to_owned();
        let stated = get(&child.stated, &name);
        if get(&child.called, &name).is_some() {
            let stated = stated.map(|value| (name.as_str(), value.input()));
            scene.lay(id, stated.as_slice(), &mut Vec::new());
            continue;
        }
        error.id = format!("{CHILDREN}[{at}].{name}");
        let error = ValidationError::of_parameter(&error, stated.unwrap_or(&Untrusted::Missing));
        refused.push((at, name, error));
    }
    id
}

/// Children laid over the scene of the page. Solids of `burning`, the scene before, keep the distances to their
/// outlines.
pub fn lay_over(
    own: &Scene,
    children: &mut [Changed],
    burning: &Scene,
    refused: &mut Vec<Refused>,
) -> Scene {
    let mut scene = own.clone();
    let first = first_source(children.iter().map(|(child, _)| child));
    // Without another source, the first one has the values of the settings, and the others have the defaults.
    let mut turns: Vec<_> = (0..children.len()).collect();
    if let Some(at) = children.iter().position(|(child, _)| child.is(first)) {
        turns[..=at].rotate_right(1);
    }
    for at in turns {
        let Some((child, changes)) = children.get_mut(at) else {
            continue;
        };
        let source = child.source_of(own, first);
        let id = source.map(|source| source.id);
        child.object = id.unwrap_or(match child.object {
            0 => child.number,
            object => object,
        });
        if child.state != State::Live {
            let hidden = id.filter(|_| child.state == State::Hidden);
            hidden.into_iter().for_each(|id| remove(&mut scene, id));
            continue;
        }
        let is_solid = child.kind == Kind::SOLID.name;
        let copied = match child.burning(burning) {
            Some(object) if is_solid => scene.copy(burning, object.id),
            _ if is_solid || child.is(first) => None,
            _ => alone(own, child).and_then(|(alone, id)| scene.copy(&alone, id)),
        };
        let values = match copied {
            Some(_) if is_solid => child.values_of(changes),
            _ => child.values(),
        };
        let laid = lay(&mut scene, id.or(copied), (at, child), &values, refused);
        child.object = laid.unwrap_or_default();
    }
    scene
}

/// A scene with the object of a child that has the defaults.
pub fn alone(own: &Scene, child: &Child) -> Option<(Scene, u32)> {
    let mut scene = own.clone();
    scene.clear();
    let other = Input::Number(f64::from(child.object) + 1.0);
    let other = [("kind", Input::Text(Kind::SOURCE.name)), ("id", other)];
    scene.lay(None, &other, &mut Vec::new());
    let id = lay(&mut scene, None, (0, child), &[], &mut Vec::new())?;
    Some((scene, id))
}

/// Takes the object of a child out of a scene, which is that of the same page. What differs from what burns or, without
/// such an object, from what the child states, is what calls have set. Returns the names of these properties.
pub fn take(own: &mut Scene, child: &mut Child, burning: &Scene) -> Vec<String> {
    let Some(now) = child.find(own) else {
        return Vec::new();
    };
    let found = match child.burning(burning) {
        Some(before) => differences(now, before),
        None => {
            child.called.clear();
            let alone = alone(own, child).map(|(mut alone, id)| {
                lay(
                    &mut alone,
                    Some(id),
                    (0, child),
                    &child.stated,
                    &mut Vec::new(),
                );
                alone
            });
            let before = alone.as_ref().and_then(|alone| alone.objects().last());
            before.map_or(Vec::new(), |before| differences(now, before))
        }
    };
    for (name, value) in &found {
        put(&mut child.called, name, Some(value.clone()));
    }
    remove(own, child.object);
    found.into_iter().map(|(name, _)| name).collect()
}
