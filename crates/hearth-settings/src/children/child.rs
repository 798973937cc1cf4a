//! A child of the element as settings know it.

use crate::untrusted::Untrusted;
use hearth_core::Scene;
use hearth_core::scene::{KINDS, Kind, Object};

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
    /// All, by their names in whole settings.
    const NAMES: [(State, &str); 3] = [
        (State::Live, "live"),
        (State::Hidden, "hidden"),
        (State::Removed, "removed"),
    ];
}

/// A child that settings know.
#[derive(Clone, Debug, PartialEq)]
pub struct Child {
    pub number: u32,
    pub kind: String,
    /// The id of its object; 0 before it has one.
    pub object: u32,
    /// What it states.
    pub stated: Vec<Field>,
    /// What calls have set since.
    pub called: Vec<Field>,
    pub state: State,
}

impl Child {
    /// A child as the element or whole settings describe it.
    pub fn read(child: &Untrusted) -> Child {
        let number = |field| child.field(field).number() as u32;
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
            number: number("id"),
            kind: kind.to_owned(),
            object: number("object"),
            stated: values("values"),
            called: values("set"),
            state: state.map_or(State::Live, |(state, _)| *state),
        }
    }

    /// The child in whole settings.
    pub fn write(&self) -> Untrusted {
        let state = State::NAMES.iter().find(|(state, _)| *state == self.state);
        let text = |text: &str| Untrusted::Text(text.to_owned());
        let fields = [
            ("id", Untrusted::Number(self.number.into())),
            ("object", Untrusted::Number(self.object.into())),
            ("kind", text(&self.kind)),
            ("values", Untrusted::Object(self.stated.clone())),
            ("set", Untrusted::Object(self.called.clone())),
            ("state", text(state.map_or("", |(_, name)| name))),
        ];
        Untrusted::Object(
            fields
                .map(|(name, value)| Untrusted::named(name, value))
                .into(),
        )
    }

    /// Whether it has this number.
    pub fn is(&self, number: Option<u32>) -> bool {
        number == Some(self.number)
    }

    /// Its object in what burns.
    pub fn burning<'a>(&self, scene: &'a Scene) -> Option<Object<'a>> {
        self.find(scene).filter(|_| self.state == State::Live)
    }

    /// Its object in a scene of the same page.
    pub fn find<'a>(&self, scene: &'a Scene) -> Option<Object<'a>> {
        let mut objects = scene.objects();
        objects.find(|object| object.id == self.object && object.kind.name == self.kind)
    }

    /// The source of the scene of the page that it is laid over.
    pub fn source_of<'a>(&self, own: &'a Scene, first: Option<u32>) -> Option<Object<'a>> {
        let mut objects = own.objects();
        objects.find(|object| {
            let is_its = match self.object {
                0 => object.is_first_source(),
                id => object.id == id && object.source().is_some(),
            };
            is_its && self.is(first)
        })
    }

    /// What it states, and what calls have set since.
    pub fn values(&self) -> Vec<Field> {
        let mut values = self.stated.clone();
        for (name, value) in &self.called {
            put(&mut values, name, Some(value.clone()));
        }
        values
    }

    /// Names of values, which are restored to the default without a value.
    pub fn values_of(&self, names: &[String]) -> Vec<Field> {
        let values = self.values();
        let value = |name: &String| get(&values, name).cloned().unwrap_or(Untrusted::Null);
        names
            .iter()
            .map(|name| (name.clone(), value(name)))
            .collect()
    }
}

/// The child with this number.
pub fn find(children: &[Child], number: u32) -> Option<&Child> {
    children.iter().find(|child| child.number == number)
}

/// The first child that is a source, by its number.
pub fn first_source<'a>(children: impl Iterator<Item = &'a Child>) -> Option<u32> {
    let sources = children.filter(|child| child.kind == Kind::SOURCE.name);
    sources.map(|child| child.number).min()
}

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
        (None, Some(value)) => fields.push(Untrusted::named(name, value)),
        (_, None) => fields.retain(|(known, _)| known != name),
    }
}
