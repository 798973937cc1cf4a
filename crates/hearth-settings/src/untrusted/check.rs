//! The forms of arguments, as data.
//!
//! One function checks every argument against its [`Check`]. The types that implement
//! [`Argument`] read checked values.

use super::error::ValidationError;
use super::value::{Untrusted, Values};
use hearth_core::params::Input;

/// The required form of an argument.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Check {
    /// The form.
    pub form: Form,
    /// Whether it may be missing.
    pub optional: bool,
}

/// The forms of arguments.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// Anything. Its user checks it.
    Any,
    /// A finite number.
    Finite,
    /// A number from `min` to `max`.
    Within {
        /// Smallest allowed number.
        min: i32,
        /// Largest allowed number.
        max: i32,
        /// Whether only whole numbers are allowed.
        whole: bool,
    },
    /// A number above 0, up to this one.
    Positive(i32),
    /// True or false.
    Flag,
    /// A text.
    Text,
    /// One of these texts.
    OneOf(&'static [&'static str]),
    /// An object of values by their ids.
    Values,
}

impl Check {
    /// A required argument of that form.
    pub const fn required(form: Form) -> Check {
        Check {
            form,
            optional: false,
        }
    }

    /// An optional argument of that form.
    pub const fn optional(form: Form) -> Check {
        Check {
            form,
            optional: true,
        }
    }

    /// Checks the value of `id`.
    ///
    /// # Errors
    /// The value has another form.
    pub fn test(&self, id: &str, value: &Untrusted) -> Result<(), ValidationError> {
        if self.optional && value.is_missing() {
            return Ok(());
        }
        let number = value.number();
        let (valid, allowed) = match self.form {
            Form::Any => return Ok(()),
            Form::Finite => (number.is_finite(), "a number"),
            Form::Within { min, max, whole } => {
                let (min, max) = (f64::from(min), f64::from(max));
                let valid = number >= min && number <= max && !(whole && number.fract() != 0.0);
                let kind = if whole {
                    "a whole number from "
                } else {
                    "a number from "
                };
                return in_range(id, value, valid, (min, max), [kind, " to "]);
            }
            Form::Positive(max) => {
                let max = f64::from(max);
                let valid = number > 0.0 && number <= max;
                return in_range(
                    id,
                    value,
                    valid,
                    (0.0, max),
                    ["a number above ", ", up to "],
                );
            }
            Form::Flag => (matches!(value, Untrusted::Flag(_)), "true or false"),
            Form::Text => (matches!(value, Untrusted::Text(_)), "a text"),
            Form::OneOf(names) => {
                if names.contains(&value.text()) {
                    return Ok(());
                }
                return Err(one_of(id, value, &mut names.iter().copied()));
            }
            Form::Values => (
                matches!(value, Untrusted::Object(_)),
                "an object of values by their ids",
            ),
        };
        if valid {
            Ok(())
        } else {
            Err(ValidationError::new(id, value, allowed))
        }
    }
}

/// An error with a range, unless the value is valid.
fn in_range(
    id: &str,
    value: &Untrusted,
    valid: bool,
    (min, max): (f64, f64),
    [from, to]: [&str; 2],
) -> Result<(), ValidationError> {
    if valid {
        return Ok(());
    }
    // In the number format of `hearth-core`.
    let allowed = format!("{from}{}{to}{}", Input::Number(min), Input::Number(max));
    Err(ValidationError {
        range: Some((min, max)),
        ..ValidationError::new(id, value, &allowed)
    })
}

/// An error that names the allowed texts.
fn one_of(id: &str, value: &Untrusted, names: &mut dyn Iterator<Item = &str>) -> ValidationError {
    let mut allowed = String::from("one of ");
    for (at, name) in names.enumerate() {
        allowed.push_str(if at == 0 { "" } else { ", " });
        allowed.push_str(name);
    }
    ValidationError::new(id, value, &allowed)
}

/// The type of an argument: its check, and the conversion of a checked value.
pub trait Argument<'a> {
    /// The required form.
    const CHECK: Check;

    /// Converts a checked value. Any other value gives a default.
    fn read(value: &'a Untrusted) -> Self;
}

/// A number from `MIN` to `MAX`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Within<const MIN: i32, const MAX: i32>(pub f64);

/// A whole number from `MIN` to `MAX`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Whole<const MIN: i32, const MAX: i32>(pub u32);

/// A number above 0, up to `MAX`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Positive<const MAX: i32>(pub f64);

impl<const MIN: i32, const MAX: i32> Argument<'_> for Within<MIN, MAX> {
    const CHECK: Check = Check::required(Form::Within {
        min: MIN,
        max: MAX,
        whole: false,
    });

    fn read(value: &Untrusted) -> Self {
        Within(value.number())
    }
}

impl<const MIN: i32, const MAX: i32> Argument<'_> for Whole<MIN, MAX> {
    const CHECK: Check = Check::required(Form::Within {
        min: MIN,
        max: MAX,
        whole: true,
    });

    fn read(value: &Untrusted) -> Self {
        Whole(value.number() as u32)
    }
}

impl<const MAX: i32> Argument<'_> for Positive<MAX> {
    const CHECK: Check = Check::required(Form::Positive(MAX));

    fn read(value: &Untrusted) -> Self {
        Positive(value.number())
    }
}

impl Argument<'_> for f64 {
    const CHECK: Check = Check::required(Form::Finite);

    fn read(value: &Untrusted) -> f64 {
        value.number()
    }
}

impl Argument<'_> for bool {
    const CHECK: Check = Check::required(Form::Flag);

    fn read(value: &Untrusted) -> bool {
        matches!(value, Untrusted::Flag(true))
    }
}

impl<'a> Argument<'a> for &'a str {
    const CHECK: Check = Check::required(Form::Text);

    fn read(value: &'a Untrusted) -> &'a str {
        value.text()
    }
}

impl<'a> Argument<'a> for Values<'a> {
    const CHECK: Check = Check::required(Form::Values);

    fn read(value: &'a Untrusted) -> Values<'a> {
        value.fields()
    }
}

impl<'a> Argument<'a> for &'a Untrusted {
    const CHECK: Check = Check::optional(Form::Any);

    fn read(value: &'a Untrusted) -> &'a Untrusted {
        value
    }
}

impl<'a, T: Argument<'a>> Argument<'a> for Option<T> {
    const CHECK: Check = Check::optional(T::CHECK.form);

    fn read(value: &'a Untrusted) -> Option<T> {
        (!value.is_missing()).then(|| T::read(value))
    }
}
