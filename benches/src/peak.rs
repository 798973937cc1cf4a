//! Peak floating-point rate of the machine: independent chains of multiplications and additions
//! on four numbers at once.
//!
//! The share of the peak that a step reaches is comparable between machines; milliseconds are
//! not.

use std::hint::black_box;

use glam::Vec4;
use wasm_bindgen::prelude::*;

/// Number of independent chains: enough to hide the latency of an operation, and few enough for
/// the sixteen registers of SSE.
const CHAINS: usize = 12;

/// Links of each chain in one round.
const LINKS: usize = 4;

/// Operations in a round: a multiplication and an addition a link, each of four
/// numbers.
#[wasm_bindgen(js_name = operationsARound)]
pub fn operations_a_round() -> u32 {
    (CHAINS * LINKS * 2 * 4) as u32
}

/// Computes a number of rounds. The result prevents dead-code elimination.
#[wasm_bindgen]
#[inline(never)]
pub fn compute(rounds: u32) -> f32 {
    // A chain that converges to one, without overflow and slow denormal numbers.
    let factor = Vec4::splat(black_box(0.75));
    let term = Vec4::splat(black_box(0.25));
    let mut chains = [Vec4::ZERO; CHAINS];
    for _ in 0..rounds {
        for _ in 0..LINKS {
            for chain in &mut chains {
                *chain = *chain * factor + term;
            }
        }
    }
    chains.iter().map(|chain| chain.element_sum()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chains_converge() {
        let all = (CHAINS * 4) as f32;
        assert_eq!(compute(0), 0.0);
        assert!(compute(1) > 0.5 * all);
        assert!((compute(100) / all - 1.0).abs() < 1e-5);
    }
}
