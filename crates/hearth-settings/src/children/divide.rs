//! What a call and a file change: the scene of the page, and what calls have set of its children.

use super::child::{Child, State, get, put};
use super::compose::{compose, first_source, object_of};
use crate::apply::{OBJECTS, free_id};
use crate::change::Change;
use crate::untrusted::Untrusted;
use hearth_core::Scene;
use hearth_core::params::Param;
use hearth_core::scene::{Kind, Object};

/// Divides the scene `after` a change of what burns into that of the page and what calls have set of children.
pub fn divide(
    page: &mut Scene,
    children: &mut [Child],
    change: &Change<'_>,
    (before, after): (&Scene, &Scene),
) {
    let first = first_source(children);
    let had_source = page.first_source_id().is_some();
    let hidden = page.first_source_id().filter(|_| first.is_some());
    page.set_world(after.world().clone());
    for child in &mut *children {
        let earlier = object_of(child, before);
        let Some(object) = object_of(child, after) else {
            if earlier.is_some() {
                child.state = State::Removed;
                child.called.clear();
                if let Some(id) = hidden.filter(|_| first == Some(child.number)) {
                    let removed = page.remove(id);
                    debug_assert_eq!(removed, Ok(()));
                }
            }
            continue;
        };
        let is_first = after.first_source_id() == Some(child.number);
        for (name, param, value) in object.properties() {
            let old = earlier.and_then(|old| old.properties().find(|(known, ..)| *known == name));
            let has_changed = old.is_none_or(|(_, _, old)| old != value);
            if has_changed && !is_of_model_alone(change, param)
                || names(change, child.number, is_first, name, param)
            {
                put(&mut child.called, name, Some(Untrusted::of_value(value)));
            }
        }
        if child.state == State::Removed {
            child.state = State::Live;
        }
    }
    let is_child = |id: u32| children.iter().any(|child| child.number == id);
    let is_gone = |id: &u32| Some(*id) != hidden && after.object(*id).is_none();
    for id in page.ids().filter(is_gone).collect::<Vec<_>>() {
        let removed = page.remove(id);
        debug_assert_eq!(removed, Ok(()));
    }
    let ids: Vec<_> = after.ids().filter(|id| !is_child(*id)).collect();
    for id in &ids {
        page.take(after, *id);
    }
    page.arrange(&ids);
    if !had_source && page.first_source_id().is_some() {
        for child in children {
            child.is_beside = child.kind == Kind::SOURCE.name;
        }
    }
}

/// Whether a change of the model, which changes other values too, is all that changes a property.
fn is_of_model_alone(change: &Change<'_>, param: &Param) -> bool {
    match change {
        Change::Set(values) | Change::SetModel(values, _) => values
            .iter()
            .all(|(id, _)| id != OBJECTS && *id != param.id),
        _ => false,
    }
}

/// Whether a change names a property of an object, which may be the first source.
fn names(change: &Change<'_>, id: u32, is_first: bool, name: &str, param: &Param) -> bool {
    match *change {
        Change::Set(values) | Change::SetModel(values, _) => {
            is_first && get(values, param.id).is_some_and(is_stated)
        }
        Change::ChangeObject(changed, fields) => {
            changed == id && get(fields, name).is_some_and(is_stated)
        }
        _ => false,
    }
}

fn is_stated(value: &Untrusted) -> bool {
    !value.is_missing()
}

/// Takes the objects of children out of another scene of the page.
pub fn detach_all(page: &mut Scene, children: &mut [Child], next_id: &mut u32) {
    for at in 0..children.len() {
        detach(page, children, at, next_id);
    }
}

/// Takes the object of the child at this index out of the scene of the page. What differs from what the child states
/// is what calls have set. The object of the first source leaves its place and its values to the child.
pub fn detach(page: &mut Scene, children: &mut [Child], at: usize, next_id: &mut u32) {
    let Some(child) = children
        .get(at)
        .filter(|child| object_of(child, page).is_some())
    else {
        return;
    };
    let number = child.number;
    let mut child = child.clone();
    (child.state, child.called) = (State::Live, Vec::new());
    if let Some(known) = children.get_mut(at) {
        *known = child.clone();
    }
    let is_first = first_source(children) == Some(number) && page.first_source_id() == Some(number);
    // A page without other objects, whose first source is that of the file.
    let mut plain = Scene::new(page.world().clone());
    plain.clear();
    if is_first {
        plain.take(page, number);
        plain.rename(number, 1);
    }
    let plain = compose(
        &plain,
        std::slice::from_ref(&child),
        &Scene::default(),
        &mut Vec::new(),
    );
    let [now, before] = [&*page, &plain].map(|scene| object_of(&child, scene));
    for (name, _, value) in now.into_iter().flat_map(Object::properties) {
        let mut known = before.into_iter().flat_map(Object::properties);
        if known.all(|(other, _, before)| other != name || before != value) {
            put(&mut child.called, name, Some(Untrusted::of_value(value)));
        }
    }
    if is_first {
        page.rename(number, *next_id);
        *next_id = free_id(page, *next_id);
    } else {
        let removed = page.remove(number);
        debug_assert_eq!(removed, Ok(()));
    }
    if let Some(known) = children.get_mut(at) {
        *known = child;
    }
}
