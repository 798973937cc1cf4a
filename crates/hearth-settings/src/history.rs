//! Undo and redo: what steps lead to from present settings.

use crate::export::whole;
use crate::settings::Settings;
use crate::untrusted::{Untrusted, ValidationError};

/// What a step leads to: `to`, with what has changed in `now` since the step led to `from`.
fn merged(to: &Untrusted, from: &Untrusted, now: &Untrusted) -> Untrusted {
    if from == now {
        return to.clone();
    }
    if to == from {
        return now.clone();
    }
    match (to, from, now) {
        (Untrusted::List(to), Untrusted::List(from), Untrusted::List(now)) => {
            Untrusted::List(merged_objects(to, from, now))
        }
        (Untrusted::Object(_), Untrusted::Object(_), Untrusted::Object(_)) => {
            let mut fields: Vec<(String, Untrusted)> = Vec::new();
            for (name, _) in [to, from, now].into_iter().flat_map(Untrusted::fields) {
                let value = merged(to.field(name), from.field(name), now.field(name));
                if !value.is_missing() && fields.iter().all(|(known, _)| known != name) {
                    fields.push(Untrusted::named(name, value));
                }
            }
            Untrusted::Object(fields)
        }
        _ => to.clone(),
    }
}

/// Objects by their ids. Those that have been added since are the last ones.
fn merged_objects(to: &[Untrusted], from: &[Untrusted], now: &[Untrusted]) -> Vec<Untrusted> {
    let mut objects = Vec::new();
    for object in to {
        let find = |list: &'_ [Untrusted]| {
            let mut list = list.iter();
            list.find(|other| other.field("id") == object.field("id"))
                .cloned()
        };
        match (find(from), find(now)) {
            // It has been removed since.
            (Some(_), None) => {}
            // Another object may have the id by now.
            (Some(before), Some(now))
                if [&before, &now].map(|other| other.field("kind"))
                    == [object.field("kind"); 2] =>
            {
                objects.push(merged(object, &before, &now));
            }
            _ => objects.push(object.clone()),
        }
    }
    for object in now {
        let is_known = |list: &[Untrusted]| {
            let mut list = list.iter();
            list.any(|known| known.field("id") == object.field("id"))
        };
        if !is_known(from) && !is_known(&objects) {
            objects.push(object.clone());
        }
    }
    objects
}

impl Settings {
    /// The settings after steps are undone or redone. Each leads from [whole] settings of `from` to those of `to`; what
    /// else has changed since stays.
    ///
    /// # Errors
    /// All validation errors of what they lead to.
    pub fn after_steps(
        &self,
        to: &[Untrusted],
        from: &[Untrusted],
    ) -> Result<Settings, Vec<ValidationError>> {
        let mut now = whole(self);
        for (to, from) in to.iter().zip(from) {
            now = merged(to, from, &now);
        }
        self.after_file(&now)
    }
}
