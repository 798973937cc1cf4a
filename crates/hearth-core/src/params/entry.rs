//! What an entry of the parameter table is made of.

use super::choices::Model;
use super::value::Value;

/// How a slider spreads a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Equal distances are equal differences.
    Linear,
    /// Equal distances are equal ratios.
    Log,
}

/// What kind of value a parameter holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// A real number.
    Number(Scale),
    /// A whole number.
    Integer(Scale),
    /// One of these names.
    Choice(&'static [&'static str]),
    /// On or off.
    Flag,
    /// A colour.
    Colour,
    /// Any whole number from 0 to 2³² − 1.
    Seed,
}

/// Default and range of a parameter in one model, or in every one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain {
    /// The model that this holds for; `None`: every model.
    pub model: Option<Model>,
    /// The value at the start and after a reset.
    pub default: Value,
    /// Smallest and largest value of a number, integer or seed; zeros for the
    /// other kinds.
    pub range: (f64, f64),
}

/// What a parameter changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The gas: the solver receives these parameters and no others.
    Physics,
    /// The light, colours and surroundings that the renderer gives the gas.
    Look,
    /// What of the simulation a viewer sees, and how fast it plays.
    View,
}

/// What a person reads about a parameter. It stands in an array of its own, so
/// that a build that shows no text carries none.
#[derive(Debug)]
pub struct Description {
    /// A short name for a slider.
    pub label: &'static str,
    /// One or two sentences for a tooltip and the reference.
    pub doc: &'static str,
    /// The choices that each must have one of these names, or its value shows nowhere;
    /// empty: none has to. It can be set all the same.
    pub when: &'static [Condition],
    /// The choices with whose names, all of them chosen together, it shows nowhere
    /// either; empty: there are none.
    pub unless: &'static [Condition],
}

/// A choice, by its id, and some of its names.
pub type Condition = (&'static str, &'static [&'static str]);

/// Choices as words, "layers both or fire and display fire", each id and each name as
/// these say it.
pub fn conditions_in_words<'a>(
    all: impl IntoIterator<Item = &'a Condition>,
    id_in_words: impl Fn(&str) -> String,
    name_in_words: impl Fn(&str) -> String,
) -> String {
    let each = all.into_iter().map(|(id, names)| {
        let names: Vec<_> = names.iter().map(|name| name_in_words(name)).collect();
        let names = match names.split_last() {
            Some((last, others)) if !others.is_empty() => {
                format!("{} or {last}", others.join(", "))
            }
            _ => names.concat(),
        };
        format!("{} {names}", id_in_words(id))
    });
    each.collect::<Vec<_>>().join(" and ")
}
