//! Lighting and putting out, as scripts call it.

use hearth_core::{IgniteError, IgnitionTarget, Simulation, Vec2};
use hearth_settings::untrusted::{Untrusted, ValidationError};

/// Lights what is within a radius of a position \[m\] or, unless `lit`, puts it out; 0 is the usual
/// radius. With a radius below 0, `place` is the id of a solid with fuel.
///
/// # Errors
/// There is no fuel.
pub fn light(
    simulation: &mut Simulation,
    lit: bool,
    [radius, place, y]: [f64; 3],
) -> Result<(), ValidationError> {
    let id = place as u32;
    let at = if radius >= 0.0 {
        Some(IgnitionTarget::Place(
            Vec2::new(place as f32, y as f32),
            radius as f32,
        ))
    } else {
        // The conversion rounds and saturates.
        (f64::from(id) == place).then_some(IgnitionTarget::Object(id))
    };
    let act = if lit {
        Simulation::ignite
    } else {
        Simulation::extinguish
    };
    at.ok_or(IgniteError)
        .and_then(|at| act(simulation, at))
        .map_err(|_| ValidationError::new("place", &Untrusted::Number(place), IgniteError::ALLOWED))
}

#[cfg(test)]
mod tests {
    use super::*;
    use hearth_settings::{Change, Settings};

    /// A fire with a log, whose id is 2.
    fn fire() -> Simulation {
        let log = [("kind", "solid"), ("fuel", "wood")];
        let log = log.map(|(id, value)| Untrusted::field_of(id, Untrusted::Text(value.to_owned())));
        let settings = Settings::default().after(&Change::AddObject(&log));
        let settings = settings.expect("a log is a valid object");
        Simulation::new(settings.scene().clone())
    }

    #[test]
    fn a_number_between_two_ids_lights_neither() {
        let mut fire = fire();
        let states = |fire: &Simulation| -> Vec<_> {
            let solids = fire.burning_solids().into_iter();
            solids.map(|solid| (solid.id, solid.state)).collect()
        };
        let unlit = states(&fire);
        assert_eq!(unlit.len(), 1);
        for place in [2.9, 1.1, -2.0, 4_294_967_298.0, f64::NAN] {
            let error = light(&mut fire, true, [-1.0, place, 0.0]).expect_err("no solid has it");
            assert!(error.message.contains(IgniteError::ALLOWED), "{error:?}");
        }
        fire.step();
        assert_eq!(states(&fire), unlit);
        assert_eq!(light(&mut fire, true, [-1.0, 2.0, 0.0]), Ok(()));
        fire.step();
        assert_ne!(states(&fire), unlit);
    }
}
