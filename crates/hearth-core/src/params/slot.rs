//! The field of a parameter in the generated struct, whatever its type.

use super::choices::Choice;
use super::value::{Colour, Value};

/// The field of a parameter in [`Values`](super::Values).
pub(super) enum Slot<'a> {
    Number(&'a mut f32),
    Whole(&'a mut u32),
    Seed(&'a mut u32),
    Flag(&'a mut bool),
    Colour(&'a mut Colour),
    Choice(&'a mut dyn Chosen),
}

impl Slot<'_> {
    pub fn value(self) -> Value {
        match self {
            Slot::Number(x) => Value::Number(*x),
            Slot::Whole(n) => Value::Integer(*n),
            Slot::Seed(n) => Value::Seed(*n),
            Slot::Flag(on) => Value::Flag(*on),
            Slot::Colour(colour) => Value::Colour(*colour),
            Slot::Choice(chosen) => Value::Choice(chosen.chosen()),
        }
    }

    /// Writes a value of the same kind. Any other value changes nothing.
    pub fn put(self, value: Value) {
        match (self, value) {
            (Slot::Number(x), Value::Number(new)) => *x = new,
            (Slot::Whole(n), Value::Integer(new)) => *n = new,
            (Slot::Seed(n), Value::Seed(new)) => *n = new,
            (Slot::Flag(on), Value::Flag(new)) => *on = new,
            (Slot::Colour(colour), Value::Colour(new)) => *colour = new,
            (Slot::Choice(chosen), Value::Choice(name)) => chosen.choose(name),
            _ => {}
        }
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
