//! Noise advection: the periods of two advected noise patterns.
//!
//! The flow stretches and folds an advected pattern until it is unusable. So two patterns
//! alternate: each is advected for one period, half a period apart, and fades in after its start
//! and out before its end.

/// Maximum time between two pictures of continuous motion \[s\].
const MAX_PICTURE_INTERVAL: f64 = 0.1;
/// Time of advection in a picture without a predecessor \[s\], so that a paused fire looks as if
/// it had moved.
const INITIAL_SECONDS: f32 = 0.08;

/// Period of a pattern \[s\]: the time in which gas rises by a few widths of the source \[m\].
pub fn period(source_width: f32) -> f32 {
    source_width.sqrt().clamp(0.25, 1.5) * 0.75
}

/// State of the two patterns.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Advection {
    time: Option<f64>,
    /// Periods since the start.
    periods: f64,
    /// Time of advection since the last picture \[s\].
    pub elapsed: f32,
    /// For each pattern: 0 if it restarts in this picture, else 1.
    pub kept: [f32; 2],
}

impl Advection {
    /// Advances to `time` \[s\], with periods of `period` \[s\].
    pub fn advance(&mut self, time: f64, period: f32) {
        let elapsed = self.time.map_or(-1.0, |before| time - before);
        self.time = Some(time);
        // A reset of the time or a long pause is no motion.
        let is_moving = (0.0..=MAX_PICTURE_INTERVAL).contains(&elapsed);
        let before = [0.0, 0.5].map(|start| (self.periods + start).floor());
        self.elapsed = if is_moving {
            elapsed as f32
        } else {
            INITIAL_SECONDS
        };
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

    /// Share of each pattern. The variance of the sum is that of one pattern.
    pub fn shares(&self) -> [f32; 2] {
        let shares = [0.0, 0.5].map(|start| {
            let age = (self.periods + start).fract() as f32;
            1.0 - (2.0 * age - 1.0).abs()
        });
        let both = (shares[0] * shares[0] + shares[1] * shares[1]).sqrt();
        shares.map(|share| share / both)
    }

    /// Offsets of the patterns in the noise tile, different after each restart: x and y of the
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
    fn a_pattern_is_invisible_when_it_restarts() {
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
    fn a_pause_or_a_reset_restarts_both_patterns() {
        let mut advection = Advection::default();
        for time in [0.0, 100.0, 0.0, 500.0] {
            advection.advance(time, 0.6);
            assert_eq!(
                (advection.elapsed, advection.kept),
                (INITIAL_SECONDS, [0.0; 2])
            );
        }
        advection.forget();
        advection.advance(500.0, 0.6);
        assert_eq!(advection.kept, [0.0; 2]);
    }

    #[test]
    fn drawing_a_picture_twice_gives_the_same_state() {
        let mut advection = Advection::default();
        advection.advance(1.0, 0.6);
        let (shares, starts) = (advection.shares(), advection.starts());
        advection.advance(1.0, 0.6);
        assert_eq!((advection.elapsed, advection.kept), (0.0, [1.0; 2]));
        assert_eq!((advection.shares(), advection.starts()), (shares, starts));
    }
}
