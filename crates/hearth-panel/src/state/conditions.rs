//! What the views need of a row besides its value: whether it has an effect, and what typed text
//! means.

use hearth_core::params::{AnyValue, Condition, Kind, Param};

use crate::format::typed_text;
use crate::state::entry::Entry;
use crate::state::fire::Fire;
use crate::state::subject::Subject;

impl Fire {
    /// The conditions of which all must be met for the value to have an effect, and are not.
    pub fn unmet_conditions(&self, subject: Subject) -> Vec<&'static Condition> {
        let when = subject.param.description().when.iter();
        when.filter(|chosen| !self.is_met(subject, chosen))
            .collect()
    }

    /// The conditions that together leave the value without an effect, if all are met.
    pub fn met_exclusions(&self, subject: Subject) -> &'static [Condition] {
        let unless = subject.param.description().unless;
        match unless.iter().all(|chosen| self.is_met(subject, chosen)) {
            true => unless,
            false => &[],
        }
    }

    fn is_met(&self, subject: Subject, (id, names): &Condition) -> bool {
        let Some(AnyValue::Choice(name)) = self.chosen(subject, id) else {
            return false;
        };
        names.contains(&name)
    }

    /// The value of the choice `id` that a condition of `subject` names: a property of the same
    /// object, or a parameter.
    fn chosen(&self, subject: Subject, id: &str) -> Option<AnyValue<'_>> {
        let Some(owner) = subject.object else {
            return self.objects.get(id);
        };
        let object = self.object(owner.id)?;
        let mut own = object.properties();
        match own.find(|(_, param, _)| param.id == id) {
            Some((.., value)) => Some(value),
            None => self.objects.get(id),
        }
    }

    /// The entry of the choice `id` that a condition of `subject` names.
    pub fn choice_of(&self, subject: Subject, id: &str) -> Option<&'static Param> {
        let object = subject.object.and_then(|owner| self.object(owner.id));
        let mut properties = object
            .into_iter()
            .flat_map(|object| object.kind.properties());
        match properties.find(|property| property.id() == id) {
            Some(property) => property.entry(),
            None => Param::find(id),
        }
    }

    /// Typed text as an input of the table.
    pub fn typed(&self, subject: Subject, text: &str) -> Entry {
        if let Kind::Text(_) = subject.param.kind {
            return Entry::Text(text.trim().to_owned());
        }
        let typed = typed_text(text, subject.param);
        // The refusal of a number does not quote it.
        match (subject.param.kind, typed.parse::<f64>()) {
            (Kind::Number(_) | Kind::Integer(_) | Kind::Seed, Ok(x)) if x.is_finite() => {
                Entry::Number(x)
            }
            _ => Entry::Text(typed),
        }
    }
}
