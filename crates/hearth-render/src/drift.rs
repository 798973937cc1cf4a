//! Where the fine structure has come from: when its two patterns of noise,
//! carried along by the gas, start anew.
//!
//! Gas stretches and folds whatever it carries, soon too much. So there are
//! two patterns, each carried for one period, the second half a period later
//! than the first, and each fades in after its start and out before its end.

/// Longest time between two pictures that still counts as motion \[s\].
const LONGEST_FRAME: f64 = 0.1;
/// How long the gas has carried the patterns in a picture without one before
/// it, as it moves in that picture \[s\]: fire that stands still has been moving.
const AT_ONCE: f32 = 0.08;

/// The two patterns.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Drift {
    time: Option<f64>,
    /// Periods since the start.
    periods: f64,
    /// How long the gas has carried them since the last picture \[s\].
    pub elapsed: f32,
    /// For each: 1, or 0 where it starts anew in this picture.
    pub kept: [f32; 2],
}

impl Drift {
    /// Goes on to `time` \[s\], where a period takes `period` \[s\].
    pub fn advance(&mut self, time: f64, period: f32) {
        let elapsed = self.time.map_or(-1.0, |before| time - before);
        self.time = Some(time);
        // A clock that was set back or a long pause is no motion.
        let moving = (0.0..=LONGEST_FRAME).contains(&elapsed);
        let before = [0.0, 0.5].map(|start| (self.periods + start).floor());
        self.elapsed = if moving { elapsed as f32 } else { AT_ONCE };
        if moving {
            self.periods += elapsed / f64::from(period);
        }
        let now = [0.0, 0.5].map(|start| (self.periods + start).floor());
        self.kept = [0, 1].map(|k| f32::from(moving && now[k] == before[k]));
    }

    /// The next picture is one without one before it.
    pub fn forget(&mut self) {
        self.time = None;
    }

    /// How much of each is seen. Together they vary as much as one alone.
    pub fn shares(&self) -> [f32; 2] {
        let shares = [0.0, 0.5].map(|start| {
            let age = (self.periods + start).fract() as f32;
            1.0 - (2.0 * age - 1.0).abs()
        });
        let both = (shares[0] * shares[0] + shares[1] * shares[1]).sqrt();
        shares.map(|share| share / both)
    }

    /// Where in the tile of noise each begins, elsewhere every time: x and y of
    /// the first, then of the second.
    pub fn places(&self) -> [f32; 4] {
        let [a, b] = [0.0, 0.5].map(|start| (self.periods + start).floor());
        [a * 0.618 + 0.1, a * 0.414, b * 0.618 + 0.6, b * 0.414 + 0.3].map(|x| x.fract() as f32)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pattern_is_unseen_while_it_starts_anew() {
        let mut drift = Drift::default();
        let mut starts = 0;
        for frame in 0..200 {
            drift.advance(f64::from(frame) / 60.0, 0.6);
            for (kept, share) in drift.kept.into_iter().zip(drift.shares()) {
                if kept == 0.0 && frame > 0 {
                    starts += 1;
                    assert!(share < 0.07, "{drift:?}");
                }
            }
        }
        assert!((9..=12).contains(&starts), "{starts}");
    }

    #[test]
    fn a_pause_or_a_restart_starts_anew() {
        let mut drift = Drift::default();
        for time in [0.0, 100.0, 0.0, 500.0] {
            drift.advance(time, 0.6);
            assert_eq!((drift.elapsed, drift.kept), (AT_ONCE, [0.0; 2]));
        }
        drift.forget();
        drift.advance(500.0, 0.6);
        assert_eq!(drift.kept, [0.0; 2]);
    }

    #[test]
    fn the_same_picture_again_is_the_same() {
        let mut drift = Drift::default();
        drift.advance(1.0, 0.6);
        let (shares, places) = (drift.shares(), drift.places());
        drift.advance(1.0, 0.6);
        assert_eq!((drift.elapsed, drift.kept), (0.0, [1.0; 2]));
        assert_eq!((drift.shares(), drift.places()), (shares, places));
    }
}
