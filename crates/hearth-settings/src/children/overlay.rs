//! Calls and other settings under children.

use super::child::{Child, State, find, first_source, get, put};
use super::laying::{
    Changed, Refused, arrange, differences, has_source, ids, lay, lay_over, remove, take, values,
};
use crate::apply::{fields, of_model};
use crate::file::{CHILDREN, ORDER};
use crate::untrusted::Untrusted;
use hearth_core::Scene;
use hearth_core::scene::Object;
use std::fmt;
use std::sync::Arc;

/// A scene that burns, with the children in it.
pub type Laid = (Scene, Option<Arc<dyn Overlay>>);

/// Children laid over the scene of a page.
pub trait Overlay: Send + Sync {
    /// The scene of the page.
    fn own(&self) -> &Scene;
    /// The children.
    fn list(&self) -> &[Child];
    /// Whether both are the same.
    fn equals(&self, other: &dyn Overlay) -> bool;
    /// The children and the order of the objects that burn, as whole settings have them.
    fn write(&self, burning: &Scene) -> [Untrusted; 2];
    /// A scene that a call has made from `burning`: what it has set or removed of a child is that of the child, and the
    /// rest that of the page.
    fn divided(&self, scene: Scene, burning: &Scene) -> Laid;
    /// Another scene of the page with these children. Whole settings have what calls have set of them; others of the
    /// same page may have their objects.
    fn over(&self, other: Scene, burning: &Scene, whole: Option<&Untrusted>) -> Laid;
}

impl fmt::Debug for dyn Overlay {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("children")
    }
}

/// The children of a page over its scene.
pub struct Children {
    pub own: Scene,
    pub list: Vec<Child>,
}

/// Children laid over `own`. Solids of `burning`, the scene before, keep the distances to their outlines. Objects have
/// the order of these ids, and others are the last ones.
pub fn laid(
    mut own: Scene,
    mut children: Vec<Changed>,
    (burning, order): (&Scene, &[u32]),
    refused: &mut Vec<Refused>,
) -> Laid {
    // The seeds of sources follow from their order.
    own.set_settings(own.settings().clone());
    if children.is_empty() {
        return (own, None);
    }
    let mut scene = lay_over(&own, &mut children, burning, refused);
    let mut order = order.to_vec();
    // A source of the page that a child hid returns to its place.
    let mut place = 0;
    for id in ids(&own) {
        let known = order.iter().position(|known| *known == id);
        place = known.unwrap_or_else(|| {
            order.insert(place, id);
            place
        }) + 1;
    }
    arrange(&mut scene, &order);
    scene.set_settings(scene.settings().clone());
    let list = children.into_iter().map(|(child, _)| child).collect();
    (scene, Some(Arc::new(Children { own, list })))
}

/// Children with objects in the order of the document.
pub fn in_document_order((mut scene, children): Laid) -> Laid {
    if let Some(children) = &children {
        let live = children
            .list()
            .iter()
            .filter(|child| child.state == State::Live);
        let objects: Vec<_> = live.map(|child| child.object).collect();
        scene.arrange(&objects);
        scene.set_settings(scene.settings().clone());
    }
    (scene, children)
}

impl Overlay for Children {
    fn own(&self) -> &Scene {
        &self.own
    }

    fn list(&self) -> &[Child] {
        &self.list
    }

    fn equals(&self, other: &dyn Overlay) -> bool {
        self.own == *other.own() && self.list == other.list()
    }

    fn write(&self, burning: &Scene) -> [Untrusted; 2] {
        let list = self.list.iter().map(Child::write).collect();
        let ids: Vec<_> = ids(burning).iter().map(u32::to_string).collect();
        [Untrusted::List(list), Untrusted::Text(ids.join(" "))]
    }

    fn divided(&self, mut scene: Scene, burning: &Scene) -> Laid {
        let [before, now] = [burning, &scene].map(|scene| scene.settings().model());
        let mut own = scene.clone();
        // Of the other model, values differ without a change.
        own.set_settings(of_model(own.settings(), before));
        let mut children = self.list.clone();
        let first = first_source(children.iter());
        let (mut frozen, mut is_kept) = (Vec::new(), false);
        for child in &mut children {
            let source = child.source_of(&self.own, first);
            let Some(before) = child.burning(burning) else {
                // The parameters of a source that a child hides are those of the page.
                if let (Some(source), State::Hidden) = (source, child.state) {
                    let values = [Untrusted::named(
                        "name",
                        Untrusted::Text(source.name().into()),
                    )];
                    let kept = match has_source(&own) {
                        true => own.copy(&self.own, child.object),
                        false => lay(&mut own, None, (0, child), &values, &mut Vec::new()),
                    };
                    child.object = kept.unwrap_or_default();
                    is_kept = true;
                }
                continue;
            };
            let Some(now) = child.find(&own) else {
                child.state = State::Removed;
                child.called.clear();
                continue;
            };
            for (name, value) in differences(now, before) {
                if source.is_none() || get(&child.values(), &name).is_some() {
                    put(&mut child.called, &name, Some(value));
                }
            }
            let Some(source) = source else {
                if child.is(first) {
                    frozen = values(now);
                }
                remove(&mut own, child.object);
                continue;
            };
            let mut of_page = values(source);
            of_page.retain(|(name, _)| get(&child.values(), name).is_some());
            own.lay(Some(child.object), &fields(&of_page), &mut Vec::new());
        }
        let mut sources = burning.objects().filter(Object::is_first_source);
        if sources.any(|source| children.iter().any(|child| child.object == source.id)) {
            own.keep_source_of(&self.own);
        }
        if is_kept {
            arrange(&mut own, &ids(&self.own));
        }
        own.set_settings(of_model(own.settings(), now));
        // The values that the first source has from the settings without a source stay when they get or lose one.
        let is_same = has_source(&own) == has_source(&self.own);
        let mut all = children.iter_mut().filter(|_| !is_same);
        if let Some(child) = all.find(|child| child.is(first)) {
            for (name, value) in frozen {
                if get(&child.stated, &name).is_none() {
                    put(&mut child.called, &name, Some(value));
                }
            }
        }
        // A child for which there was no room may have an object now.
        let is_waiting = |child: &Child| child.state == State::Live && child.find(&scene).is_none();
        if now == before && is_same && !children.iter().any(is_waiting) {
            scene.keep_source_of(&own);
            let list = children;
            return (scene, Some(Arc::new(Children { own, list })));
        }
        let order = ids(&scene);
        let children = children.into_iter().map(|child| (child, Vec::new()));
        laid(own, children.collect(), (&scene, &order), &mut Vec::new())
    }

    fn over(&self, other: Scene, burning: &Scene, whole: Option<&Untrusted>) -> Laid {
        let mut order = ids(&other);
        let mut own = other;
        let first = first_source(self.list.iter());
        let saved = whole.map(|whole| whole.field(CHILDREN).list().iter().map(Child::read));
        let saved: Option<Vec<_>> = saved.map(Iterator::collect);
        let first_before = saved.as_ref().and_then(|saved| first_source(saved.iter()));
        let mut children = Vec::new();
        for child in &self.list {
            let mut child = child.clone();
            let mut changes = Vec::new();
            match &saved {
                Some(saved) => {
                    let saved = find(saved, child.number);
                    let saved = saved.filter(|saved| saved.kind == child.kind);
                    // Another source may be the first one by now, and the page may have another source.
                    let is_of = |own| child.source_of(own, first).is_some();
                    let is_gone = is_of(&self.own) && !is_of(&own) && has_source(&own);
                    let is_its = |saved: &&Child| {
                        child.is(first) == child.is(first_before)
                            && !(is_gone
                                && saved.object == child.object
                                && saved.state == State::Live)
                    };
                    child.object = match saved.filter(is_its) {
                        Some(saved) => saved.object,
                        None if child.is(first) => 0,
                        None => child.number,
                    };
                    if let Some(saved) = saved {
                        let names = child.called.iter().chain(&saved.called);
                        changes = names.map(|(name, _)| name.clone()).collect();
                        child.called.clone_from(&saved.called);
                        if child.state != State::Hidden {
                            child.state = match saved.state {
                                State::Removed => State::Removed,
                                _ => State::Live,
                            };
                        }
                    }
                }
                // The source of a file is that of the page, unless the child has one beside it.
                None if child.is(first)
                    && (child.find(&own).is_none()
                        || child.source_of(&self.own, first).is_some()) =>
                {
                    child.object = 0;
                }
                None => {
                    let is_here = child.find(&own).is_some();
                    changes = take(&mut own, &mut child, burning);
                    if is_here && child.state != State::Hidden {
                        child.state = State::Live;
                    }
                }
            }
            children.push((child, changes));
        }
        if let Some(whole) = whole {
            let ids = whole.field(ORDER).text().split(' ');
            order = ids.filter_map(|id| id.parse().ok()).collect();
        }
        let laid = laid(own, children, (burning, &order), &mut Vec::new());
        match whole {
            Some(_) => laid,
            None => in_document_order(laid),
        }
    }
}
