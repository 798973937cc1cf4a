use super::*;
use crate::bounds::Bounds;

#[derive(Clone, Copy, Default)]
struct Four {
    position: [Lanes; 2],
    sum: Lanes,
}

impl Block for Four {
    fn position(&self) -> [Lanes; 2] {
        self.position
    }
    fn weight(&self) -> Lanes {
        Lanes::splat(1.0)
    }
    fn sum(&mut self) -> &mut Lanes {
        &mut self.sum
    }
}

#[test]
fn lists_stop_at_their_limit() {
    let bounds = Bounds {
        bottom: 0.0,
        width: 1.0,
        height: 1.0,
        periodic_x: false,
        periodic_y: false,
    };
    // All particles at one point: each is a neighbour of each other.
    let n = 12_000;
    let mut grid = Grid::default();
    grid.sort((0..n).map(|_| Vec2::new(0.0, 0.5)), &bounds, 0.04);
    let mut blocks = vec![Four::default(); grid.block_count()];
    let mut neighbours = Neighbours::default();
    neighbours.find_and_sum(&mut blocks, &grid, 0.02);
    let stride = blocks.len() * LANES;
    assert!((Four::MAX_ENTRIES - stride..=Four::MAX_ENTRIES).contains(&neighbours.candidates()));
    let (mean, max) = neighbours.mean_and_max(&blocks);
    assert!(mean > 0.9 * 2.0 * Four::MAX_ENTRIES as f32 * LANES as f32 / n as f32);
    assert_eq!(max as usize, n - 1);
    // Particles beyond the limit still interact within their block.
    let last = blocks[blocks.len() - 1].sum.to_array();
    assert!(last.iter().all(|sum| sum.is_finite() && *sum >= 16.0));
}
