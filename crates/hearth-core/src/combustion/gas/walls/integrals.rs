//! Integrals of the kernel over a half space, by the distance from its plane.

use crate::extremes::fast_max;
use crate::kernel::Kernel;
use crate::lanes::Lanes;

/// Intervals of the tables, over distances of 0 to 2 smoothing lengths.
const INTERVALS: usize = 16;
/// Share of the kernel beyond a plane.
#[rustfmt::skip]
const GAMMA: [f32; INTERVALS + 1] = [
    0.5, 0.415348, 0.334237, 0.259741, 0.194203, 0.139095, 0.094968, 0.0614666, 0.0374416,
    0.0211944, 0.0109125, 0.00494094, 0.00185882, 0.000522305, 8.62669e-5, 3.8974e-6, 0.0,
];
/// W₁ h.
#[rustfmt::skip]
const SLOPE: [f32; INTERVALS + 1] = [
    0.682093, 0.667555, 0.626086, 0.562704, 0.483933, 0.397052, 0.309472, 0.228114, 0.158623,
    0.103778, 0.0629497, 0.0344969, 0.0163462, 0.00616586, 0.00153708, 0.000139756, 0.0,
];
/// K h².
#[rustfmt::skip]
const FRICTION: [f32; INTERVALS + 1] = [
    1.42857, 1.19476, 0.972719, 0.769194, 0.588562, 0.433613, 0.305807, 0.205329, 0.130929,
    0.0791149, 0.0446033, 0.0228398, 0.0101591, 0.00361149, 0.000851411, 7.34095e-5, 0.0,
];

/// All three side by side.
const TABLE: [Lanes; INTERVALS + 1] = {
    let mut table = [Lanes::ZERO; INTERVALS + 1];
    let mut at = 0;
    while at <= INTERVALS {
        table[at] = Lanes::new([GAMMA[at], SLOPE[at], FRICTION[at], 0.0]);
        at += 1;
    }
    table
};

/// Γ, W₁ [1/m] and K [1/m²] of the half space beyond a plane at this distance \[m\].
pub(super) fn beyond(distance: f32, kernel: &Kernel) -> [f32; 3] {
    let h = kernel.smoothing_length();
    let at = fast_max(distance, 0.0) * (INTERVALS as f32 / kernel.support());
    let interval = (at as u32).min(INTERVALS as u32 - 1) as usize;
    let part = at - interval as f32;
    let (before, after) = (TABLE[interval], TABLE[interval + 1]);
    let [gamma, slope, friction, _] = (before + (after - before) * part).to_array();
    [gamma, slope / h, friction / (h * h)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The integral of `f` of the distance, over the half space beyond `d`.
    fn integral(f: impl Fn(f64) -> f64, d: f64) -> f64 {
        const N: u32 = 400;
        let step = 2.0 / f64::from(N);
        let at = |i: u32| (f64::from(i) + 0.5) * step;
        let beyond = (0..N).map(at).map(|e| d + e);
        beyond
            .map(|e| {
                (0..N)
                    .map(|j| 2.0 * f(e.hypot(at(j))) * step * step)
                    .sum::<f64>()
            })
            .sum()
    }

    #[test]
    fn the_tables_are_the_integrals_of_the_kernel() {
        let kernel = Kernel::new(1.0);
        let w = |r: f64| f64::from(kernel.value(r as f32));
        let minus_dw_over_r = |r: f64| -f64::from(kernel.gradient_over_r(r as f32));
        for interval in [0, 2, 4, 7, 12, 16] {
            let d = 2.0 * interval as f64 / INTERVALS as f64;
            let gamma = integral(w, d);
            assert!(
                (gamma - f64::from(GAMMA[interval])).abs() < 2e-3,
                "Γ({d}) = {gamma}"
            );
            let slope = (integral(w, d) - integral(w, d + 1e-3)) / 1e-3;
            assert!(
                (slope - f64::from(SLOPE[interval])).abs() < 5e-3,
                "W₁({d}) = {slope}"
            );
            let friction = integral(minus_dw_over_r, d);
            assert!(
                (friction - f64::from(FRICTION[interval])).abs() < 1e-2,
                "K({d}) = {friction}"
            );
        }
    }
}
