//! How high and how fast the gas rises, smoothed in time, so that one particle does not make
//! the fine structure jump.

use hearth_core::params::Model;

use crate::bounds::ParticleBounds;

/// Seconds of fire after which a change has reached the smoothed figures.
const SMOOTHING: f32 = 0.5;
/// Longest time between two pictures that still counts as motion \[s\].
const LONGEST_FRAME: f32 = 0.1;
/// Height of a flame in mean heights of its gas, which thins out upward.
const TIP: f32 = 2.2;

/// The smoothed figures of a fire.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rise {
    time: Option<f64>,
    /// Mean height of the gas \[m\].
    height: f32,
    /// Mean upward speed of it [m/s].
    speed: f32,
    /// How far the gas has risen since the start \[m\]: a hundred kilometres a day, too many
    /// for the steps of an `f32`.
    pub distance: f64,
}

impl Rise {
    /// Takes in the particles of `model` at `time` \[s\].
    pub fn advance(&mut self, particles: &ParticleBounds, time: f64, model: Model) {
        let elapsed = self
            .time
            .map_or(f32::INFINITY, |before| (time - before) as f32);
        self.time = Some(time);
        // The first picture counts fully. A clock that was set back, or a long pause, is no
        // motion.
        let first = elapsed.is_infinite();
        let elapsed = elapsed.clamp(0.0, LONGEST_FRAME);
        let share = if first {
            1.0
        } else {
            1.0 - libm::expf(-elapsed / SMOOTHING)
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

    /// Height of the flame above `source` \[m\].
    pub fn flame_height(&self, source: f32) -> f32 {
        TIP * (self.height - source)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bounds::tests::particle;

    #[test]
    fn structure_rises_as_fast_as_the_gas() {
        let particles = ParticleBounds::of(&[particle(0.0, 0.5, 1.6)], &[]);
        for model in [Model::Classic, Model::Combustion] {
            let mut rise = Rise::default();
            for frame in 0..=60 {
                rise.advance(&particles, f64::from(frame) / 60.0, model);
            }
            assert!((rise.distance - 1.6).abs() < 0.01, "{rise:?}");
        }
    }

    #[test]
    fn a_pause_or_a_restart_does_not_make_it_jump() {
        let particles = ParticleBounds::of(&[particle(0.0, 0.5, 2.0)], &[]);
        let mut rise = Rise::default();
        for time in [0.0, 100.0, 0.0, 0.0, 500.0] {
            rise.advance(&particles, time, Model::Classic);
        }
        assert!((0.0..=0.5).contains(&rise.distance), "{rise:?}");
    }

    #[test]
    fn no_particles_and_nan_leave_finite_figures() {
        let mut rise = Rise::default();
        rise.advance(&ParticleBounds::of(&[], &[]), 0.0, Model::Combustion);
        let nowhere = ParticleBounds::of(&[particle(0.0, f32::NAN, f32::NAN)], &[]);
        rise.advance(&nowhere, 0.1, Model::Combustion);
        assert!(rise.distance.is_finite() && rise.flame_height(0.0).is_finite());
    }
}
