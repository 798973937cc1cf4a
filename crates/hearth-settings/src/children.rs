//! Children of the element: objects that a page states in HTML.
//!
//! The element sends its children as a list: `{"id": 1001, "kind": "solid", "values": {"x": 0.1}, "changed":
//! ["x"]}`. `id` is the number of the child and the id of its object. `values` are what the child states; without
//! them, the child has no object now. `changed` names what it states anew: another property keeps what a call has set,
//! and an object that a call has removed stays away.
//!
//! What burns is the scene of the page [composed](compose) with the children: an object for each child, with the
//! defaults of what neither the child nor a call has set. The first child that is a source takes the place of the first
//! source of the page, and has its values instead of the defaults. A call changes what burns; [`divide`] divides the
//! result into the scene of the page and what calls have set of children. [`detach`] makes objects of a file the
//! children that they are.

pub(crate) mod child;

use crate::apply::{OBJECTS, input};
use crate::settings::{Change, Settings};
use crate::untrusted::{Untrusted, ValidationError};
use child::{Child, State, get, put};
use hearth_core::Scene;
use hearth_core::params::{Input, Param};
use hearth_core::scene::{Kind, Object};

/// A property of the child at this index is refused.
type Refused = (usize, String, ValidationError);

/// The child that takes the place of the first source of a page: the first one that is a source and that no call has
/// removed.
fn first_source(children: &[Child]) -> Option<u32> {
    let mut sources = children.iter();
    let first =
        sources.find(|child| child.kind == Kind::SOURCE.name && child.state != State::Removed);
    first.map(|child| child.number)
}

/// The object of a child in a scene.
fn object_of<'a>(child: &Child, scene: &'a Scene) -> Option<Object<'a>> {
    let object = scene.object(child.number);
    object.filter(|object| object.kind.name == child.kind)
}

/// A scene of a page with the objects of its children, those of `before` where nothing has changed.
pub(crate) fn compose(
    page: &Scene,
    children: &[Child],
    before: &Scene,
    refused: &mut Vec<Refused>,
) -> Scene {
    let mut scene = page.clone();
    let first = first_source(children);
    for (at, child) in children.iter().enumerate() {
        let base = page
            .first_source_id()
            .filter(|_| first == Some(child.number));
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
        if !has_base && known.is_none() && scene.lay(None, &head, &mut errors).is_none() {
            refused.extend(errors.iter().map(|error| child.refusal(at, error)));
            continue;
        }
        let null = &Untrusted::Null;
        let value = |name: &str| child.value(name).or((!has_base).then_some(null));
        let names = child.properties(page.model());
        let fields: Vec<_> = names
            .filter_map(|name| Some((name, input(value(name)?))))
            .collect();
        scene.lay(Some(child.number), &fields, &mut errors);
        for error in errors {
            let (at, name, error) = child.refusal(at, &error);
            match get(&child.stated, &name) {
                // What a call has set is in the range of another model.
                Some(stated) if get(&child.called, &name).is_some() => {
                    let stated = [(name.as_str(), input(stated))];
                    scene.lay(Some(child.number), &stated, &mut Vec::new());
                }
                Some(_) => refused.push((at, name, error)),
                None => {}
            }
        }
    }
    scene
}

/// Divides the scene `after` a change of what burns into that of the page and what calls have set of children.
pub(crate) fn divide(settings: &mut Settings, change: &Change<'_>, after: &Scene) {
    let before = settings.scene().clone();
    let first = first_source(&settings.children);
    let mut page = settings.page.clone();
    let hidden = page.first_source_id().filter(|_| first.is_some());
    page.set_world(after.world().clone());
    for child in &mut settings.children {
        let earlier = object_of(child, &before);
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
    let is_child = |id: u32| settings.children.iter().any(|child| child.number == id);
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
    settings.page = page;
    let is_new = hidden.is_none() && settings.page.first_source_id().is_some();
    if let Some(first) = first_source(&settings.children).filter(|_| is_new) {
        // The first child has the place of a source before the one that a call has added.
        let (page, id) = (&mut settings.page, settings.next_id);
        page.take(after, first);
        if !page.rename(first, id) {
            let source = ("kind", Input::Text(Kind::SOURCE.name));
            page.lay(
                None,
                &[source, ("id", Input::Number(id.into()))],
                &mut Vec::new(),
            );
        }
        let others: Vec<_> = page.ids().filter(|other| *other != id).collect();
        page.arrange(&[&[id], others.as_slice()].concat());
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
pub(crate) fn detach_all(settings: &mut Settings) {
    let mut children = std::mem::take(&mut settings.children);
    for at in 0..children.len() {
        detach(settings, &mut children, at);
    }
    settings.children = children;
}

/// Takes the object of the child at this index out of the scene of the page. What differs from what the child states
/// is what calls have set. The object of the first source leaves its place and its values to the child.
fn detach(settings: &mut Settings, children: &mut [Child], at: usize) {
    let page = &mut settings.page;
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
        settings.next_id = settings.next_id.max(1);
        page.rename(number, settings.next_id);
        settings.next_id += 1;
    } else {
        let removed = page.remove(number);
        debug_assert_eq!(removed, Ok(()));
    }
    if let Some(known) = children.get_mut(at) {
        *known = child;
    }
}

impl Settings {
    /// Restores what calls have set of children.
    pub(crate) fn restore_children(&mut self, saved: &[Child]) {
        for before in saved {
            let known = self
                .children
                .iter_mut()
                .find(|known| known.number == before.number);
            if let Some(known) = known.filter(|known| known.kind == before.kind) {
                known.restore(before);
            }
        }
    }

    /// The settings with this list of children, and an error for each value that is refused: such a value stays as it
    /// was.
    pub fn with_children(&self, list: &[Untrusted], errors: &mut Vec<ValidationError>) -> Settings {
        let mut settings = self.clone();
        let mut children: Vec<Child> = Vec::new();
        let mut changes: Vec<Vec<String>> = Vec::new();
        for sent in list {
            let now = Child::read(sent);
            let is_hidden = !matches!(sent.field("values"), Untrusted::Object(_));
            let changed = sent.field("changed").list().iter();
            let changed: Vec<_> = changed.map(|name| name.text().to_owned()).collect();
            let known = self
                .children
                .iter()
                .find(|known| known.number == now.number);
            let (mut child, changed) = match known {
                Some(known) => {
                    let mut child = known.clone();
                    for name in changed.iter().filter(|_| !is_hidden) {
                        put(&mut child.stated, name, get(&now.stated, name).cloned());
                        put(&mut child.called, name, None);
                    }
                    if known.state == State::Hidden || !changed.is_empty() {
                        child.state = State::Live;
                    }
                    (child, changed)
                }
                None => {
                    let names = now.stated.iter().map(|(name, _)| name.clone()).collect();
                    (now, names)
                }
            };
            if is_hidden {
                child.state = State::Hidden;
            }
            if children.iter().all(|other| other.number != child.number) {
                children.push(child);
                changes.push(changed);
            }
        }
        for at in 0..children.len() {
            let is_new = |child: &Child| {
                self.children
                    .iter()
                    .all(|known| known.number != child.number)
            };
            if children.get(at).is_some_and(is_new) {
                detach(&mut settings, &mut children, at);
            }
        }
        let mut refused = Vec::new();
        compose(&settings.page, &children, self.scene(), &mut refused);
        for (at, name, error) in refused {
            let (Some(child), Some(changed)) = (children.get_mut(at), changes.get(at)) else {
                continue;
            };
            // Another model may have no use for what was stated before.
            if changed.contains(&name) || get(&child.stated, &name).is_none() {
                let known = self
                    .children
                    .iter()
                    .find(|known| known.number == child.number);
                let before = known.and_then(|known| get(&known.stated, &name));
                put(&mut child.stated, &name, before.cloned());
                errors.push(error);
            }
        }
        settings.children = children;
        settings.composed()
    }
}
