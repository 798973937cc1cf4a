//! Mean height and speed of the rising gas, smoothed in time so that single particles do not make
//! the fine structure jump.

use hearth_core::params::Model;

use crate::bounds::ParticleBounds;

/// Time constant of the smoothing [s of fire].
const SMOOTHING_SECONDS: f32 = 0.5;
/// Maximum time between two samples of continuous motion \[s\].
const MAX_INTERVAL: f32 = 0.1;
/// Height of a flame relative to the mean height of its gas, which thins out upwards.
const TIP_PER_MEAN_HEIGHT: f32 = 2.2;

/// The smoothed motion of a fire.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rise {
    time: Option<f64>,
    /// Mean height of the gas \[m\].
    height: f32,
    /// Mean upward speed of the gas [m/s].
    speed: f32,
    /// Distance that the gas has risen \[m\]. A hundred kilometres per day exceed the precision of
    /// an `f32`.
    distance: f64,
}

hearth_core::state! { Rise: time height speed distance }

impl Rise {
    /// Advances to `time` \[s\] with the particles of `model`.
    pub fn advance(&mut self, particles: &ParticleBounds, time: f64, model: Model) {
        let elapsed = self
            .time
            .map_or(f32::INFINITY, |before| (time - before) as f32);
        self.time = Some(time);
        // The first sample counts fully. A reset of the time or a long pause is no motion.
        let first = elapsed.is_infinite();
        let elapsed = elapsed.clamp(0.0, MAX_INTERVAL);
        let share = if first {
            1.0
        } else {
            1.0 - libm::expf(-elapsed / SMOOTHING_SECONDS)
        };
        let [height, speed] = particles.mean(model);
        for (smooth, now) in [(&mut self.height, height), (&mut self.speed, speed)] {
            if now.is_finite() {
                *smooth += share * (now - *smooth);
            }
        }
        if !first {
            self.distance += f64::from(elapsed * self.speed);
        }
    }

    /// Distance that the gas has risen at a time after the last sample \[m\].
    pub fn distance_at(&self, time: f64) -> f64 {
        let elapsed = self.time.map_or(0.0, |last| time - last);
        self.distance + elapsed.clamp(0.0, f64::from(MAX_INTERVAL)) * f64::from(self.speed)
    }

    /// Height of the flame above `source` \[m\].
    pub fn flame_height(&self, source: f32) -> f32 {
        TIP_PER_MEAN_HEIGHT * (self.height - source)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bounds::tests::particle;

    #[test]
    fn the_distance_grows_with_the_speed_of_the_gas() {
        let particles = ParticleBounds::of(&[particle(0.0, 0.5, 1.6)]);
        for model in [Model::Classic, Model::Combustion] {
            let mut rise = Rise::default();
            for frame in 0..=60 {
                rise.advance(&particles, f64::from(frame) / 60.0, model);
            }
            assert!((rise.distance - 1.6).abs() < 0.01, "{rise:?}");
        }
    }

    #[test]
    fn a_pause_or_a_reset_does_not_make_the_distance_jump() {
        let particles = ParticleBounds::of(&[particle(0.0, 0.5, 2.0)]);
        let mut rise = Rise::default();
        for time in [0.0, 100.0, 0.0, 0.0, 500.0] {
            rise.advance(&particles, time, Model::Classic);
        }
        assert!((0.0..=0.5).contains(&rise.distance), "{rise:?}");
    }

    #[test]
    fn the_motion_stays_finite_without_particles_and_with_nan() {
        let mut rise = Rise::default();
        rise.advance(&ParticleBounds::of(&[]), 0.0, Model::Combustion);
        let nowhere = ParticleBounds::of(&[particle(0.0, f32::NAN, f32::NAN)]);
        rise.advance(&nowhere, 0.1, Model::Combustion);
        assert!(rise.distance.is_finite() && rise.flame_height(0.0).is_finite());
    }
}
