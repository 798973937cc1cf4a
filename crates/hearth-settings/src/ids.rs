//! Ids of objects. A fire gives none of them twice, so that no undo and no late call reaches another object.
//!
//! Files number their objects from 1, as scenes do. In a fire, those of another scene follow the last id.

use crate::apply::{OBJECTS, objects};
use crate::settings::Settings;
use crate::untrusted::Values;
use hearth_core::Scene;

/// The largest id.
const MAX: u32 = 1_000_000;

impl Settings {
    /// The scene of the page, without its children.
    fn own(&self) -> &Scene {
        let children = self.children.as_ref();
        children.map_or(self.scene(), |children| children.own())
    }

    /// Records the ids of the page's objects, and that another fire or earlier settings have given this one.
    pub(crate) fn record_ids(&mut self, given: u32) {
        let ids = self.own().objects().map(|object| object.id);
        self.last_id = ids.fold(self.last_id.max(given), u32::max);
    }

    /// The settings of a fire that follows another one, which has given the ids up to this one.
    pub fn following(mut self, last: u32) -> Settings {
        self.record_ids(last.min(MAX));
        self
    }

    /// Whether an id is that of a child, and of no object of the page.
    fn is_of_child(&self, id: u32) -> bool {
        let children = self.children.iter().flat_map(|children| children.list());
        let mut ids = children.flat_map(|child| [child.number, child.object]);
        ids.any(|known| known == id) && self.own().objects().all(|object| object.id != id)
    }

    /// Ids that no object had. After the last one of all, those that none has.
    fn new_ids(&self) -> impl Iterator<Item = u32> {
        let all = (self.last_id.saturating_add(1)..=MAX).chain(1..=MAX);
        all.filter(|id| {
            let mut objects = self.scene().objects();
            objects.all(|object| object.id != *id) && !self.is_of_child(*id)
        })
    }

    /// The id of a new object.
    pub(crate) fn next_id(&self) -> u32 {
        self.new_ids().next().unwrap_or_default()
    }

    /// These settings without children, with ids that are higher by so much; objects of the children of `of` keep
    /// theirs. `None` if there is no such id, or two objects would have one.
    fn raised(&self, by: i64, of: &Settings) -> Option<Settings> {
        let follows = |id: u32| match of.is_of_child(id) {
            true => id,
            false => u32::try_from(i64::from(id) + by).unwrap_or_default(),
        };
        let mut ids: Vec<u32> = Vec::new();
        for object in self.scene().objects() {
            let id = follows(object.id);
            let is_free = !ids.contains(&id) && (id == object.id || !of.is_of_child(id));
            if !is_free || !(1..=MAX).contains(&id) {
                return None;
            }
            ids.push(id);
        }
        let mut scene = self.scene().clone();
        scene.renumber(&follows);
        let mut raised = self.burning((scene, None));
        raised.first_id = follows(self.first_id).max(1);
        Some(raised)
    }

    /// These settings as a file numbers their objects: those of the scene from 1.
    pub(crate) fn numbered_in_file(&self) -> Settings {
        let raised = self.raised(1 - i64::from(self.first_id), self);
        raised.unwrap_or_else(|| self.burning((self.scene().clone(), None)))
    }

    /// Settings that are numbered as in a file, with ids that these have not given. The same objects again keep theirs.
    pub(crate) fn numbered_after(&self, file: &Settings) -> Settings {
        let again = file.raised(i64::from(self.first_id) - 1, self);
        let list = |scene: &Scene| objects(scene, None, true);
        let again = again.filter(|again| list(again.scene()) == list(self.own()));
        let burning = self.scene().objects().map(|object| object.id).max();
        let last = [self.last_id, burning.unwrap_or_default().max(self.last_id)];
        let mut new = last
            .into_iter()
            .filter_map(|last| file.raised(last.into(), self));
        again.or_else(|| new.next()).unwrap_or_else(|| file.clone())
    }

    /// A scene after these values. An object that the list states without an id is the one that had its place or,
    /// where that was of another kind, a new one.
    pub(crate) fn numbered_by_place(&self, values: Values<'_>, mut scene: Scene) -> Scene {
        let mut lists = values
            .iter()
            .filter(|(id, value)| id == OBJECTS && !value.is_missing());
        let Some((_, list)) = lists.next_back() else {
            return scene;
        };
        let facts = |scene: &Scene| -> Vec<(u32, &str)> {
            let all = scene.objects();
            all.map(|object| (object.id, object.kind.name)).collect()
        };
        let (before, now) = (facts(self.own()), facts(&scene));
        let is_stated = |place: usize| {
            let object = list.list().get(place);
            object.is_some_and(|object| !object.field("id").is_missing())
        };
        let places = now.iter().enumerate();
        let stated: Vec<_> = places.filter(|(place, _)| is_stated(*place)).collect();
        let is_taken = |id: u32| stated.iter().any(|(_, (known, _))| *known == id);
        let mut new = self.new_ids().filter(|id| !is_taken(*id));
        let mut ids = Vec::new();
        for (place, (id, kind)) in now.iter().enumerate() {
            let mut same = before.get(place).into_iter();
            let same = same.find(|(id, known)| known == kind && !is_taken(*id));
            ids.push(match same {
                _ if is_stated(place) => (*id, *id),
                Some((same, _)) => (*id, *same),
                None => (*id, new.next().unwrap_or(*id)),
            });
        }
        scene.renumber(&|id| {
            let mut ids = ids.iter();
            ids.find(|(known, _)| *known == id)
                .map_or(id, |(_, new)| *new)
        });
        scene
    }
}
