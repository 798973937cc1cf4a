use super::*;

pub fn corner(layout: &Layout, cell: usize) -> Vec2 {
    layout.corner((cell % layout.columns, cell / layout.columns))
}

fn layout(floor: bool) -> Layout {
    Layout::new(0.8, 0.3, 1.7, 0.1, floor)
}

/// A map with gas in every cell whose centre is in the rectangle.
fn filled(floor: bool, from: Vec2, to: Vec2) -> Map {
    let mut map = Map::new(layout(floor));
    let half = Vec2::splat(0.05);
    for cell in map.layout.inner() {
        let at = corner(&map.layout, cell) + half;
        map.cells[cell].inside = at.cmpge(from).all() && at.cmple(to).all();
    }
    map.fill();
    map
}

#[test]
fn all_places_are_inside_and_the_floor_is_at_zero() {
    for floor in [false, true] {
        let bounds = layout(floor).bounds();
        assert!(bounds.width >= 1.8 - 1e-5 && bounds.width < 2.01);
        assert!((bounds.bottom - if floor { 0.0 } else { -0.4 }).abs() < 1e-5);
        assert!(bounds.bottom + bounds.height >= 1.7 - 1e-5);
    }
}

#[test]
fn a_position_is_in_its_cell_and_any_other_in_the_border() {
    let layout = layout(false);
    for cell in layout.inner() {
        assert_eq!(layout.at(corner(&layout, cell) + Vec2::splat(0.05)), cell);
    }
    let inner: Vec<usize> = layout.inner().collect();
    for at in [
        Vec2::new(-9.0, 0.5),
        Vec2::new(0.0, 9.0),
        Vec2::new(f32::NAN, 0.5),
        Vec2::new(0.0, f32::NEG_INFINITY),
    ] {
        assert!(!inner.contains(&layout.at(at)), "{at}");
    }
}

#[test]
fn common_cells_of_two_layouts_are_the_same_place() {
    for floor in [false, true] {
        let (small, large) = (layout(floor), Layout::new(2.0, 1.1, 1.75, 0.1, floor));
        for (map, other) in [(small, large), (large, small)] {
            let pairs: Vec<_> = map.common(&other).collect();
            assert_eq!(pairs.len(), small.inner().count());
            for (cell, same) in pairs {
                assert!(corner(&map, cell).distance(corner(&other, same)) < 1e-5);
            }
        }
    }
}

#[test]
fn the_depth_is_the_distance_to_the_outside() {
    let map = filled(false, Vec2::new(-0.7, 0.0), Vec2::new(0.7, 1.2));
    for cell in map.layout.inner() {
        let at = corner(&map.layout, cell) + Vec2::splat(0.05);
        let to_edge = (0.7 - at.x.abs()).min(at.y).min(1.2 - at.y);
        let expected = ((to_edge / 0.1).round() + 1.0).clamp(0.0, MAX_DEPTH);
        let depth = map.depth[cell];
        assert!((depth - expected).abs() <= 1.0, "{depth} at {at}");
        assert!((map.depth_at(at) - depth).abs() < 1e-4);
    }
}

#[test]
fn the_normal_points_outward_and_a_floor_is_no_outside() {
    let map = filled(true, Vec2::new(-0.6, 0.0), Vec2::new(0.6, 1.0));
    let at = |x, y| map.layout.at(Vec2::new(x, y));
    let outward = |x, y| map.cells[at(x, y)].outward;
    let left = outward(-0.55, 0.45);
    assert!(left.distance(Vec2::NEG_X) < 1e-4, "{left}");
    assert!(outward(0.0, 0.95).distance(Vec2::Y) < 1e-4);
    assert_eq!(map.depth[at(0.05, 0.05)], MAX_DEPTH);
    assert!(outward(-0.55, 0.05).distance(Vec2::NEG_X) < 1e-4);
}

#[test]
fn cells_that_gas_enters_are_fresh_once() {
    let mut map = filled(false, Vec2::new(-0.5, 0.0), Vec2::new(0.5, 1.0));
    let fresh = |map: &Map| map.cells.iter().filter(|cell| cell.fresh).count();
    assert_eq!(fresh(&map), 10 * 10);
    map.fill();
    assert_eq!(fresh(&map), 0);
}

#[test]
fn gas_occupies_the_cells_that_it_fills_and_thin_gas_has_no_holes() {
    let mut gas = Gas::default();
    for (x, volume) in [(-0.5, 0.0025), (0.5, 0.01)] {
        let side = f32::sqrt(volume);
        for index in 0..(0.36_f32 / volume).round() as u32 {
            let columns = (0.6 / side).round() as u32;
            let (column, row) = (index % columns, index / columns);
            let at = Vec2::new(column as f32, row as f32) + 0.5;
            let corner = Vec2::new(x - 0.3, 0.3);
            gas.insert_particle(&crate::Particle::at(corner + at * side), volume);
        }
    }
    // One cell of the thin gas has no particle.
    gas.retain(|at, _| at.distance(Vec2::new(0.55, 0.65)) > 0.01);
    let mut map = Map::new(layout(false));
    map.occupy(&gas);
    for cell in map.layout.inner() {
        let at = corner(&map.layout, cell) + Vec2::splat(0.05);
        let inside = (at.x.abs() - 0.5).abs() < 0.3 && (at.y - 0.6).abs() < 0.3;
        assert_eq!(map.depth[cell] > 0.0, inside, "{at}");
    }
}
