//! Registers of four numbers, and the instructions on them, of each processor.
//!
//! `unsafe` marks functions that need an instruction set, although SSE2 and NEON are part
//! of every x86-64 and 64-bit ARM. No function here touches memory.
#![allow(unsafe_code)]

pub(super) use target::{fast_max, fast_min, halves, interleaved, less_mask, sqrt};

#[cfg(target_arch = "x86_64")]
mod target {
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
    pub fn less_mask(a: Register, b: Register) -> u32 {
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
mod target {
    use std::arch::wasm32 as arch;

    pub type Register = arch::v128;

    #[inline(always)]
    pub fn sqrt(a: Register) -> Register {
        arch::f32x4_sqrt(a)
    }
    // `pmin` and `pmax` return their first operand if the numbers are equal or NaN, SSE's
    // minimum and maximum the second: so the operands are swapped.
    #[inline(always)]
    pub fn fast_min(a: Register, b: Register) -> Register {
        arch::f32x4_pmin(b, a)
    }
    #[inline(always)]
    pub fn fast_max(a: Register, b: Register) -> Register {
        arch::f32x4_pmax(b, a)
    }
    #[inline(always)]
    pub fn less_mask(a: Register, b: Register) -> u32 {
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
mod target {
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
    pub fn less_mask(a: Register, b: Register) -> u32 {
        // SAFETY: the instruction set is part of the target; the load reads the whole array.
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
mod target {
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
    pub fn less_mask(a: Register, b: Register) -> u32 {
        a.cmplt(b).bitmask()
    }
    pub fn interleaved(a: Register, b: Register) -> [Register; 2] {
        [Vec4::new(a.x, b.x, a.y, b.y), Vec4::new(a.z, b.z, a.w, b.w)]
    }
    pub fn halves(a: Register, b: Register) -> [Register; 2] {
        [Vec4::new(a.x, a.y, b.x, b.y), Vec4::new(a.z, a.w, b.z, b.w)]
    }
}
