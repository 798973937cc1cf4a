//! Children of the element: objects that a page states in HTML.
//!
//! The element sends its children as a list: `{"id": 1001, "kind": "solid", "values": {"x": 0.1}, "changed":
//! ["x"]}`. `id` is the number of the child and the id of its object. `values` are what the child states; without
//! them, the child has no object now. `changed` names what it states anew: another property keeps what a call has set,
//! and an object that a call has removed stays away.
//!
//! What burns is the scene of the page [composed](compose::compose) with the children: an object for each child, with the
//! defaults of what neither the child nor a call has set. The first child that is a source takes the place of the first
//! source of the page, and has its values instead of the defaults. It takes no place where calls have added all sources of
//! the page since it came. A call changes what burns; [`divide`](divide::divide) divides the
//! result into the scene of the page and what calls have set of children. [`detach`] makes objects of a file the
//! children that they are.

pub(crate) mod child;
pub(crate) mod compose;
pub(crate) mod divide;

use crate::settings::Settings;
use crate::untrusted::{Untrusted, ValidationError};
use child::{Child, State, get, put};
use compose::compose;
use divide::detach;

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
                let (page, next_id) = (&mut settings.page, &mut settings.next_id);
                detach(page, &mut children, at, next_id);
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
