//! The random generator.
//!
//! PCG32 (O'Neill 2014, the XSH-RR variant): small, fast, and the same sequence on every
//! machine.

/// A seeded generator.
#[derive(Clone, Debug)]
pub struct Random {
    state: u64,
}

crate::state! { Random: state }

const MULTIPLIER: u64 = 6_364_136_223_846_793_005;
const INCREMENT: u64 = 1_442_695_040_888_963_407;

impl Random {
    /// A generator with this seed.
    pub fn new(seed: u32) -> Random {
        let mut random = Random {
            state: INCREMENT.wrapping_add(u64::from(seed)),
        };
        random.bits();
        random
    }

    /// 32 random bits.
    pub fn bits(&mut self) -> u32 {
        let old = self.state;
        self.state = old.wrapping_mul(MULTIPLIER).wrapping_add(INCREMENT);
        let shifted = (((old >> 18) ^ old) >> 27) as u32;
        shifted.rotate_right((old >> 59) as u32)
    }

    /// A number from 0 up to but not including 1.
    pub fn unit(&mut self) -> f32 {
        // An f32 holds 24 bits.
        (self.bits() >> 8) as f32 / (1 << 24) as f32
    }

    /// A number from `low` up to `high`.
    pub fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.unit()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_seed_gives_the_same_sequence() {
        let (mut a, mut b) = (Random::new(7), Random::new(7));
        assert!((0..1000).all(|_| a.bits() == b.bits()));
    }

    #[test]
    fn seeds_give_different_sequences() {
        let (mut a, mut b) = (Random::new(7), Random::new(8));
        assert!((0..10).any(|_| a.bits() != b.bits()));
    }

    #[test]
    fn it_is_uniform() {
        let mut random = Random::new(1);
        let n = 100_000;
        let mut tenths = [0u32; 10];
        for _ in 0..n {
            tenths[(random.unit() * 10.0) as usize] += 1;
        }
        // Five standard deviations of a binomial count.
        let expected = n as f32 / 10.0;
        let allowed = 5.0 * (expected * 0.9).sqrt();
        for count in tenths {
            assert!((count as f32 - expected).abs() < allowed, "{tenths:?}");
        }
    }
}
