//! Children of the element: objects that a page states in HTML, laid over the settings.
//!
//! The element sends its children as a list: `{"id": 1001, "kind": "solid", "values": {"x": 0.1}, "changed":
//! ["x"]}`. `id` is the number of the child and, if it is free, the id of its object. `values` are what the child
//! states; without them, the child has no object now. `changed` names what it states anew: another property keeps
//! what a call has set, and an object that a call has removed stays away.
//!
//! Settings with children have two scenes. One is that of the page without them, which presets, files and undo replace.
//! The other one burns: it follows from the first one, what each child states and what calls have set of it since. So
//! undo restores what a call did, and never what a page states.
//!
//! The first child that is a source, by its number, is laid over the first source of the page. Without one, it has the
//! values of the settings. Every other child has the defaults of what it does not state.

mod child;
mod laying;
pub(crate) mod overlay;

use crate::file::CHILDREN;
use crate::settings::Settings;
use crate::untrusted::{Untrusted, ValidationError};
use child::{Child, State, find, first_source, get, put};
use hearth_core::Scene;
use laying::{Changed, ids, take};
use overlay::{Children, Overlay, in_document_order, laid};

impl Settings {
    /// The settings with this list of children laid over them, and an error for each value that is refused: such a value
    /// stays as it was.
    pub fn with_children(&self, list: &[Untrusted], errors: &mut Vec<ValidationError>) -> Settings {
        let (mut own, known) = match &self.children {
            Some(children) => (children.own().clone(), children.list()),
            None => (self.scene().clone(), &[] as &[Child]),
        };
        let bare = Scene::new(own.settings().clone());
        let mut children: Vec<Changed> = Vec::new();
        for sent in list {
            let mut child = Child::read(sent);
            let is_hidden = !matches!(sent.field("values"), Untrusted::Object(_));
            let changed = sent.field("changed").list().iter();
            let mut changes: Vec<_> = changed.map(|name| name.text().to_owned()).collect();
            if let Some(before) = find(known, child.number) {
                let now = std::mem::replace(&mut child, before.clone());
                for name in changes.iter().filter(|_| !is_hidden) {
                    put(&mut child.stated, name, get(&now.stated, name).cloned());
                    put(&mut child.called, name, None);
                }
                if before.state == State::Hidden || !changes.is_empty() {
                    child.state = State::Live;
                }
            } else {
                changes = child.stated.iter().map(|(name, _)| name.clone()).collect();
                child.object = child.number;
                take(&mut own, &mut child, &bare);
            }
            if is_hidden {
                child.state = State::Hidden;
            }
            children.push((child, changes));
        }
        let first = first_source(children.iter().map(|(child, _)| child));
        let before = first_source(known.iter());
        for (child, _) in children.iter_mut().filter(|_| first != before) {
            if child.is(first) {
                child.object = 0;
            } else if child.is(before) {
                child.object = child.number;
            }
        }
        let order = ids(self.scene());
        let before = (self.scene(), order.as_slice());
        let mut refused = Vec::new();
        let mut laid_over = laid(own.clone(), children.clone(), before, &mut refused);
        let mut is_restored = false;
        for (at, (child, changes)) in children.iter_mut().enumerate() {
            for (_, name, error) in refused.iter().filter(|(index, ..)| *index == at) {
                let is_new = changes.contains(name);
                if get(&child.stated, name).is_some() {
                    // The present model may have no value that was stated before.
                    if !is_new {
                        continue;
                    }
                    let before = find(known, child.number);
                    let before = before.and_then(|before| get(&before.stated, name));
                    put(&mut child.stated, name, before.cloned());
                    is_restored = true;
                }
                errors.push(error.clone());
            }
        }
        let numbers = children.iter().map(|(child, _)| child.number);
        let is_in_order = numbers.eq(known.iter().map(|child| child.number));
        if is_restored {
            laid_over = laid(own, children, before, &mut Vec::new());
        }
        self.burning(match is_in_order {
            true => laid_over,
            false => in_document_order(laid_over),
        })
    }

    /// The settings of a file with its children, whose list the element sends next.
    ///
    /// # Errors
    /// All validation errors.
    pub fn with_children_of_file(config: &Untrusted) -> Result<Settings, Vec<ValidationError>> {
        let settings = Settings::of_file(config)?;
        let mut list: Vec<Child> = Vec::new();
        for child in config.field(CHILDREN).list().iter().map(Child::read) {
            if find(&list, child.number).is_none() {
                list.push(child);
            }
        }
        let own = settings.scene().clone();
        let nothing = Scene::new(settings.parameters().clone());
        let children = Children {
            own: own.clone(),
            list,
        };
        let laid = children.over(own, &nothing, Some(config));
        Ok(settings.burning(laid))
    }
}
