//! Noise advection: the periods of two advected noise patterns.
//!
//! The flow stretches and folds an advected pattern until it is unusable. So two patterns
//! alternate: each is advected for one period, half a period apart, and fades in after its start
//! and out before its end.

/// Time for which a pattern seems to have moved when it starts \[s\]: it has tongues from its first picture on. Its
/// youth would be round blobs between the tongues of the other pattern.
pub const INITIAL_SECONDS: f32 = 0.08;

/// Period of a pattern \[s\]: twice the turnover time τ = l/u' of eddies of its size l = 0.3 b, with u' = 0.85 √(g b) for
/// a source of b metres. The factor of √b is fitted to films of wood fires. A pattern of a longer period only carries
/// light upwards, so the total light of the fire changes too slowly.
pub fn period(source_width: f32) -> f32 {
    source_width.sqrt().clamp(0.45, 1.5) * 0.22
}

/// Time for which a sample moves each pattern \[s\]: that since the sample before, or of a start.
pub fn seconds_moved(kept: [f32; 2], elapsed: f32) -> [f32; 2] {
    kept.map(|kept| INITIAL_SECONDS + kept * (elapsed - INITIAL_SECONDS))
}

/// The phase of the two patterns: periods since the start of the fire.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Phase(pub f64);

hearth_core::state! { Phase(periods) }

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
    fn a_period_follows_the_turnover_of_eddies() {
        for width in [0.3, 0.44, 1.0_f32] {
            let turnover = 0.3 * width / (0.85 * (9.81 * width).sqrt());
            assert!((period(width) / turnover - 2.0).abs() < 0.06, "{width} m");
        }
    }

    #[test]
    fn a_pattern_that_starts_has_moved_already() {
        let [starts, kept] = seconds_moved([0.0, 1.0], 1.0 / 30.0);
        assert_eq!(starts, INITIAL_SECONDS);
        assert!((kept - 1.0 / 30.0).abs() < 1e-6);
    }

    #[test]
    fn slices_read_other_parts_of_the_tile() {
        let phase = Phase(3.2);
        for slice in 1..5 {
            assert_ne!(phase.offsets(slice), phase.offsets(slice - 1));
        }
    }
}
