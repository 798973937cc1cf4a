//! The nozzle of a spray.

use glam::Vec2;

use super::report::Droplets;
use super::state::Water;
use crate::extremes::{fast_max, fast_min};
use crate::random::Random;

/// Parcels of a spray, and most in the air.
const PARCELS_PER_SPRAY: usize = 16;
const MAX_PARCELS: usize = 2000;
/// Time over which the droplets of a spray leave the nozzle \[s\].
const SPRAY_TIME: f32 = 0.05;
/// Half of the opening of the jet, as a slope, and the spread of the speeds.
const JET_SLOPE: f32 = 0.22;
const SPEED_SPREAD: f32 = 0.15;
/// Median diameter by volume \[m\], that of a fine spray from a hose or a sprinkler (Grant, Brenton &
/// Drysdale 2000, 2.2), and the exponent of the distribution of Rosin and Rammler (1933) that fits
/// sprays of fire protection (2.4: FDS Technical Reference Guide, 8.2).
const MEDIAN_DIAMETER: f32 = 0.7e-3;
const ROSIN_RAMMLER_EXPONENT: f32 = 2.4;
/// Smallest and largest diameter \[m\].
const MIN_DIAMETER: f32 = 0.3e-3;
const MAX_DIAMETER: f32 = 1.5e-3;
/// Most particles around a droplet in usual gas.
const MAX_NEIGHBOURS: usize = 256;
/// Fastest droplet [m/s], and largest mass of a spray [kg/m].
const MAX_SPEED: f32 = 20.0;
const MAX_MASS: f32 = 1.0;

impl Water {
    /// Sprays a mass of water [kg/m] of a temperature \[K\] from a place within a twentieth of a second.
    // It would be inlined into the first download.
    #[inline(never)]
    pub fn spray(
        &mut self,
        place: Vec2,
        velocity: Vec2,
        mass: f32,
        temperature: f32,
        random: &mut Random,
    ) {
        self.reserve(MAX_PARCELS);
        let room = PARCELS_PER_SPRAY.min(MAX_PARCELS.saturating_sub(self.parcels.len()));
        let each = fast_min(mass, MAX_MASS) / PARCELS_PER_SPRAY as f32;
        let velocity = velocity.clamp_length_max(MAX_SPEED);
        for _ in 0..room {
            let aside = JET_SLOPE * random.between(-1.0, 1.0);
            let faster = random.between(1.0 - SPEED_SPREAD, 1.0 + SPEED_SPREAD);
            self.parcels.push(Droplets {
                position: place,
                velocity: (velocity + aside * velocity.perp()) * faster,
                temperature,
                diameter: diameter(random.unit()),
                mass: each,
                first: each,
                waits: SPRAY_TIME * random.unit(),
            });
            self.account.sprayed += f64::from(each);
        }
    }

    /// Makes room, so that a warm step allocates nothing.
    fn reserve(&mut self, parcels: usize) {
        let more = parcels.saturating_sub(self.parcels.len());
        self.parcels.reserve(more);
        self.near
            .reserve(MAX_NEIGHBOURS.saturating_sub(self.near.len()));
        self.steam.reserve();
    }
}

/// The diameter below which this share of the volume is.
fn diameter(share: f32) -> f32 {
    let decades = -libm::logf(1.0 - share) / std::f32::consts::LN_2;
    let ratio = libm::expf(libm::logf(fast_max(decades, 1e-6)) / ROSIN_RAMMLER_EXPONENT);
    fast_min(
        fast_max(MEDIAN_DIAMETER * ratio, MIN_DIAMETER),
        MAX_DIAMETER,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_of_the_volume_is_in_droplets_below_the_median() {
        assert!((diameter(0.5) / MEDIAN_DIAMETER - 1.0).abs() < 1e-3);
        let all: Vec<_> = (0..1000).map(|at| diameter(at as f32 / 1000.0)).collect();
        assert!(all.is_sorted());
        assert_eq!((all[0], all[999]), (MIN_DIAMETER, MAX_DIAMETER));
    }
}
