//! salva2d's DFSPH as a program of the benchmarks: `hearth-peers N STEPS`.
//!
//! Prints one line as benches/README.md describes it. A square of N particles
//! with 20 neighbours each, without gravity and without walls, on one thread,
//! with one iteration of its pressure solver and one of its divergence solver a
//! step: the least work that it can do.

use std::env;
use std::time::Instant;

use salva2d::LiquidWorld;
use salva2d::math::Vector;
use salva2d::object::interaction_groups::InteractionGroups;
use salva2d::object::{Fluid, FluidHandle};
use salva2d::solver::{ArtificialViscosity, DFSPHSolver};

/// Distance between particles [m].
const SPACING: f32 = 0.01;
/// Reach of the kernel in that distance: as many as 20 neighbours lie within.
const REACH: f32 = 2.585;
const TIME_STEP: f32 = 1.0 / 1000.0;
const WARM_UP: usize = 3;

fn main() -> Result<(), String> {
    let numbers: Vec<usize> = env::args().skip(1).filter_map(|n| n.parse().ok()).collect();
    let &[count, steps] = numbers.as_slice() else {
        return Err("usage: hearth-peers N STEPS".to_owned());
    };
    let steps = steps.max(1);
    let mut world = block(count);
    let mut milliseconds: Vec<f64> = (0..WARM_UP + steps)
        .map(|_| {
            let start = Instant::now();
            world.step(TIME_STEP, &Vector::zeros());
            start.elapsed().as_secs_f64() * 1e3
        })
        .skip(WARM_UP)
        .collect();
    milliseconds.sort_by(f64::total_cmp);
    // Its count of contacts has each pair twice, and each particle itself.
    let neighbours = world.counters.cd.ncontacts as f64 / count as f64 - 1.0;
    println!(
        "salva2d DFSPH 1+1,where=native,N={count},neigh={neighbours:.2},median_ms={:.4},min_ms={:.4}",
        milliseconds[steps / 2],
        milliseconds[0],
    );
    Ok(())
}

/// A square of `count` particles at rest, slightly off their lattice.
fn block(count: usize) -> LiquidWorld {
    let mut solver: DFSPHSolver = DFSPHSolver::new();
    (solver.min_pressure_iter, solver.max_pressure_iter) = (1, 1);
    (solver.min_divergence_iter, solver.max_divergence_iter) = (1, 1);
    let mut world = LiquidWorld::new(solver, 0.5 * SPACING, REACH, 1.0);
    world.counters.enable();
    let columns = (count as f32).sqrt().ceil() as usize;
    let places = (0..count)
        .map(|i| {
            let column = (i % columns) as f32 + 0.2 * scatter(i);
            let row = (i / columns) as f32 + 0.2 * scatter(i + count);
            Vector::new(column * SPACING, row * SPACING)
        })
        .collect();
    let mut fluid = Fluid::new(places, 0.5 * SPACING, 1.0, InteractionGroups::all());
    let viscosity = ArtificialViscosity::new(0.01, 0.0);
    fluid.nonpressure_forces.push(Box::new(viscosity));
    let _: FluidHandle = world.add_fluid(fluid);
    world
}

/// A number from −0.5 to 0.5 that looks like chance and is always the same.
fn scatter(i: usize) -> f32 {
    let mixed = (i as u32 ^ 0x51).wrapping_mul(0x9e37_79b9);
    ((mixed ^ (mixed >> 15)) >> 8) as f32 / 16_777_216.0 - 0.5
}
