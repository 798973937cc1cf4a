//! The body forces of the combustion model: one line each in [`add_all`].

mod buoyancy;
mod wind;

use super::Gas;
use crate::forces::turbulence::Turbulence;
use crate::forces::{BodyForce, LocalGas};
use crate::params::Physics;
use buoyancy::Buoyancy;
use wind::Wind;

/// Adds every body force to the accelerations of the gas, in this order; a force of
/// the caller comes last.
pub(crate) fn add_all(gas: &mut Gas, values: &Physics, time: f64, user: Option<&dyn BodyForce>) {
    add(gas, Buoyancy::new(values).as_ref());
    add(gas, Turbulence::new(values, time).as_ref());
    add(gas, Wind::new(values, &gas.velocity).as_ref());
    add(gas, user);
}

/// Adds one force; one that is off is `None`.
fn add<F: BodyForce + ?Sized>(gas: &mut Gas, force: Option<&F>) {
    let Some(force) = force else {
        return;
    };
    let motions = gas.position.iter().zip(&gas.velocity);
    let states = gas.state.iter().zip(&gas.expansion);
    let local = motions.zip(states);
    for (acceleration, ((position, velocity), (state, expansion))) in
        gas.acceleration.iter_mut().zip(local)
    {
        *acceleration += force.acceleration(&LocalGas {
            position: *position,
            velocity: *velocity,
            temperature: state.x,
            expansion: *expansion,
        });
    }
}
