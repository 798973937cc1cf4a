//! Four numbers that are reckoned with at once.
//!
//! The one place that knows how a processor does that: SSE2 on x86-64, NEON on
//! 64-bit ARM, 128-bit SIMD in wasm, and one number after the other elsewhere.
//! Every operation is exact to the last bit as IEEE 754 says, fused
//! multiplication and approximate roots are not among them, and which operand a
//! comparison prefers is stated; so all of these give the same bits.
//!
//! `unsafe` stands here because the compiler asks for it where a function needs an
//! instruction set, though SSE2 and NEON are part of every x86-64 and 64-bit ARM.
//! No function here touches memory.
#![allow(unsafe_code)]

use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

use glam::Vec4;

use crate::extremes;

/// How many numbers there are.
pub(crate) const LANES: usize = 4;

#[cfg(target_arch = "x86_64")]
mod register {
    use std::arch::x86_64 as arch;

    pub type Register = arch::__m128;

    #[inline(always)]
    pub fn sqrt(a: Register) -> Register {
        // SAFETY: the instruction set is part of the target.
        unsafe { arch::_mm_sqrt_ps(a) }
    }
    #[inline(always)]
    pub fn fast_min(a: Register, b: Register) -> Register {
        // SAFETY: the instruction set is part of the target.
        unsafe { arch::_mm_min_ps(a, b) }
    }
    #[inline(always)]
    pub fn fast_max(a: Register, b: Register) -> Register {
        // SAFETY: the instruction set is part of the target.
        unsafe { arch::_mm_max_ps(a, b) }
    }
    #[inline(always)]
    pub fn less(a: Register, b: Register) -> u32 {
        // SAFETY: the instruction set is part of the target.
        unsafe { arch::_mm_movemask_ps(arch::_mm_cmplt_ps(a, b)) as u32 }
    }
    #[inline(always)]
    pub fn interleaved(a: Register, b: Register) -> [Register; 2] {
        // SAFETY: the instruction set is part of the target.
        unsafe { [arch::_mm_unpacklo_ps(a, b), arch::_mm_unpackhi_ps(a, b)] }
    }
    #[inline(always)]
    pub fn halves(a: Register, b: Register) -> [Register; 2] {
        // SAFETY: the instruction set is part of the target.
        unsafe { [arch::_mm_movelh_ps(a, b), arch::_mm_movehl_ps(b, a)] }
    }
}

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
mod register {
    use std::arch::wasm32 as arch;

    pub type Register = arch::v128;

    #[inline(always)]
    pub fn sqrt(a: Register) -> Register {
        arch::f32x4_sqrt(a)
    }
    // These two give their first operand unless the second is beyond it, SSE's
    // give the second unless the first is: so the operands change places.
    #[inline(always)]
    pub fn fast_min(a: Register, b: Register) -> Register {
        arch::f32x4_pmin(b, a)
    }
    #[inline(always)]
    pub fn fast_max(a: Register, b: Register) -> Register {
        arch::f32x4_pmax(b, a)
    }
    #[inline(always)]
    pub fn less(a: Register, b: Register) -> u32 {
        u32::from(arch::i32x4_bitmask(arch::f32x4_lt(a, b)))
    }
    #[inline(always)]
    pub fn interleaved(a: Register, b: Register) -> [Register; 2] {
        [
            arch::i32x4_shuffle::<0, 4, 1, 5>(a, b),
            arch::i32x4_shuffle::<2, 6, 3, 7>(a, b),
        ]
    }
    #[inline(always)]
    pub fn halves(a: Register, b: Register) -> [Register; 2] {
        [
            arch::i64x2_shuffle::<0, 2>(a, b),
            arch::i64x2_shuffle::<1, 3>(a, b),
        ]
    }
}

#[cfg(target_arch = "aarch64")]
mod register {
    use std::arch::aarch64 as arch;

    pub type Register = arch::float32x4_t;

    #[inline(always)]
    pub fn sqrt(a: Register) -> Register {
        // SAFETY: the instruction set is part of the target.
        unsafe { arch::vsqrtq_f32(a) }
    }
    #[inline(always)]
    pub fn fast_min(a: Register, b: Register) -> Register {
        // SAFETY: the instruction set is part of the target.
        unsafe { arch::vbslq_f32(arch::vcltq_f32(a, b), a, b) }
    }
    #[inline(always)]
    pub fn fast_max(a: Register, b: Register) -> Register {
        // SAFETY: the instruction set is part of the target.
        unsafe { arch::vbslq_f32(arch::vcgtq_f32(a, b), a, b) }
    }
    #[inline(always)]
    pub fn less(a: Register, b: Register) -> u32 {
        // SAFETY: the instruction set is part of the target; the array is as large
        // as what is read of it.
        unsafe {
            let bits = arch::vld1q_u32([1, 2, 4, 8].as_ptr());
            arch::vaddvq_u32(arch::vandq_u32(arch::vcltq_f32(a, b), bits))
        }
    }
    #[inline(always)]
    pub fn interleaved(a: Register, b: Register) -> [Register; 2] {
        // SAFETY: the instruction set is part of the target.
        unsafe { [arch::vzip1q_f32(a, b), arch::vzip2q_f32(a, b)] }
    }
    #[inline(always)]
    pub fn halves(a: Register, b: Register) -> [Register; 2] {
        // SAFETY: the instruction set is part of the target.
        unsafe {
            let (a, b) = (
                arch::vreinterpretq_f64_f32(a),
                arch::vreinterpretq_f64_f32(b),
            );
            [arch::vzip1q_f64(a, b), arch::vzip2q_f64(a, b)]
                .map(|half| arch::vreinterpretq_f32_f64(half))
        }
    }
}

#[cfg(not(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    all(target_arch = "wasm32", target_feature = "simd128")
)))]
mod register {
    use glam::Vec4;

    use crate::extremes;

    pub type Register = Vec4;

    fn each(a: Register, b: Register, f: impl Fn(f32, f32) -> f32) -> Register {
        Vec4::new(f(a.x, b.x), f(a.y, b.y), f(a.z, b.z), f(a.w, b.w))
    }
    pub fn sqrt(a: Register) -> Register {
        each(a, a, |a, _| a.sqrt())
    }
    pub fn fast_min(a: Register, b: Register) -> Register {
        each(a, b, extremes::fast_min)
    }
    pub fn fast_max(a: Register, b: Register) -> Register {
        each(a, b, extremes::fast_max)
    }
    pub fn less(a: Register, b: Register) -> u32 {
        a.cmplt(b).bitmask()
    }
    pub fn interleaved(a: Register, b: Register) -> [Register; 2] {
        [Vec4::new(a.x, b.x, a.y, b.y), Vec4::new(a.z, b.z, a.w, b.w)]
    }
    pub fn halves(a: Register, b: Register) -> [Register; 2] {
        [Vec4::new(a.x, a.y, b.x, b.y), Vec4::new(a.z, a.w, b.z, b.w)]
    }
}

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

    /// The number of one lane, in all of them.
    #[inline(always)]
    pub fn spread(self, lane: usize) -> Lanes {
        Lanes::splat(self.to_array()[lane])
    }

    /// The nearest whole numbers, of numbers from 0 to 2²³ that are less.
    #[inline(always)]
    pub fn nearest_whole(self) -> [u32; LANES] {
        // At 2²³ the last bit of a float is a whole one.
        const WHOLE: f32 = 8_388_608.0;
        let numbers = (self + WHOLE).to_array();
        numbers.map(|number| number.to_bits() & (WHOLE as u32 - 1))
    }

    /// The first so many; zero in the other lanes.
    #[inline]
    pub fn first(self, count: usize) -> Lanes {
        let numbers = self.to_array();
        Lanes::new([0, 1, 2, 3].map(|lane| if lane < count { numbers[lane] } else { 0.0 }))
    }

    /// The largest of the four.
    #[inline(always)]
    pub fn largest(self) -> f32 {
        let [a, b, c, d] = self.to_array();
        extremes::fast_max(extremes::fast_max(a, b), extremes::fast_max(c, d))
    }

    #[inline(always)]
    pub fn sqrt(self) -> Lanes {
        Lanes(register::sqrt(self.0.into()).into())
    }

    /// Which numbers are less than those of the same lane of `other`: a bit each,
    /// that of the first lane first.
    #[inline(always)]
    pub fn less(self, other: Lanes) -> u32 {
        register::less(self.0.into(), other.0.into())
    }
}

/// What both one number and four at once can do; a formula over it is written once.
pub(crate) trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// This number, as often as there are lanes.
    fn of(number: f32) -> Self;
    /// The smaller; `other` where they cannot be compared or are alike.
    fn fast_min(self, other: Self) -> Self;
    /// The larger; `other` where they cannot be compared or are alike.
    fn fast_max(self, other: Self) -> Self;
}

impl Real for f32 {
    #[inline(always)]
    fn of(number: f32) -> f32 {
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
    fn of(number: f32) -> Lanes {
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

/// The sums of four: lane i is that of the i-th.
#[inline(always)]
pub(crate) fn sums(of: [Lanes; LANES]) -> Lanes {
    let [a, b, c, d] = transposed(of);
    (a + b) + (c + d)
}

/// Rows as columns.
#[inline(always)]
pub(crate) fn transposed(rows: [Lanes; LANES]) -> [Lanes; LANES] {
    let [a, b, c, d] = rows.map(|row| row.0.into());
    // a₀ b₀ a₁ b₁, a₂ b₂ a₃ b₃; and so of c and d.
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
    fn each_lane_does_what_one_number_does() {
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
                ];
                let one = [
                    a + b,
                    a - b,
                    a * b,
                    a / b,
                    a.fast_min(b),
                    a.fast_max(b),
                    a.sqrt(),
                ];
                for (four, one) in four.into_iter().zip(one) {
                    let same = |x: f32| x.to_bits() == one.to_bits() || x.is_nan() && one.is_nan();
                    assert!(same(four.to_array()[0]) && same(four.to_array()[3]));
                }
                let less = left.less(Lanes::new([b, 0.0, 8.0, a]));
                assert_eq!(less, u32::from(a < b) + 4, "{a} {b}");
            }
        }
    }

    #[test]
    fn whole_numbers_are_the_nearest() {
        let numbers = Lanes::new([0.0, 0.49, 6.51, 8_388_607.0]);
        assert_eq!(numbers.nearest_whole(), [0, 0, 7, 8_388_607]);
    }

    #[test]
    fn sums_are_those_of_the_rows() {
        let rows = [0, 1, 2, 3].map(|i| Lanes::splat(2.0) * Lanes::new([1.0, 2.0, 3.0, i as f32]));
        assert_eq!(sums(rows), Lanes::new([12.0, 14.0, 16.0, 18.0]));
        assert_eq!(transposed(transposed(rows)), rows);
    }
}
