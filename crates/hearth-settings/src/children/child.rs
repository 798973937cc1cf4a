//! A child of the element as settings know it.

use crate::apply::OBJECTS;
use crate::file::CHILDREN;
use crate::untrusted::{Untrusted, ValidationError};
use hearth_core::params::{Model, ParamError};
use hearth_core::scene::KINDS;

/// A value by the name of a property.
pub type Field = (String, Untrusted);

/// Whether a child has an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// It has, if there is room.
    Live,
    /// It states none now.
    Hidden,
    /// A call has removed it.
    Removed,
}

impl State {
    /// All, by their names in a file.
    const NAMES: [(State, &str); 3] = [
        (State::Live, "live"),
        (State::Hidden, "hidden"),
        (State::Removed, "removed"),
    ];
}

/// A child that settings know.
#[derive(Clone, Debug, PartialEq)]
pub struct Child {
    /// Its number, which is the id of its object.
    pub number: u32,
    pub kind: String,
    /// What it states.
    pub stated: Vec<Field>,
    /// What calls have set since.
    pub called: Vec<Field>,
    pub state: State,
    /// Whether it burns beside the sources of the page, all of which calls have added since.
    pub is_beside: bool,
}

impl Child {
    /// A child as the element or a file describes it.
    pub fn read(child: &Untrusted) -> Child {
        let kind = child.field("kind").text();
        let known = KINDS.iter().find(|known| known.name == kind);
        let values = |field| {
            let values = child.field(field).fields().iter();
            let is_known =
                |(name, _): &&Field| known.is_some_and(|kind| kind.property(name).is_some());
            values.filter(is_known).cloned().collect()
        };
        let state = child.field("state").text();
        let state = State::NAMES.iter().find(|(_, name)| *name == state);
        Child {
            number: child.field("id").number() as u32,
            kind: kind.to_owned(),
            stated: values("values"),
            called: values("set"),
            state: state.map_or(State::Live, |(state, _)| *state),
            is_beside: *child.field("beside") == Untrusted::Flag(true),
        }
    }

    /// The child as a file has it.
    pub fn write(&self) -> Untrusted {
        let state = State::NAMES.iter().find(|(state, _)| *state == self.state);
        let text = |text: &str| Untrusted::Text(text.to_owned());
        let fields = [
            ("id", Untrusted::Number(self.number.into())),
            ("kind", text(&self.kind)),
            ("values", Untrusted::Object(self.stated.clone())),
            ("set", Untrusted::Object(self.called.clone())),
            ("state", text(state.map_or("", |(_, name)| name))),
            ("beside", Untrusted::Flag(self.is_beside)),
        ];
        Untrusted::Object(
            fields
                .map(|(name, value)| Untrusted::field_of(name, value))
                .into(),
        )
    }

    /// What a call has set of a property, or else what the child states.
    pub fn value(&self, name: &str) -> Option<&Untrusted> {
        get(&self.called, name).or_else(|| get(&self.stated, name))
    }

    /// The names of its properties that a model uses.
    pub fn properties(&self, model: Model) -> impl Iterator<Item = &'static str> + use<> {
        let kind = KINDS.iter().find(|kind| kind.name == self.kind);
        let all = kind.into_iter().flat_map(|kind| kind.properties());
        let used = all.filter(move |property| property.param(model).is_some());
        used.map(|property| property.name)
    }

    /// The error of a property of the child at this index, with the name of the property.
    pub fn refusal(&self, at: usize, error: &ParamError) -> (usize, String, ValidationError) {
        let name = error.id.split_once('.').map_or(OBJECTS, |(_, name)| name);
        let stated = get(&self.stated, name).unwrap_or(&Untrusted::Missing);
        let mut refusal = error.clone();
        refusal.id = format!("{CHILDREN}[{at}].{name}");
        let refusal = ValidationError::of_parameter(&refusal, stated);
        (at, name.to_owned(), refusal)
    }

    /// Restores what calls have set, and whether a call has removed its object.
    pub fn restore(&mut self, before: &Child) {
        self.called.clone_from(&before.called);
        self.is_beside = before.is_beside;
        if self.state != State::Hidden {
            self.state = match before.state {
                State::Removed => State::Removed,
                _ => State::Live,
            };
        }
    }

    /// The children of a file, without those that have the number of an earlier one.
    pub fn read_all(list: &Untrusted) -> Vec<Child> {
        let mut children: Vec<Child> = Vec::new();
        for child in list.list().iter().map(Child::read) {
            if children.iter().all(|known| known.number != child.number) {
                children.push(child);
            }
        }
        children
    }
}

/// The value of a name.
pub fn get<'a>(fields: &'a [Field], name: &str) -> Option<&'a Untrusted> {
    let mut fields = fields.iter();
    fields
        .find(|(known, _)| known == name)
        .map(|(_, value)| value)
}

/// Sets a value or, without one, removes it.
pub fn put(fields: &mut Vec<Field>, name: &str, value: Option<Untrusted>) {
    let found = fields.iter_mut().find(|(known, _)| known == name);
    match (found, value) {
        (Some((_, known)), Some(value)) => *known = value,
        (None, Some(value)) => fields.push(Untrusted::field_of(name, value)),
        (_, None) => fields.retain(|(known, _)| known != name),
    }
}
