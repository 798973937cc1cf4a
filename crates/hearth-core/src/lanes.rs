//! Four numbers that one instruction processes at once.
//!
//! SSE2 on x86-64, NEON on 64-bit ARM, 128-bit SIMD in wasm, and one number after the
//! other elsewhere. All of them give the same bits: every operation is exact to the last bit
//! as IEEE 754 defines it, without fused multiplication and approximate roots, and each
//! comparison states which operand it returns.

mod register;

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use glam::Vec4;

use crate::extremes;

/// Number of lanes.
pub(crate) const LANES: usize = 4;

/// Four numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(transparent)]
pub(crate) struct Lanes(Vec4);

impl Lanes {
    pub const ZERO: Lanes = Lanes(Vec4::ZERO);

    /// The same number in all lanes.
    #[inline(always)]
    pub const fn splat(number: f32) -> Lanes {
        Lanes(Vec4::splat(number))
    }

    #[inline(always)]
    pub const fn new(numbers: [f32; LANES]) -> Lanes {
        Lanes(Vec4::from_array(numbers))
    }

    #[inline(always)]
    pub const fn to_array(self) -> [f32; LANES] {
        self.0.to_array()
    }

    /// The number of one lane in all lanes.
    #[inline(always)]
    pub fn broadcast(&self, lane: usize) -> Lanes {
        // By reference: one load reads and repeats the number of a lane that is not constant.
        Lanes::splat(self.0.as_ref()[lane])
    }

    /// Each lane has the number of the next one, and the last lane that of the first.
    #[inline(always)]
    pub fn rotated(self) -> Lanes {
        let [a, b, c, d] = self.to_array();
        Lanes::new([b, c, d, a])
    }

    /// The nearest integers of numbers from 0 to below 2²³.
    #[inline(always)]
    pub fn nearest_integers(self) -> [u32; LANES] {
        // At 2²³ the last bit of a float has the weight 1.
        const WHOLE: f32 = 8_388_608.0;
        let numbers = (self + WHOLE).to_array();
        numbers.map(|number| number.to_bits() & (WHOLE as u32 - 1))
    }

    /// The first `count` lanes; zero in the others.
    #[inline]
    pub fn keep_first(self, count: usize) -> Lanes {
        let numbers = self.to_array();
        Lanes::new([0, 1, 2, 3].map(|lane| if lane < count { numbers[lane] } else { 0.0 }))
    }

    /// The largest of the four.
    #[inline(always)]
    pub fn max_lane(self) -> f32 {
        let [a, b, c, d] = self.to_array();
        extremes::fast_max(extremes::fast_max(a, b), extremes::fast_max(c, d))
    }

    #[inline(always)]
    pub fn sqrt(self) -> Lanes {
        Lanes(register::sqrt(self.0.into()).into())
    }

    #[inline(always)]
    pub fn abs(self) -> Lanes {
        Lanes(self.0.abs())
    }

    /// A bit mask of the lanes that are less than those of `other`; bit 0 is the first lane.
    #[inline(always)]
    pub fn less_mask(self, other: Lanes) -> u32 {
        register::less_mask(self.0.into(), other.0.into())
    }
}

/// Operations of one number and of four at once, so that a formula is written once.
pub(crate) trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// The number in every lane.
    fn splat(number: f32) -> Self;
    /// The minimum; `other` if either is NaN or both are equal.
    fn fast_min(self, other: Self) -> Self;
    /// The maximum; `other` if either is NaN or both are equal.
    fn fast_max(self, other: Self) -> Self;
}

impl Real for f32 {
    #[inline(always)]
    fn splat(number: f32) -> f32 {
        number
    }
    #[inline(always)]
    fn fast_min(self, other: f32) -> f32 {
        extremes::fast_min(self, other)
    }
    #[inline(always)]
    fn fast_max(self, other: f32) -> f32 {
        extremes::fast_max(self, other)
    }
}

impl Real for Lanes {
    #[inline(always)]
    fn splat(number: f32) -> Lanes {
        Lanes::splat(number)
    }
    #[inline(always)]
    fn fast_min(self, other: Lanes) -> Lanes {
        Lanes(register::fast_min(self.0.into(), other.0.into()).into())
    }
    #[inline(always)]
    fn fast_max(self, other: Lanes) -> Lanes {
        Lanes(register::fast_max(self.0.into(), other.0.into()).into())
    }
}

macro_rules! operators {
    ($($operator:ident $apply:ident)*) => {$(
        impl $operator for Lanes {
            type Output = Lanes;
            #[inline(always)]
            fn $apply(self, other: Lanes) -> Lanes {
                Lanes(self.0.$apply(other.0))
            }
        }
        impl $operator<f32> for Lanes {
            type Output = Lanes;
            #[inline(always)]
            fn $apply(self, other: f32) -> Lanes {
                self.$apply(Lanes::splat(other))
            }
        }
    )*};
}
operators!(Add add Sub sub Mul mul Div div);

impl Neg for Lanes {
    type Output = Lanes;
    #[inline(always)]
    fn neg(self) -> Lanes {
        Lanes(-self.0)
    }
}

impl AddAssign for Lanes {
    #[inline(always)]
    fn add_assign(&mut self, other: Lanes) {
        *self = *self + other;
    }
}

impl SubAssign for Lanes {
    #[inline(always)]
    fn sub_assign(&mut self, other: Lanes) {
        *self = *self - other;
    }
}

/// The sum of each of four: lane i is the sum of the i-th.
#[inline(always)]
pub(crate) fn row_sums(of: [Lanes; LANES]) -> Lanes {
    let [a, b, c, d] = transposed(of);
    (a + b) + (c + d)
}

/// The transpose.
#[inline(always)]
pub(crate) fn transposed(rows: [Lanes; LANES]) -> [Lanes; LANES] {
    let [a, b, c, d] = rows.map(|row| row.0.into());
    // a₀ b₀ a₁ b₁ and a₂ b₂ a₃ b₃; the same of c and d.
    let ([ab, ab_end], [cd, cd_end]) = (register::interleaved(a, b), register::interleaved(c, d));
    let ([first, second], [third, fourth]) =
        (register::halves(ab, cd), register::halves(ab_end, cd_end));
    [first, second, third, fourth].map(|row| Lanes(row.into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    const ODD: [f32; 7] = [1.5, -2.0, 0.0, -0.0, 3e38, f32::NAN, f32::INFINITY];

    #[test]
    fn each_lane_computes_what_one_number_does() {
        for a in ODD {
            for b in ODD {
                let (left, right) = (Lanes::new([a, 1.0, 7.0, a]), Lanes::new([b, 2.0, -3.0, b]));
                let four = [
                    left + right,
                    left - right,
                    left * right,
                    left / right,
                    left.fast_min(right),
                    left.fast_max(right),
                    left.sqrt(),
                    left.abs(),
                ];
                let scalar = [
                    a + b,
                    a - b,
                    a * b,
                    a / b,
                    a.fast_min(b),
                    a.fast_max(b),
                    a.sqrt(),
                    a.abs(),
                ];
                for (four, scalar) in four.into_iter().zip(scalar) {
                    let same =
                        |x: f32| x.to_bits() == scalar.to_bits() || x.is_nan() && scalar.is_nan();
                    assert!(same(four.to_array()[0]) && same(four.to_array()[3]));
                }
                let less = left.less_mask(Lanes::new([b, 0.0, 8.0, a]));
                assert_eq!(less, u32::from(a < b) + 4, "{a} {b}");
            }
        }
    }

    #[test]
    fn integers_are_the_nearest() {
        let numbers = Lanes::new([0.0, 0.49, 6.51, 8_388_607.0]);
        assert_eq!(numbers.nearest_integers(), [0, 0, 7, 8_388_607]);
    }

    #[test]
    fn sums_are_those_of_the_rows() {
        let rows = [0, 1, 2, 3].map(|i| Lanes::splat(2.0) * Lanes::new([1.0, 2.0, 3.0, i as f32]));
        assert_eq!(row_sums(rows), Lanes::new([12.0, 14.0, 16.0, 18.0]));
        assert_eq!(transposed(transposed(rows)), rows);
    }
}
