//! Noise advection: when the two noise patterns that the gas carries start again.
//!
//! Gas stretches and folds whatever it carries, soon too much. So there are two patterns, each
//! carried for one period, the second half a period later than the first. Each fades in after
//! its start and out before its end.

/// Longest time between two pictures that still counts as motion \[s\].
const LONGEST_FRAME: f64 = 0.1;
/// How long the gas has carried the patterns in a picture without a predecessor \[s\]: a fire
/// that stands still has moved before.
const AT_ONCE: f32 = 0.08;

/// How long the gas carries a pattern \[s\]: as long as it takes to rise by a few widths of the
/// source \[m\].
pub fn period(source_width: f32) -> f32 {
    source_width.sqrt().clamp(0.25, 1.5) * 0.75
}

/// State of the two patterns.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Advection {
    time: Option<f64>,
    /// Periods since the start.
    periods: f64,
    /// How long the gas has carried the patterns since the last picture \[s\].
    pub elapsed: f32,
    /// For each pattern: 1, or 0 if it starts again in this picture.
    pub kept: [f32; 2],
}

impl Advection {
    /// Advances to `time` \[s\], with periods of `period` \[s\].
    pub fn advance(&mut self, time: f64, period: f32) {
        let elapsed = self.time.map_or(-1.0, |before| time - before);
        self.time = Some(time);
        // A clock that was set back or a long pause is no motion.
        let is_moving = (0.0..=LONGEST_FRAME).contains(&elapsed);
        let before = [0.0, 0.5].map(|start| (self.periods + start).floor());
        self.elapsed = if is_moving { elapsed as f32 } else { AT_ONCE };
        if is_moving {
            self.periods += elapsed / f64::from(period);
        }
        let now = [0.0, 0.5].map(|start| (self.periods + start).floor());
        self.kept = [0, 1].map(|k| f32::from(is_moving && now[k] == before[k]));
    }

    /// Makes the next picture one without a predecessor.
    pub fn forget(&mut self) {
        self.time = None;
    }

    /// How much of each pattern is seen. Together they vary as much as one alone.
    pub fn shares(&self) -> [f32; 2] {
        let shares = [0.0, 0.5].map(|start| {
            let age = (self.periods + start).fract() as f32;
            1.0 - (2.0 * age - 1.0).abs()
        });
        let both = (shares[0] * shares[0] + shares[1] * shares[1]).sqrt();
        shares.map(|share| share / both)
    }

    /// Where in the tile of noise each pattern starts, elsewhere every time: x and y of the
    /// first, then of the second.
    pub fn starts(&self) -> [f32; 4] {
        let [a, b] = [0.0, 0.5].map(|start| (self.periods + start).floor());
        [a * 0.618 + 0.1, a * 0.414, b * 0.618 + 0.6, b * 0.414 + 0.3].map(|x| x.fract() as f32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pattern_is_unseen_while_it_starts_again() {
        let mut advection = Advection::default();
        let mut starts = 0;
        for frame in 0..200 {
            advection.advance(f64::from(frame) / 60.0, 0.6);
            for (kept, share) in advection.kept.into_iter().zip(advection.shares()) {
                if kept == 0.0 && frame > 0 {
                    starts += 1;
                    assert!(share < 0.07, "{advection:?}");
                }
            }
        }
        assert!((9..=12).contains(&starts), "{starts}");
    }

    #[test]
    fn a_pause_or_a_restart_starts_both_again() {
        let mut advection = Advection::default();
        for time in [0.0, 100.0, 0.0, 500.0] {
            advection.advance(time, 0.6);
            assert_eq!((advection.elapsed, advection.kept), (AT_ONCE, [0.0; 2]));
        }
        advection.forget();
        advection.advance(500.0, 0.6);
        assert_eq!(advection.kept, [0.0; 2]);
    }

    #[test]
    fn the_same_picture_again_is_the_same() {
        let mut advection = Advection::default();
        advection.advance(1.0, 0.6);
        let (shares, starts) = (advection.shares(), advection.starts());
        advection.advance(1.0, 0.6);
        assert_eq!((advection.elapsed, advection.kept), (0.0, [1.0; 2]));
        assert_eq!((advection.shares(), advection.starts()), (shares, starts));
    }
}
