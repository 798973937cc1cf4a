//! What is seen of open air.

use hearth_core::{Simulation, Vec2};
use hearth_tests::fires::on_floor;

use super::{burn, burn_on, open};

/// The part of the world that a picture of that width and height \[m\] shows.
fn seen(width: f32, height: f32) -> Option<[Vec2; 2]> {
    Some([Vec2::new(-0.5 * width, 0.0), Vec2::new(0.5 * width, height)])
}

#[test]
fn gas_reaches_beyond_what_is_seen_and_no_view_is_too_large() {
    let mut fire = Simulation::new(on_floor(open(&[("wind", 1.0)])));
    let (width, height) = (
        fire.parameters().domain_width,
        fire.parameters().domain_height,
    );
    let framed = fire.extent();
    fire.set_visible_area(seen(0.5 * width, 0.5 * height));
    assert_eq!(fire.extent(), framed);
    fire.set_visible_area(seen(4.0, 2.0));
    let [low, high] = fire.extent();
    assert!(low.x < -2.0 && high.x > 2.0 && high.y > 2.0 && low.y == 0.0);
    let before = fire.extent();
    fire.reset();
    assert_eq!(fire.extent(), before);
    for (width, height) in [(1e9, 1e9), (f32::NAN, 1.0), (f32::INFINITY, 0.1)] {
        fire.set_visible_area(seen(width, height));
        let [low, high] = fire.extent();
        let frame = fire.parameters().domain_height;
        assert!(high.x - low.x < 14.0 * frame && high.y - low.y < 8.0 * frame);
        fire.step();
    }
    fire.set_visible_area(None);
    assert_eq!(fire.extent(), framed);
}

/// Number of particles that every view of the tests shows.
fn in_the_middle(fire: &Simulation) -> usize {
    let shown = |at: &Vec2| at.x.abs() < 0.6 && at.y < 1.5;
    fire.positions().into_iter().filter(shown).count()
}

#[test]
fn a_change_of_what_is_seen_keeps_the_fire() {
    for floor in [false, true] {
        let values = open(&[("source_height", 0.2), ("wind", 0.5)]);
        let mut fire = burn(if floor { on_floor(values) } else { values }, 1.5);
        let power = burn_on(&mut fire, 1.5);
        let views = [(3.4, 1.4), (1.9, 2.6), (4.3, 1.8), (1.2, 1.5), (2.4, 1.5)];
        let mut count = in_the_middle(&fire);
        for at in 0..40 {
            let (width, height) = views[at % views.len()];
            let before = fire.particles();
            fire.set_visible_area(seen(width, height));
            assert_eq!(fire.particles(), before);
            for _ in 0..5 {
                fire.step();
                assert_eq!(fire.report().clamped, 0, "at {} s", fire.time());
                let speed = fire.report().max_speed;
                assert!(speed < 8.0, "{speed} m/s at {} s", fire.time());
            }
            let after = in_the_middle(&fire);
            let change = (after as f32 / count as f32 - 1.0).abs();
            assert!(change < 0.05, "from {count} to {after} particles");
            count = after;
        }
        let after = burn_on(&mut fire, 1.5);
        assert!((after / power - 1.0).abs() < 0.15, "{power}, {after} kW/m");
    }
}

#[test]
fn what_is_seen_beyond_all_gas_changes_nothing_and_costs_no_particles() {
    // The mean of four seeds: their ratios differ by a tenth.
    let count = |view| {
        let (mut sum, mut samples) = (0, 0);
        for seed in 1..=4 {
            let values = [("source_height", 0.0), ("seed", seed.into())];
            let mut fire = Simulation::new(on_floor(open(&values)));
            fire.set_visible_area(view);
            while fire.time() < 4.0 {
                fire.step();
                if fire.time() > 1.5 {
                    (sum, samples) = (sum + fire.count(), samples + 1);
                }
            }
        }
        sum as f64 / f64::from(samples)
    };
    let (narrow, wide) = (count(seen(2.0, 1.5)), count(seen(3.6, 1.5)));
    assert!(
        wide < 1.1 * narrow,
        "{wide} particles, {narrow} in a narrow view"
    );
}

#[test]
fn a_saved_fire_is_the_same_in_any_view() {
    let mut fire = burn(open(&[("wind", 1.0)]), 0.5);
    fire.set_visible_area(seen(5.0, 3.0));
    burn_on(&mut fire, 1.0);
    let bytes = fire.burning().unwrap_or_default();
    for view in [None, seen(5.0, 3.0)] {
        let mut other = Simulation::new(fire.scene().clone());
        other.set_visible_area(view);
        assert_eq!(other.restore_burning(&bytes), Ok(()));
        burn_on(&mut other, 0.05);
        let [low, high] = fire.extent();
        let inside = |at: Vec2| at.cmpge(low).all() && at.cmple(high).all();
        assert!(other.positions().into_iter().all(inside));
        let hottest = other.temperatures().into_iter().fold(0.0, f32::max);
        assert!(hottest > 1000.0, "{hottest} K");
    }
}
