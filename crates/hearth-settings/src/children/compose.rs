//! What burns: the scene of a page with the objects of its children.

use super::child::{Child, State, get};
use crate::apply::input;
use crate::untrusted::{Untrusted, ValidationError};
use hearth_core::Scene;
use hearth_core::params::Input;
use hearth_core::scene::{Kind, Object};

/// A property of the child at this index is refused.
pub type Refused = (usize, String, ValidationError);

/// The first child that is a source and that no call has removed.
fn first(children: &[Child]) -> Option<&Child> {
    let mut children = children.iter();
    children.find(|child| child.kind == Kind::SOURCE.name && child.state != State::Removed)
}

/// The child that takes the place of the first source of a page: the first source, unless it burns beside them.
pub fn first_source(children: &[Child]) -> Option<u32> {
    let first = first(children).filter(|child| !child.is_beside);
    first.map(|child| child.number)
}

/// The object of a child in a scene.
pub fn object_of<'a>(child: &Child, scene: &'a Scene) -> Option<Object<'a>> {
    let object = scene.object(child.number);
    object.filter(|object| object.kind.name == child.kind)
}

/// A scene of a page with the objects of its children, those of `before` where nothing has changed.
pub fn compose(
    page: &Scene,
    children: &[Child],
    before: &Scene,
    refused: &mut Vec<Refused>,
) -> Scene {
    let mut scene = page.clone();
    let replaces = first_source(children);
    for (at, child) in children.iter().enumerate() {
        let base = page
            .first_source_id()
            .filter(|_| replaces == Some(child.number));
        if child.state != State::Live {
            if let Some(id) = base {
                let removed = scene.remove(id);
                debug_assert_eq!(removed, Ok(()));
            }
            continue;
        }
        let mut errors = Vec::new();
        let has_base = base.is_some_and(|id| scene.rename(id, child.number));
        let is_free = scene.object(child.number).is_none();
        let known = object_of(child, before).filter(|known| is_free && known.solid().is_some());
        if known.is_some() {
            // It keeps the distances to its outline.
            scene.take(before, child.number);
        }
        let head = [
            ("kind", Input::Text(&child.kind)),
            ("id", Input::Number(child.number.into())),
        ];
        if !has_base && known.is_none() && scene.apply_fields(None, &head, &mut errors).is_none() {
            refused.extend(errors.iter().map(|error| child.refusal(at, error)));
            continue;
        }
        let null = &Untrusted::Null;
        let value = |name: &str| child.value(name).or((!has_base).then_some(null));
        let names = child.properties(page.model());
        let fields: Vec<_> = names
            .filter_map(|name| Some((name, input(value(name)?))))
            .collect();
        scene.apply_fields(Some(child.number), &fields, &mut errors);
        for error in errors {
            let (at, name, error) = child.refusal(at, &error);
            match get(&child.stated, &name) {
                // What a call has set is in the range of another model.
                Some(stated) if get(&child.called, &name).is_some() => {
                    let stated = [(name.as_str(), input(stated))];
                    scene.apply_fields(Some(child.number), &stated, &mut Vec::new());
                }
                Some(_) => refused.push((at, name, error)),
                None => {}
            }
        }
    }
    // It stays the first source of the scene, which parameters name.
    if let Some(first) = first(children).filter(|child| child.is_beside) {
        let others = scene.ids().filter(|id| *id != first.number);
        let ids: Vec<_> = [first.number].into_iter().chain(others).collect();
        scene.arrange(&ids);
    }
    scene
}
