//! What the particles look like as a whole: where they are, how high they
//! reach, how fast they rise.
//!
//! The drawing needs it twice: nothing is drawn where no particle is, and the
//! fine structure rises with the gas and grows with the flame's own height.
//! Both figures are smoothed in time, so that one particle does not make the
//! structure jump.

use hearth_core::Instance;
use hearth_core::params::Model;

/// Seconds of fire after which a change has reached the smoothed figures.
const SMOOTHING: f32 = 0.5;
/// Longest time between two pictures that still counts as motion \[s\].
const LONGEST_FRAME: f32 = 0.1;
/// Gas that is warmer rises as part of a flame \[K\].
const WARM: f32 = 600.0;

/// A look at all particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Survey {
    /// Left, lower, right and upper edge of everything \[m\]; empty: left > right.
    pub bounds: [f32; 4],
    /// Gas of the classic model: how much of it is still alive.
    alive: Gas,
    /// Gas of the combustion model: how much of it is hot.
    hot: Gas,
}

/// A kind of gas: its amount, and its sums of height \[m\] and upward speed [m/s].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Gas([f32; 3]);

impl Gas {
    fn add(&mut self, amount: f32, height: f32, speed: f32) {
        for (sum, of) in self.0.iter_mut().zip([1.0, height, speed]) {
            *sum += amount * of;
        }
    }

    /// Mean height and speed.
    fn mean(self) -> [f32; 2] {
        let [amount, height, speed] = self.0;
        [height, speed].map(|sum| sum / amount.max(f32::MIN_POSITIVE))
    }
}

impl Survey {
    /// Looks at the particles, of whichever model, and at the embers.
    pub fn of(particles: &[Instance], embers: &[Instance]) -> Survey {
        let far = f32::INFINITY;
        let mut bounds = [far, far, -far, -far];
        let (mut alive, mut hot) = (Gas::default(), Gas::default());
        for &[_, y, _, speed, kelvin, _, _, life] in particles {
            alive.add(life, y, speed);
            hot.add((kelvin - WARM).max(0.0), y, speed);
        }
        for &[x, y, ..] in particles.iter().chain(embers) {
            bounds = [
                bounds[0].min(x),
                bounds[1].min(y),
                bounds[2].max(x),
                bounds[3].max(y),
            ];
        }
        Survey { bounds, alive, hot }
    }
}

/// The smoothed figures.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rise {
    time: Option<f64>,
    /// Mean height of the gas \[m\].
    height: f32,
    /// Mean upward speed of it [m/s].
    speed: f32,
    /// How far the gas has risen since the start \[m\].
    /// A day of it is a hundred kilometres: too many for the steps of an `f32`.
    pub distance: f64,
}

impl Rise {
    /// Takes in what was seen of `model` at `time` \[s\].
    pub fn advance(&mut self, survey: &Survey, time: f64, model: Model) {
        let elapsed = self
            .time
            .map_or(f32::INFINITY, |before| (time - before) as f32);
        self.time = Some(time);
        // The first look counts fully; a clock that was set back or a long
        // pause is no motion.
        let first = elapsed.is_infinite();
        let elapsed = elapsed.clamp(0.0, LONGEST_FRAME);
        let share = if first {
            1.0
        } else {
            1.0 - libm::expf(-elapsed / SMOOTHING)
        };
        let [height, speed] = match model {
            Model::Classic => survey.alive.mean(),
            Model::Combustion => survey.hot.mean(),
        };
        for (smooth, seen) in [(&mut self.height, height), (&mut self.speed, speed)] {
            if seen.is_finite() {
                *smooth += share * (seen - *smooth);
            }
        }
        if !first {
            self.distance += f64::from(elapsed * self.speed);
        }
    }

    /// Height of the flame above `source` \[m\]: the gas thins out upward, so
    /// its tip is about twice as high as its mean.
    pub fn flame_height(&self, source: f32) -> f32 {
        2.2 * (self.height - source)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn particle(x: f32, y: f32, speed: f32) -> Instance {
        [x, y, 0.0, speed, 1500.0, 1.0, 0.1, 1.0]
    }

    #[test]
    fn bounds_hold_every_particle() {
        let survey = Survey::of(&[particle(-0.3, 0.1, 1.0)], &[particle(0.2, 0.9, 1.0)]);
        assert_eq!(survey.bounds, [-0.3, 0.1, 0.2, 0.9]);
        let [left, _, right, _] = Survey::of(&[], &[]).bounds;
        assert!(left > right);
    }

    #[test]
    fn structure_rises_as_fast_as_the_gas() {
        let survey = Survey::of(&[particle(0.0, 0.5, 1.6)], &[]);
        for model in [Model::Classic, Model::Combustion] {
            let mut rise = Rise::default();
            for frame in 0..=60 {
                rise.advance(&survey, f64::from(frame) / 60.0, model);
            }
            assert!((rise.distance - 1.6).abs() < 0.01, "{rise:?}");
        }
    }

    #[test]
    fn a_pause_or_a_restart_does_not_make_it_jump() {
        let survey = Survey::of(&[particle(0.0, 0.5, 2.0)], &[]);
        let mut rise = Rise::default();
        for time in [0.0, 100.0, 0.0, 0.0, 500.0] {
            rise.advance(&survey, time, Model::Classic);
        }
        assert!((0.0..=0.5).contains(&rise.distance), "{rise:?}");
    }

    #[test]
    fn no_particles_are_no_trouble() {
        let mut rise = Rise::default();
        rise.advance(&Survey::of(&[], &[]), 0.0, Model::Combustion);
        let nowhere = Survey::of(&[particle(0.0, f32::NAN, f32::NAN)], &[]);
        rise.advance(&nowhere, 0.1, Model::Combustion);
        assert!(rise.distance.is_finite() && rise.flame_height(0.0).is_finite());
    }
}
