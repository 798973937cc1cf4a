//! Untrusted values applied to the parameters of a fire.

use hearth_core::Parameters;
use hearth_core::preset::{PRESETS, Preset};

use crate::check::one_of;
use crate::{Untrusted, ValidationError, Values};

/// The id of the model. It comes first, because it decides which values and defaults the
/// other parameters have.
const MODEL: &str = "model";

/// `parameters` with these values, all of them or none.
///
/// # Errors
/// Every value that is refused.
pub fn with_values(
    parameters: &Parameters,
    values: Values<'_>,
) -> Result<Parameters, Vec<ValidationError>> {
    let mut new = parameters.clone();
    let mut errors = Vec::new();
    set_good(&mut new, values, &mut errors);
    if errors.is_empty() {
        Ok(new)
    } else {
        Err(errors)
    }
}

/// Sets those of these values that are good and adds an error for each other one.
#[inline(never)]
pub fn set_good(
    parameters: &mut Parameters,
    values: Values<'_>,
    errors: &mut Vec<ValidationError>,
) {
    model_first(values, &mut |id, value| {
        if let Err(error) = parameters.set(id, value.input()) {
            errors.push(ValidationError::of_parameter(&error, value));
        }
    });
}

/// `parameters` with the default values of the ids of these values, all of them or none.
///
/// # Errors
/// Every id that is unknown.
pub fn with_defaults(
    parameters: &Parameters,
    values: Values<'_>,
) -> Result<Parameters, Vec<ValidationError>> {
    let mut new = parameters.clone();
    let mut errors = Vec::new();
    model_first(values, &mut |id, _| {
        if let Err(error) = new.restore(id) {
            errors.push(ValidationError::of_parameter(&error, &Untrusted::Missing));
        }
    });
    if errors.is_empty() {
        Ok(new)
    } else {
        Err(errors)
    }
}

/// Visits the value of the model, then all others.
fn model_first(values: Values<'_>, visit: &mut dyn FnMut(&str, &Untrusted)) {
    for of_model in [true, false] {
        for (id, value) in values {
            if (id == MODEL) == of_model {
                visit(id, value);
            }
        }
    }
}

/// The preset of that name.
///
/// # Errors
/// There is no preset of that name; the message names all that there are.
pub fn preset(name: &str) -> Result<&'static Preset, ValidationError> {
    Preset::find(name).ok_or_else(|| {
        let mut names = PRESETS.iter().map(|preset| preset.name);
        one_of("preset", &Untrusted::Text(name.into()), &mut names)
    })
}
