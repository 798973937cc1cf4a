//! The rim: gas near the outside, whose pressure and motion are those of the far air.
//!
//! ```text
//! live = clamp((depth − 0.75)/0.75, 0, 1)     w = smoothstep(1.5, 2.5, depth)
//! p = w c₀² (Y − ρ₀)                          v += (1 − live) min(1, 100 Δt) (v_flow − v)
//! ```
//!
//! In the ring, p = 0 makes the cut-off kernels harmless: their forces vanish, and the noise of
//! births and deaths makes pressure only where w is small. Forces are not damped: suction must
//! act wherever the pressure has a gradient.

use glam::Vec2;

use super::super::gas::Gas;
use super::map::Map;
use crate::extremes::fast_min;
use crate::lanes::{LANES, Lanes, Real};

/// Depths between which the motion becomes that of the gas.
const MOTION_DEPTHS: (f32, f32) = (0.75, 1.5);
/// Depths between which the pressure becomes that of the gas.
const PRESSURE_DEPTHS: (f32, f32) = (1.5, 2.5);
/// Rate at which the ring relaxes to the velocity at the rim [1/s].
const RELAXATION_RATE: f32 = 100.0;

/// A particle near the outside.
#[derive(Clone, Copy, Debug)]
struct Near {
    index: u32,
    cell: u32,
    /// The share of its pressure that acts.
    weight: f32,
    /// 1 where it moves by the forces, 0 where with the flow at the rim.
    live: f32,
}

/// The particles near the outside, in the order of the gas.
#[derive(Clone, Debug, Default)]
pub(super) struct Rim {
    near: Vec<Near>,
}

crate::state! { Rim:; near }

impl Rim {
    pub fn new(capacity: usize) -> Rim {
        Rim {
            near: Vec::with_capacity(capacity),
        }
    }

    /// Finds the particles near the outside. The order of the gas must not change until they
    /// are used.
    pub fn find(&mut self, map: &Map, gas: &Gas) {
        self.near.clear();
        let (fours, rest) = gas.position.as_chunks::<LANES>();
        for (four, positions) in fours.iter().enumerate() {
            self.find_four(map, four * LANES, *positions, LANES);
        }
        let mut last = [Vec2::ZERO; LANES];
        last[..rest.len()].copy_from_slice(rest);
        self.find_four(map, LANES * fours.len(), last, rest.len());
    }

    /// Finds the first `count` of four particles from an index.
    #[inline(always)]
    fn find_four(&mut self, map: &Map, first: usize, positions: [Vec2; LANES], count: usize) {
        let (depth, cells) = map.depths_at(positions);
        let weight = share(depth, PRESSURE_DEPTHS);
        let weight = (weight * weight * (Lanes::splat(3.0) - weight - weight)).to_array();
        let live = share(depth, MOTION_DEPTHS).to_array();
        let near = depth.less_mask(Lanes::splat(PRESSURE_DEPTHS.1));
        for lane in 0..count {
            if near & (1 << lane) != 0 {
                self.near.push(Near {
                    index: (first + lane) as u32,
                    cell: cells[lane],
                    weight: weight[lane],
                    live: live[lane],
                });
            }
        }
    }

    /// Weakens the pressure towards the outside.
    pub fn taper_pressure(&self, gas: &mut Gas) {
        for near in &self.near {
            gas.pressure[near.index as usize] *= near.weight;
        }
    }

    /// Completes the volumes of gas near the outside, where the kernels are cut off, with the
    /// number density `far` away \[kg/m³\]. Readers see no edge, and no force uses them.
    pub fn complete_volumes(&self, gas: &mut Gas, far: f32) {
        for near in &self.near {
            let (i, weight) = (near.index as usize, near.weight);
            gas.volume[i] *= weight + (1.0 - weight) * gas.number_density[i] / far;
        }
    }

    /// Removes the outward part of the shifts: there are no particles outside, which shifting
    /// would take for a gap.
    pub fn remove_outward_shift(&self, map: &Map, gas: &mut Gas) {
        for near in &self.near {
            let outward = map.cells[near.cell as usize].outward;
            // A shift goes down the gradient.
            let gradient = &mut gas.concentration_gradient[near.index as usize];
            let inward = fast_min(gradient.dot(outward), 0.0);
            *gradient -= outward * (inward * (1.0 - near.weight));
        }
    }

    /// Relaxes the velocity of the ring towards the flow at the rim for `dt`.
    pub fn relax_velocity(&self, map: &Map, gas: &mut Gas, dt: f32) {
        let relaxation = fast_min(RELAXATION_RATE * dt, 1.0);
        for near in &self.near {
            let cell = near.cell as usize;
            // Gas that has just left has no flow, and the next exchange removes it.
            if near.live < 1.0 && map.depth[cell] > 0.0 {
                let velocity = &mut gas.velocity[near.index as usize];
                *velocity += (map.cells[cell].flow - *velocity) * ((1.0 - near.live) * relaxation);
            }
        }
    }
}

/// How far `depth` is between two depths, from 0 to 1.
#[inline(always)]
pub(super) fn share<R: Real>(depth: R, (from, to): (f32, f32)) -> R {
    let share = (depth - R::splat(from)) * R::splat(1.0 / (to - from));
    share.fast_max(R::splat(0.0)).fast_min(R::splat(1.0))
}
