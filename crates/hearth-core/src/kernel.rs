//! The cubic spline kernel in two dimensions.
//!
//! A particle spreads its mass over a disc of radius 2h. With q = r/h,
//!
//! ```text
//! W(r) = σ · { 1 − 3/2 q² + 3/4 q³     0 ≤ q < 1
//!            { 1/4 (2 − q)³            1 ≤ q < 2
//!            { 0                       2 ≤ q
//! ```
//!
//! The paper prints σ = 1/(πh³), which normalises the kernel in three
//! dimensions; in two it is σ = 10/(7πh²) (Monaghan, Rep. Prog. Phys. 68, 2005).

use std::f32::consts::PI;

use crate::extremes::fast_max;
use crate::lanes::{Lanes, Real};

/// The kernel as one expression without a branch, of the distance in smoothing lengths:
/// W = σ/4 · w.
#[inline(always)]
pub(crate) fn w<T: Real>(q: T) -> T {
    let (outer, inner) = tails(q);
    outer * outer * outer - square_of_double(inner) * inner
}

/// The derivative of the kernel: W' = −3σ/4h · minus_dw.
#[inline(always)]
pub(crate) fn minus_dw<T: Real>(q: T) -> T {
    let (outer, inner) = tails(q);
    outer * outer - square_of_double(inner)
}

/// The root of a squared distance. It is never quite zero, so that quotients stay finite; the
/// offset of coincident particles is zero, and so are their interactions.
#[inline(always)]
pub(crate) fn distance(square: Lanes) -> Lanes {
    square.fast_max(Lanes::splat(1e-12)).sqrt()
}

/// 2 − q and 1 − q, clamped to 0.
#[inline(always)]
fn tails<T: Real>(q: T) -> (T, T) {
    // max(2 − q, 0) compiles to one more wasm instruction.
    let (one, two) = (T::splat(1.0), T::splat(2.0));
    (two - q.fast_min(two), one - q.fast_min(one))
}

/// (2 x)², without a constant: in a pass, V8 makes each constant anew for every pair of blocks.
#[inline(always)]
fn square_of_double<T: Real>(x: T) -> T {
    let double = x + x;
    double * double
}

/// The kernel of one smoothing length.
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    h: f32,
    inverse_h: f32,
    norm: f32,
}

impl Kernel {
    /// The kernel of smoothing length `h` \[m\], normalised in two dimensions.
    pub fn new(h: f32) -> Kernel {
        Kernel {
            h,
            inverse_h: 1.0 / h,
            norm: 10.0 / (7.0 * PI * h * h),
        }
    }

    /// The kernel with the factor that the paper prints (equation 1).
    pub fn as_published(h: f32) -> Kernel {
        Kernel {
            norm: 1.0 / (PI * h * h * h),
            ..Kernel::new(h)
        }
    }

    /// Smoothing length h \[m\].
    pub fn smoothing_length(&self) -> f32 {
        self.h
    }

    /// Support radius, beyond which the kernel is zero \[m\].
    pub fn support(&self) -> f32 {
        2.0 * self.h
    }

    /// W at the distance `r` [1/m²].
    #[inline]
    pub fn value(&self, r: f32) -> f32 {
        0.25 * self.norm * w(r * self.inverse_h)
    }

    /// W'(r)/r [1/m⁴], never positive: ∇W at the offset **r** is this times **r**.
    #[inline]
    pub fn gradient_over_r(&self, r: f32) -> f32 {
        let q = r * self.inverse_h;
        // At q = 0 the offset and the force are zero, and any finite value is right.
        -self.minus_dw_norm() * minus_dw(q) / fast_max(q, 1e-6)
    }

    /// The factor that turns [`w`] into W [1/m²].
    pub(crate) fn w_norm(&self) -> f32 {
        0.25 * self.norm
    }

    /// The factor that turns [`minus_dw`] into −W'/h [1/m⁴], and `minus_dw(q)/q` into
    /// −W'/r.
    pub(crate) fn minus_dw_norm(&self) -> f32 {
        0.75 * self.norm * self.inverse_h * self.inverse_h
    }

    /// ∇²W at the distance `r` [1/m⁴], the kernel's own Laplacian in two
    /// dimensions, W'' + W'/r. It changes sign at q = 8/9, which is why
    /// viscosity built on it (the paper's equation 4) can add energy.
    pub fn laplacian(&self, r: f32) -> f32 {
        let q = r * self.inverse_h;
        let scaled = if q < 1.0 {
            -6.0 + 6.75 * q
        } else if q < 2.0 {
            (2.0 - q) * (2.25 - 1.5 / q)
        } else {
            0.0
        };
        self.norm * self.inverse_h * self.inverse_h * scaled
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫ f(r) 2πr dr over the support, in f64, by the midpoint rule.
    fn integrate(kernel: &Kernel, f: impl Fn(f32) -> f32) -> f64 {
        let cells = 200_000;
        let dr = f64::from(kernel.support()) / f64::from(cells);
        (0..cells)
            .map(|i| {
                let r = (f64::from(i) + 0.5) * dr;
                f64::from(f(r as f32)) * 2.0 * std::f64::consts::PI * r * dr
            })
            .sum()
    }

    #[test]
    fn its_integral_is_one_in_two_dimensions() {
        for h in [0.01, 0.035, 0.1, 1.0] {
            let kernel = Kernel::new(h);
            let volume = integrate(&kernel, |r| kernel.value(r));
            assert!((volume - 1.0).abs() < 1e-6, "h = {h}: {volume}");
        }
    }

    #[test]
    fn as_published_its_integral_is_wrong_by_the_dimension() {
        let kernel = Kernel::as_published(0.05);
        let volume = integrate(&kernel, |r| kernel.value(r));
        assert!((volume - 0.7 / 0.05).abs() < 1e-4, "{volume}");
    }

    #[test]
    fn its_gradient_is_the_slope_of_its_value() {
        let kernel = Kernel::new(1.0);
        for i in 1..220 {
            let r = i as f32 * 0.01;
            let d = 1e-3;
            let slope = (kernel.value(r + d) - kernel.value(r - d)) / (2.0 * d);
            let gradient = kernel.gradient_over_r(r) * r;
            assert!(
                (slope - gradient).abs() < 1e-3,
                "r = {r}: {slope}, {gradient}"
            );
        }
    }

    #[test]
    fn its_laplacian_is_the_divergence_of_its_gradient() {
        let kernel = Kernel::new(1.0);
        for i in 5..198 {
            let r = i as f32 * 0.01;
            let d = 1e-2;
            let flux = |r: f32| r * r * kernel.gradient_over_r(r);
            let divergence = (flux(r + d) - flux(r - d)) / (2.0 * d * r);
            let laplacian = kernel.laplacian(r);
            assert!(
                (divergence - laplacian).abs() < 2e-2,
                "r = {r}: {divergence}, {laplacian}"
            );
        }
    }

    #[test]
    fn its_laplacian_changes_sign_at_eight_ninths() {
        let kernel = Kernel::new(1.0);
        assert!(kernel.laplacian(0.88) < 0.0);
        assert!(kernel.laplacian(0.90) > 0.0);
    }

    #[test]
    fn its_support_is_twice_the_smoothing_length() {
        let kernel = Kernel::new(0.05);
        assert!(kernel.value(0.0999) > 0.0);
        assert_eq!(kernel.value(0.1), 0.0);
        assert_eq!(kernel.gradient_over_r(0.1), 0.0);
        assert_eq!(kernel.laplacian(0.1), 0.0);
    }

    #[test]
    fn a_lattice_has_the_right_density() {
        // h/dx from 1.3: the sum over a lattice is the density within 0.5 %.
        for ratio in [1.3_f32, 1.5, 2.0] {
            let dx = 0.02;
            let kernel = Kernel::new(ratio * dx);
            let mut sum = 0.0;
            for i in -5..=5 {
                for j in -5..=5 {
                    sum += dx * dx * kernel.value(dx * ((i * i + j * j) as f32).sqrt());
                }
            }
            assert!((sum - 1.0).abs() < 5e-3, "h/dx = {ratio}: {sum}");
        }
    }
}
