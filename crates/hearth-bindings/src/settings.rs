//! Untrusted values applied to the parameters of a fire.

use hearth_core::Parameters;
use hearth_core::preset::{PRESETS, Preset};

use crate::check::one_of;
use crate::{Untrusted, ValidationError, Values};

/// The id of the model.
const MODEL: &str = "model";

/// `parameters` with these values, all of them or none.
///
/// # Errors
/// Every value that is refused.
pub fn with_values(
    parameters: &Parameters,
    values: Values<'_>,
) -> Result<Parameters, Vec<ValidationError>> {
    changed(parameters, values, false)
}

/// `parameters` with the default values of the ids of these values, all of them or none.
///
/// # Errors
/// Every id that is unknown.
pub fn with_defaults(
    parameters: &Parameters,
    values: Values<'_>,
) -> Result<Parameters, Vec<ValidationError>> {
    changed(parameters, values, true)
}

#[inline(never)]
fn changed(
    parameters: &Parameters,
    values: Values<'_>,
    to_defaults: bool,
) -> Result<Parameters, Vec<ValidationError>> {
    let mut new = parameters.clone();
    let mut errors = Vec::new();
    change(&mut new, values, to_defaults, &mut errors);
    if errors.is_empty() {
        Ok(new)
    } else {
        Err(errors)
    }
}

/// Sets those of these values that are good and adds an error for each other one.
pub fn set_good(
    parameters: &mut Parameters,
    values: Values<'_>,
    errors: &mut Vec<ValidationError>,
) {
    change(parameters, values, false, errors);
}

/// Changes the model first, because it decides which values and defaults the others have.
#[inline(never)]
fn change(
    parameters: &mut Parameters,
    values: Values<'_>,
    to_defaults: bool,
    errors: &mut Vec<ValidationError>,
) {
    for of_model in [true, false] {
        for (id, value) in values {
            if (id == MODEL) != of_model {
                continue;
            }
            let changed = if to_defaults {
                parameters.restore(id)
            } else {
                parameters.set(id, value.input())
            };
            if let Err(error) = changed {
                errors.push(ValidationError::of_parameter(&error, value));
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
