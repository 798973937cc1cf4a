//! Fires to test with.

use hearth_core::params::Input;
use hearth_core::{Parameters, Simulation};

/// The defaults with these values changed.
///
/// # Panics
/// Where the table refuses a value: the test that asks for it is wrong.
pub fn with<'a>(values: impl IntoIterator<Item = (&'a str, Input<'a>)>) -> Parameters {
    let mut parameters = Parameters::default();
    for (id, value) in values {
        if let Err(refusal) = parameters.set(id, value) {
            panic!("{refusal}");
        }
    }
    parameters
}

/// The defaults with these numbers changed.
///
/// # Panics
/// As [`with`].
pub fn with_numbers(values: &[(&str, f64)]) -> Parameters {
    with(values.iter().map(|&(id, value)| (id, Input::Number(value))))
}

/// A fire that has burned for so many simulated seconds.
pub fn burn(parameters: Parameters, seconds: f32) -> Simulation {
    let steps = (seconds / parameters.time_step) as u32;
    let mut fire = Simulation::new(parameters);
    (0..steps).for_each(|_| fire.step());
    fire
}
