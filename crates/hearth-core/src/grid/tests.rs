use super::*;
use crate::random::Random;
use std::collections::BTreeSet;

fn cloud(n: usize, bounds: &Bounds, seed: u32) -> Vec<Vec2> {
    let mut random = Random::new(seed);
    let mut place = || {
        Vec2::new(
            random.between(-0.5 * bounds.width, 0.5 * bounds.width),
            random.between(0.0, bounds.height),
        )
    };
    (0..n).map(|_| place()).collect()
}

fn bounds_to_test() -> [(u32, Bounds); 8] {
    let bounds = |width, height, periodic_x, periodic_y| Bounds {
        bottom: 0.0,
        width,
        height,
        periodic_x,
        periodic_y,
    };
    [
        (1, bounds(1.2, 1.5, false, false)),
        (2, bounds(1.2, 1.5, true, false)),
        (3, bounds(0.1, 3.0, false, false)),
        (4, bounds(0.1, 3.0, true, true)),
        (5, bounds(0.5, 0.1, true, false)),
        (6, bounds(6.0, 0.15, false, true)),
        (7, bounds(1.2, 1.5, true, true)),
        (8, bounds(0.3, 0.25, true, true)),
    ]
}

/// Sorts `positions`.
fn sort(grid: &mut Grid, positions: &mut [Vec2], bounds: &Bounds, reach: f32) {
    let before = positions.to_vec();
    for (from, &to) in grid
        .sort(before.iter().copied(), bounds, reach)
        .iter()
        .enumerate()
    {
        positions[to as usize] = before[from];
    }
}

#[test]
fn it_finds_the_pairs_that_comparing_all_with_all_finds() {
    let mut grid = Grid::default();
    for (seed, bounds) in bounds_to_test() {
        let mut positions = cloud(403, &bounds, seed);
        for reach in [0.02, 0.07, 0.2] {
            // A support wider than half the period would contain two images of a particle.
            if bounds.periodic_y && reach > 0.5 * bounds.height
                || bounds.periodic_x && reach > 0.5 * bounds.width
            {
                continue;
            }
            sort(&mut grid, &mut positions, &bounds, reach);
            let close = |i: usize, j: usize| {
                bounds.offset(positions[i], positions[j]).length_squared() < reach * reach
            };
            let members: Vec<_> = grid.members().collect();
            let mut found = Vec::new();
            let mut visit = |i: usize, j: usize, shift: Vec2| {
                let offset = positions[i] - shift - positions[j];
                if offset.length_squared() < reach * reach {
                    found.push((i.min(j), i.max(j)));
                }
            };
            for row in 0..grid.rows() {
                for block in grid.blocks(row) {
                    let here = members[block].clone();
                    let across = here.clone().map(|i| positions[i].x);
                    let from = across.clone().fold(f32::INFINITY, f32::min);
                    let to = across.fold(f32::NEG_INFINITY, f32::max);
                    let mut runs = Default::default();
                    let count = grid.runs_after(row, block, (from, to), &mut runs);
                    for i in here.clone() {
                        (i + 1..here.end).for_each(|j| visit(i, j, Vec2::ZERO));
                        for run in &runs[..count] {
                            let there = (run.start..run.end).flat_map(|b| members[b].clone());
                            there.for_each(|j| visit(i, j, run.shift));
                        }
                    }
                }
            }
            let unique: BTreeSet<_> = found.iter().copied().collect();
            assert_eq!(unique.len(), found.len(), "a pair was visited twice");
            let all: BTreeSet<_> = (0..positions.len())
                .flat_map(|i| (i + 1..positions.len()).map(move |j| (i, j)))
                .filter(|&(i, j)| close(i, j))
                .collect();
            assert_eq!(unique, all, "seed {seed}, reach {reach}");
        }
    }
}

#[test]
fn every_particle_is_in_one_block_of_one_row() {
    let mut grid = Grid::default();
    for (seed, bounds) in bounds_to_test() {
        for n in [0, 1, 5, 403] {
            let mut positions = cloud(n, &bounds, seed);
            sort(&mut grid, &mut positions, &bounds, 0.05);
            let mut next = 0;
            for members in grid.members() {
                assert_eq!(next, members.start);
                assert!((1..=LANES).contains(&members.len()));
                let rows = members
                    .clone()
                    .map(|i| grid.indices([0.0; 3], positions[i].y).1);
                assert_eq!(BTreeSet::from_iter(rows).len(), 1);
                next = members.end;
            }
            assert_eq!(next, n);
        }
    }
}

#[test]
fn it_finds_every_particle_near_any_position() {
    let mut grid = Grid::default();
    for (seed, bounds) in bounds_to_test() {
        let (mut positions, reach) = (cloud(300, &bounds, seed), 0.05);
        sort(&mut grid, &mut positions, &bounds, reach);
        for place in cloud(100, &bounds, seed + 100) {
            let near = |&j: &usize| bounds.offset(place, positions[j]).length() < reach;
            let mut found = Vec::new();
            grid.candidates(place, &mut |run, shift| {
                let near = |&j: &usize| (place - shift).distance(positions[j]) < reach;
                found.extend(run.filter(near));
            });
            found.sort_unstable();
            let all: Vec<_> = (0..positions.len()).filter(near).collect();
            assert_eq!(found, all, "seed {seed}");
        }
    }
}

#[test]
fn sorting_is_a_permutation() {
    for (seed, bounds) in bounds_to_test() {
        let positions = cloud(1000, &bounds, seed);
        let mut grid = Grid::default();
        let mut order = grid.sort(positions.into_iter(), &bounds, 0.05).to_vec();
        order.sort_unstable();
        assert!(order.iter().enumerate().all(|(i, &at)| i == at as usize));
    }
}
