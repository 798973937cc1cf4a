//! The field of a parameter in the generated struct, whatever its type.

use super::choices::{Choice, Model};
use super::outline::FromText;
use super::table::{Field, PARAMETERS, Param};
use super::value::{AnyValue, Colour, Value};

/// A struct whose fields are entries of [`PARAMETERS`].
pub(super) trait Slots: Clone {
    /// The defaults of a model.
    fn of_model(model: Model) -> Self;

    /// A field; `None` if it is one of another struct.
    fn slot(&mut self, field: Field) -> Option<Slot<'_>>;

    /// The value of an entry; `None` if it is no field of this struct.
    fn value(&self, param: &Param) -> Option<Value> {
        param
            .field
            .and_then(|field| Some(self.clone().slot(field)?.value()))
    }

    /// Writes a checked value, and returns whether it is a field of this struct.
    fn put(&mut self, param: &Param, value: AnyValue<'_>) -> bool {
        let slot = param.field.and_then(|field| self.slot(field));
        slot.map(|slot| slot.put(value)).is_some()
    }

    /// Writes the defaults of a model.
    fn put_defaults(&mut self, model: Model) {
        for param in PARAMETERS {
            if let Some(domain) = param.domain(model) {
                self.put(param, domain.default);
            }
        }
    }

    /// The values that both models have with the same domain, and the other defaults of `model`.
    fn in_model(&self, model: Model) -> Self {
        let mut values = Self::of_model(model);
        for param in PARAMETERS
            .iter()
            .filter(|param| param.domains[0].model.is_none())
        {
            if let Some(value) = self.value(param) {
                values.put(param, value);
            }
        }
        values
    }
}

/// The field of a parameter in a struct.
pub(super) enum Slot<'a> {
    Number(&'a mut f32),
    Whole(&'a mut u32),
    Seed(&'a mut u32),
    Flag(&'a mut bool),
    Colour(&'a mut Colour),
    Choice(&'a mut dyn Chosen),
    Text(&'a mut dyn FromText),
}

impl Slot<'_> {
    /// The value; an empty one for an outline, whose text its owner lends.
    pub fn value(self) -> Value {
        match self {
            Slot::Number(x) => Value::Number(*x),
            Slot::Whole(n) => Value::Integer(*n),
            Slot::Seed(n) => Value::Seed(*n),
            Slot::Flag(on) => Value::Flag(*on),
            Slot::Colour(colour) => Value::Colour(*colour),
            Slot::Choice(chosen) => Value::Choice(chosen.chosen()),
            Slot::Text(_) => Value::Text(""),
        }
    }

    /// Writes a value of the same kind. Returns whether a text has the right form. A value of
    /// another kind changes nothing.
    pub fn put(self, value: AnyValue<'_>) -> bool {
        match (self, value) {
            (Slot::Number(x), AnyValue::Number(new)) => *x = new,
            (Slot::Whole(n), AnyValue::Integer(new)) => *n = new,
            (Slot::Seed(n), AnyValue::Seed(new)) => *n = new,
            (Slot::Flag(on), AnyValue::Flag(new)) => *on = new,
            (Slot::Colour(colour), AnyValue::Colour(new)) => *colour = new,
            (Slot::Choice(chosen), AnyValue::Choice(name)) => chosen.choose(name),
            (Slot::Text(outline), AnyValue::Text(text)) => return outline.read(text),
            _ => {}
        }
        true
    }
}

/// A choice of any type.
pub(super) trait Chosen {
    fn chosen(&self) -> &'static str;
    fn choose(&mut self, name: &str);
}

impl<T: Choice> Chosen for T {
    fn chosen(&self) -> &'static str {
        self.name()
    }

    fn choose(&mut self, name: &str) {
        if let Some(new) = T::from_name(name) {
            *self = new;
        }
    }
}
