//! Deltas: what leads from settings to other ones, value by value. Undo and redo apply them, and pages keep copies of
//! settings up to date with them.
//!
//! `{"preset": "candle", "values": {"wind": 1}, "list": 2, "objects": {"3": {"x": 0.1}, "4": null}, "order": [3, 5],
//! "children": {"1001": {"set": {}, "state": "removed"}}}`. A field that is missing has not changed. `null` restores a
//! value, and is an object that is no more. Values with a model are all that it has. An object with a kind is whole.
//! `list` is the number of the list that the objects belong to. `replaces` states that they are all of another list than
//! before, whose objects are `gone`.

use crate::apply::{self, MODEL, OBJECTS, fields, is_of_other_model, put_head, set_values};
use crate::children::child::Child;
use crate::file::CHILDREN;
use crate::settings::Settings;
use crate::untrusted::{Argument, Untrusted, ValidationError};
use hearth_core::Scene;
use hearth_core::params::{PARAMETERS, ParamErrorKind};

type Fields = Vec<(String, Untrusted)>;

/// The delta from settings to others; without fields if they are the same.
pub fn delta(from: &Settings, to: &Settings) -> Untrusted {
    let mut fields = Fields::new();
    if from.preset != to.preset {
        fields.push(Untrusted::field_of(
            "preset",
            Untrusted::Text(to.preset.into()),
        ));
    }
    let has_model = from.page.model() == to.page.model();
    let mut values = Fields::new();
    for param in PARAMETERS {
        let (Some(value), None) = (
            to.page.world().get(param.id),
            param.only_in(to.page.model()),
        ) else {
            continue;
        };
        let is_same = has_model && from.page.world().get(param.id) == Some(value);
        let states = [from, to].map(|settings| settings.states(param.id));
        let value = match states {
            [Some(true), Some(false)] => Untrusted::Null,
            [_, Some(false)] => continue,
            [before, now] if is_same && before == now => continue,
            _ => Untrusted::of_value(value),
        };
        values.push(Untrusted::field_of(param.id, value));
    }
    if !values.is_empty() {
        fields.push(Untrusted::field_of("values", Untrusted::Object(values)));
    }
    let replaces = from.list != to.list;
    put_objects(&mut fields, &from.page, &to.page, replaces);
    if replaces {
        let gone = from.page.ids().map(|id| Untrusted::Number(id.into()));
        fields.push(Untrusted::field_of("gone", Untrusted::List(gone.collect())));
    }
    if fields.iter().any(|(name, _)| name == OBJECTS) {
        fields.push(Untrusted::field_of(
            "list",
            Untrusted::Number(to.list.into()),
        ));
    }
    let children = to.children.iter().filter_map(|child| {
        let mut known = from.children.iter();
        let known = known.find(|known| known.number == child.number)?;
        let differs = known.called != child.called
            || (known.state, known.is_beside) != (child.state, child.is_beside);
        differs.then(|| Untrusted::field_of(&child.number.to_string(), child.write()))
    });
    let children: Fields = children.collect();
    if !children.is_empty() {
        fields.push(Untrusted::field_of(CHILDREN, Untrusted::Object(children)));
    }
    Untrusted::Object(fields)
}

/// The delta from the objects of a scene that burns to those of another one.
pub fn objects_delta(from: &Scene, to: &Scene) -> Untrusted {
    let mut fields = Fields::new();
    put_objects(&mut fields, from, to, false);
    Untrusted::Object(fields)
}

/// Appends what differs in the objects of scenes.
fn put_objects(fields: &mut Fields, from: &Scene, to: &Scene, replaces: bool) {
    let has_model = from.model() == to.model();
    let mut objects = Fields::new();
    for now in to.objects() {
        let before = from.object(now.id).filter(|before| {
            let is_kept = has_model || now.source().is_none();
            !replaces && is_kept && before.kind.name == now.kind.name
        });
        if before == Some(now) {
            continue;
        }
        let mut changed = Fields::new();
        if before.is_none() {
            put_head(&mut changed, &now, true);
        }
        let old = |name: &str| {
            let mut properties = before?.properties();
            properties
                .find(|(known, ..)| *known == name)
                .map(|(_, _, value)| value)
        };
        for (name, _, value) in now.properties() {
            if old(name) != Some(value) {
                changed.push(Untrusted::field_of(name, Untrusted::of_value(value)));
            }
        }
        objects.push(Untrusted::field_of(
            &now.id.to_string(),
            Untrusted::Object(changed),
        ));
    }
    for id in from
        .ids()
        .filter(|id| !replaces && to.object(*id).is_none())
    {
        objects.push(Untrusted::field_of(&id.to_string(), Untrusted::Null));
    }
    if replaces || from.ids().ne(to.ids()) {
        let order = to.ids().map(|id| Untrusted::Number(id.into())).collect();
        fields.push(Untrusted::field_of("order", Untrusted::List(order)));
        fields.push(Untrusted::field_of("replaces", Untrusted::Flag(replaces)));
    } else if objects.is_empty() {
        return;
    }
    fields.push(Untrusted::field_of(OBJECTS, Untrusted::Object(objects)));
}

impl Settings {
    /// The settings after deltas. What they do not name stays.
    ///
    /// # Errors
    /// All validation errors.
    pub fn after_deltas(&self, deltas: &[Untrusted]) -> Result<Settings, Vec<ValidationError>> {
        let (mut settings, mut errors) = (self.clone(), Vec::new());
        for delta in deltas {
            settings.apply_delta(delta, &mut errors);
        }
        match errors.is_empty() {
            true => Ok(settings.composed()),
            false => Err(errors),
        }
    }

    fn apply_delta(&mut self, delta: &Untrusted, errors: &mut Vec<ValidationError>) {
        if let Some(name) = Argument::read(delta.field("preset")) {
            match apply::preset(name) {
                Ok(preset) => self.preset = preset.name,
                Err(error) => errors.push(error),
            }
        }
        let (models, values): (Vec<_>, Vec<_>) = delta
            .field("values")
            .fields()
            .iter()
            .cloned()
            .partition(|(id, _)| id == MODEL);
        set_values(&mut self.page, &models, errors);
        let known = |(id, _): &&(String, Untrusted)| !is_of_other_model(&self.page, id);
        let values: Vec<_> = values.iter().filter(known).cloned().collect();
        set_values(&mut self.page, &values, errors);
        self.state(&values);
        let list = delta.field("list").number() as u32;
        let replaces = *delta.field("replaces") == Untrusted::Flag(true);
        let before = self.page.clone();
        if replaces {
            self.list = list;
            self.page.clear();
        }
        if self.list == list {
            self.apply_objects(delta, errors);
        }
        // What has been added to the list since the step stays.
        let gone = delta.field("gone").list();
        let stays = |id: &u32| replaces && !gone.contains(&Untrusted::Number((*id).into()));
        for id in before.ids().filter(stays) {
            if self.page.object(id).is_none() {
                self.page.take(&before, id);
            }
        }
        let saved = delta.field(CHILDREN).fields();
        if !self.children.is_empty() && !saved.is_empty() {
            let saved = saved.iter().map(|(_, child)| Child::read(child));
            self.restore_children(&saved.collect::<Vec<_>>());
        }
    }

    fn apply_objects(&mut self, delta: &Untrusted, errors: &mut Vec<ValidationError>) {
        let order = delta.field("order").list().iter();
        let order: Vec<_> = order.map(|id| id.number() as u32).collect();
        let objects = delta.field(OBJECTS).fields();
        let is_gone = |(_, object): &&(String, Untrusted)| object.fields().is_empty();
        // They leave room for new ones.
        for (id, _) in objects.iter().filter(is_gone) {
            let known = self.page.ids().find(|known| known.to_string() == *id);
            if let Some(id) = known {
                let removed = self.page.remove(id);
                debug_assert_eq!(removed, Ok(()));
            }
        }
        for (id, object) in objects.iter().filter(|object| !is_gone(object)) {
            let known = self.page.ids().find(|known| known.to_string() == *id);
            let is_whole = object.fields().iter().any(|(name, _)| name == "kind");
            if known.is_none() && !is_whole {
                // It has been removed since.
                continue;
            }
            let mut refused = Vec::new();
            let mut inputs = fields(object.fields());
            if known.is_some() {
                inputs.retain(|(name, _)| !["kind", "id"].contains(name));
            }
            self.page.apply_fields(known, &inputs, &mut refused);
            // The model may have changed since.
            refused.retain(|error| !matches!(error.kind, ParamErrorKind::OfModel(_)));
            let sent = object.fields();
            errors.extend(refused.iter().map(|error| apply::of_object(error, sent)));
        }
        self.page.arrange(&order);
    }
}
