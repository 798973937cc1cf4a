use super::*;
use crate::bounds::Bounds;

#[derive(Clone, Copy, Default)]
struct Four {
    place: [Lanes; 2],
    sum: Lanes,
}

impl Block for Four {
    fn place(&self) -> [Lanes; 2] {
        self.place
    }
    fn weight(&self) -> Lanes {
        Lanes::splat(1.0)
    }
    fn sum(&mut self) -> &mut Lanes {
        &mut self.sum
    }
}

#[test]
fn what_memory_cannot_hold_is_not_written_down() {
    let bounds = Bounds {
        width: 1.0,
        height: 1.0,
        periodic: false,
        endless: false,
    };
    // All in one place: each is the neighbour of each.
    let n = 12_000;
    let mut grid = Grid::default();
    grid.sort((0..n).map(|_| Vec2::new(0.0, 0.5)), &bounds, 0.04);
    let mut blocks = vec![Four::default(); grid.block_count()];
    let mut neighbours = Neighbours::default();
    neighbours.find(&mut blocks, &grid, 0.02);
    let stride = blocks.len() * LANES;
    assert!((MAX_ENTRIES - stride..=MAX_ENTRIES).contains(&neighbours.used));
    let (mean, max) = neighbours.mean_and_max();
    assert!(mean > 0.9 * 2.0 * MAX_ENTRIES as f32 * LANES as f32 / n as f32);
    assert_eq!(max as usize, n - 1);
    // Whoever is left out still meets those of its own block.
    let last = blocks[blocks.len() - 1].sum.to_array();
    assert!(last.iter().all(|sum| sum.is_finite() && *sum >= 16.0));
}
