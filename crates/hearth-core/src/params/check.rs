//! The validator of values, and the search for a parameter by its id.

use super::choices::Model;
use super::entry::{Description, Domain, Kind};
use super::slot::Slot;
use super::table::{DESCRIPTIONS, PARAMETERS, Param};
use super::tables::TABLES;
use super::value::{AnyValue, Colour, Input, ParamError, ParamErrorKind, Value};

impl Param {
    /// Writes a value that this entry has checked to its field.
    ///
    /// # Errors
    /// A text in another form.
    pub(super) fn store(
        &self,
        slot: Option<Slot<'_>>,
        value: AnyValue<'_>,
    ) -> Result<(), ParamError> {
        match (slot.is_none_or(|slot| slot.put(value)), value, self.kind) {
            (false, AnyValue::Text(text), Kind::Text(form)) => {
                Err(self.error(Input::Text(text), ParamErrorKind::Other(form)))
            }
            _ => Ok(()),
        }
    }

    /// The parameter with this id.
    #[inline(never)]
    pub fn find(id: &str) -> Option<&'static Param> {
        PARAMETERS.iter().find(|param| param.id == id)
    }

    /// The label and documentation.
    pub fn description(&self) -> &'static Description {
        let tables = TABLES.iter();
        let mut all = tables.flat_map(|(params, descriptions)| params.iter().zip(**descriptions));
        let found = all.find(|(param, _)| std::ptr::eq(*param, self));
        found.map_or(&DESCRIPTIONS[0], |(_, description)| description)
    }

    /// Its group in a panel.
    pub fn group(&self) -> &'static str {
        self.description().group
    }

    /// Default and range in `model`; `None` if the model does not use it.
    pub fn domain(&self, model: Model) -> Option<&'static Domain> {
        self.domains
            .iter()
            .find(|d| d.model.is_none_or(|m| m == model))
    }

    /// Default and range in `model` or, if that does not use it, in the other model, which keeps
    /// the value.
    pub fn any_domain(&self, model: Model) -> &'static Domain {
        self.domain(model).unwrap_or(&self.domains[0])
    }

    /// Checks `input` against the kind and the range. It is the only validator. The form of an
    /// outline is checked when it is written.
    pub(crate) fn check<'a>(
        &self,
        model: Model,
        input: Input<'a>,
    ) -> Result<AnyValue<'a>, ParamError> {
        let domain = self.any_domain(model);
        if input == Input::Default {
            return Ok(domain.default);
        }
        let (min, max) = domain.range;
        let in_range = |whole: bool| {
            input
                .number()
                .filter(|x| !whole || x.fract() == 0.0)
                // The bounds are decimals, and a slider sends the nearest f32.
                .filter(|&x| {
                    (min..=max).contains(&x)
                        || !whole && [min, max].iter().any(|&end| x as f32 == end as f32)
                })
                .ok_or_else(|| {
                    let unit = self.unit;
                    self.error(
                        input,
                        ParamErrorKind::OutOfRange {
                            min,
                            max,
                            unit,
                            whole,
                        },
                    )
                })
        };
        match self.kind {
            // −0 + 0 is 0: the sign of zero must not change a fire.
            Kind::Number(_) => in_range(false).map(|x| Value::Number(x as f32 + 0.0)),
            Kind::Integer(_) => in_range(true).map(|x| Value::Integer(x as u32)),
            Kind::Seed => in_range(true).map(|x| Value::Seed(x as u32)),
            Kind::Choice(choices) => match input {
                Input::Text(text) => choices.iter().find(|&&name| name == text.trim_ascii()),
                Input::Number(_) | Input::Flag(_) | Input::Default => None,
            }
            .map(|name| Value::Choice(name))
            .ok_or_else(|| self.error(input, ParamErrorKind::NotAChoice { choices })),
            Kind::Flag => input
                .flag()
                .map(Value::Flag)
                .ok_or_else(|| self.error(input, ParamErrorKind::NotAFlag)),
            Kind::Colour => match input {
                Input::Text(text) => Colour::parse(text),
                Input::Number(_) | Input::Flag(_) | Input::Default => None,
            }
            .map(Value::Colour)
            .ok_or_else(|| self.error(input, ParamErrorKind::NotAColour)),
            Kind::Text(form) => match input {
                Input::Text(text) => Ok(AnyValue::Text(text)),
                Input::Number(_) | Input::Flag(_) | Input::Default => {
                    Err(self.error(input, ParamErrorKind::Other(form)))
                }
            },
        }
    }

    #[cold]
    pub(crate) fn error(&self, input: Input<'_>, kind: ParamErrorKind) -> ParamError {
        ParamError {
            id: self.id.to_owned(),
            value: format!("{input}"),
            kind,
        }
    }
}

/// The name nearest to an unknown one, if it is similar.
pub(crate) fn nearest(
    unknown: &str,
    names: &mut dyn Iterator<Item = &'static str>,
) -> Option<&'static str> {
    names
        .map(|name| (edit_distance(name, unknown), name))
        .min_by_key(|&(distance, _)| distance)
        .filter(|&(distance, known)| distance <= known.len() / 2)
        .map(|(_, known)| known)
}

/// Levenshtein distance, in bytes, to the first 64 of `requested`.
fn edit_distance(known: &str, requested: &str) -> usize {
    let requested = &requested.as_bytes()[..requested.len().min(64)];
    let mut row: Vec<usize> = (0..=requested.len()).collect();
    for (i, a) in known.bytes().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, &b) in requested.iter().enumerate() {
            let substituted = diagonal + usize::from(a != b);
            diagonal = row[j + 1];
            row[j + 1] = substituted.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[requested.len()]
}
