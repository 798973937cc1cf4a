//! The types of the parameter table.

use super::choices::Model;
use super::value::Value;

/// The scale of a slider.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Equal distances are equal differences.
    Linear,
    /// Equal distances are equal ratios.
    Log,
}

/// The kind of a value.
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
    /// An outline as text, in this form.
    Text(&'static str),
}

/// Default and range of a parameter in one model, or in every one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain {
    /// The model; `None` for every model.
    pub model: Option<Model>,
    /// The value of a new fire or object and after a restore.
    pub default: Value,
    /// Smallest and largest value of a number, integer or seed; zeros for the
    /// other kinds.
    pub range: (f64, f64),
}

/// The part of Hearth that reads a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The solver, which reads no other parameters.
    Physics,
    /// The light, colours and surroundings of the gas in the renderer.
    Look,
    /// The displayed part of the simulation, and its speed.
    View,
}

/// The place and documentation of a parameter in a panel. A separate array, so that a build without
/// text does not include it.
#[derive(Debug)]
pub struct Description {
    /// Its group in a panel; empty for a property of an object.
    pub group: &'static str,
    /// Name of its control.
    pub label: &'static str,
    /// Sentences for a tooltip and the reference.
    pub doc: &'static str,
    /// Conditions of which all must be met for the value to have an effect. Unmet conditions do
    /// not prevent a change.
    pub when: &'static [Condition],
    /// Conditions that together leave the value without an effect; empty if there are none.
    pub unless: &'static [Condition],
}

/// The id of a choice and some of its names: it is met if one of them is chosen.
pub type Condition = (&'static str, &'static [&'static str]);

/// Conditions as text, such as "layers both or fire and display fire". `id_text` and
/// `name_text` give the text of ids and names.
pub fn conditions_text<'a>(
    all: impl IntoIterator<Item = &'a Condition>,
    id_text: impl Fn(&str) -> String,
    name_text: impl Fn(&str) -> String,
) -> String {
    let each = all.into_iter().map(|(id, names)| {
        let names: Vec<_> = names.iter().map(|name| name_text(name)).collect();
        let names = match names.split_last() {
            Some((last, others)) if !others.is_empty() => {
                format!("{} or {last}", others.join(", "))
            }
            _ => names.concat(),
        };
        format!("{} {names}", id_text(id))
    });
    each.collect::<Vec<_>>().join(" and ")
}
