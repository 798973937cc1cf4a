//! Noise advection: the periods of two advected noise patterns.
//!
//! The flow stretches and folds an advected pattern until it is unusable. So two patterns
//! alternate: each is advected for one period, half a period apart, and fades in after its start
//! and out before its end.

/// Time of advection of a sample without a predecessor \[s\], so that a single picture of a fire
/// looks as if it had moved.
pub const INITIAL_SECONDS: f32 = 0.08;

/// Period of a pattern \[s\]: the time in which gas rises by a few widths of the source \[m\].
pub fn period(source_width: f32) -> f32 {
    source_width.sqrt().clamp(0.25, 1.5) * 0.75
}

/// The phase of the two patterns: periods since the start of the fire.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Phase(pub f64);

impl Phase {
    /// For each pattern: 0 if it restarts after an earlier phase, else 1.
    pub fn kept_since(self, before: Phase) -> [f32; 2] {
        [0, 1].map(|k| f32::from(self.starts_of()[k] == before.starts_of()[k]))
    }

    /// Share of each pattern. The variance of the sum is that of one pattern.
    pub fn shares(self) -> [f32; 2] {
        let shares = [0.0, 0.5].map(|start| {
            let age = (self.0 + start).fract() as f32;
            1.0 - (2.0 * age - 1.0).abs()
        });
        let both = (shares[0] * shares[0] + shares[1] * shares[1]).sqrt();
        shares.map(|share| share / both)
    }

    /// Offsets of the patterns in the noise tile, different after each restart and in each slice:
    /// x and y of the first, then of the second.
    pub fn offsets(self, slice: usize) -> [f32; 4] {
        let [a, b] = self.starts_of();
        let k = slice as f64;
        [
            a * 0.618 + 0.1 + 0.37 * k,
            a * 0.414 + 0.71 * k,
            b * 0.618 + 0.6 + 0.29 * k,
            b * 0.414 + 0.3 + 0.53 * k,
        ]
        .map(|x| x.fract() as f32)
    }

    /// The number of starts of each pattern.
    fn starts_of(self) -> [f64; 2] {
        [0.0, 0.5].map(|start| (self.0 + start).floor())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pattern_is_invisible_when_it_restarts() {
        let mut starts = 0;
        let mut before = Phase(0.0);
        for frame in 0..200 {
            let now = Phase(f64::from(frame) / 60.0 / 0.6);
            for (kept, share) in now.kept_since(before).into_iter().zip(now.shares()) {
                if kept == 0.0 {
                    starts += 1;
                    assert!(share < 0.07, "{now:?}");
                }
            }
            before = now;
        }
        assert!((9..=12).contains(&starts), "{starts}");
    }

    #[test]
    fn both_patterns_restart_within_a_period() {
        for start in [0.0, 0.3, 0.5, 7.9] {
            assert_eq!(Phase(start + 1.0).kept_since(Phase(start)), [0.0; 2]);
        }
    }

    #[test]
    fn slices_read_other_parts_of_the_tile() {
        let phase = Phase(3.2);
        for slice in 1..5 {
            assert_ne!(phase.offsets(slice), phase.offsets(slice - 1));
        }
    }
}
