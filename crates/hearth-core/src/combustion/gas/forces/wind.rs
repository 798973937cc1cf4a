//! Wind: a uniform acceleration that keeps the mean velocity of the air at the wind's.
//! Without it only the seam would drive the air, and the middle would take minutes to follow.

use glam::Vec2;

use crate::forces::{BodyForce, LocalGas};
use crate::params::{Edges, Physics};

/// Time in which the wind accelerates all of the air \[s\].
const RESPONSE_TIME: f32 = 0.3;

/// The wind during one step.
pub(super) struct Wind {
    acceleration: f32,
}

impl Wind {
    /// The wind for gas of these velocities; `None` in a domain without a seam, and in open air,
    /// into which the wind blows.
    pub fn new(values: &Physics, velocities: &[Vec2]) -> Option<Wind> {
        if values.edges == Edges::Open || values.seam == 0.0 {
            return None;
        }
        let sum: f64 = velocities.iter().map(|v| f64::from(v.x)).sum();
        let mean = (sum / velocities.len().max(1) as f64) as f32;
        Some(Wind {
            acceleration: (values.wind - mean) / RESPONSE_TIME,
        })
    }
}

impl BodyForce for Wind {
    #[inline]
    fn acceleration(&self, _gas: &LocalGas) -> Vec2 {
        Vec2::new(self.acceleration, 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::combustion::gas::tests::with;

    #[test]
    fn air_slower_than_the_wind_speeds_up_and_faster_air_slows_down() {
        let parameters = with(&[("wind", 2.0)]);
        let gas = |x: f32| [Vec2::new(x - 1.0, 5.0), Vec2::new(x + 1.0, -5.0)];
        let found = |x| Wind::new(&parameters, &gas(x)).map(|wind| wind.acceleration);
        assert_eq!(found(2.0), Some(0.0));
        assert_eq!(found(0.5), Some(1.5 / RESPONSE_TIME));
        assert_eq!(found(3.5), Some(-1.5 / RESPONSE_TIME));
    }

    #[test]
    fn without_a_seam_there_is_no_wind() {
        let parameters = with(&[("seam", 0.0), ("wind", 3.0)]);
        assert!(Wind::new(&parameters, &[]).is_none());
    }
}
