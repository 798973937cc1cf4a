//! The number of particles by the size of an element.

use hearth_core::resolution::Level;
use hearth_core::resolution::SizeLimit;

fn at(side: f64, level: Level) -> u32 {
    SizeLimit::of(side).of_level(level)
}

#[test]
fn an_icon_has_300_a_card_about_400_and_a_large_element_all_particles() {
    for level in Level::ALL {
        assert_eq!(at(64.0, level), 300);
        assert_eq!(at(16.0, level), 300);
        // 240 × 300.
        assert!((380..=600).contains(&at(72_000_f64.sqrt(), level)));
        for side in [560.0, 600.0, 4000.0] {
            assert_eq!(at(side, level), level.particles());
        }
        // Without a size, before the first layout or while hidden.
        assert_eq!(at(0.0, level), level.particles());
        assert_eq!(SizeLimit::default().of_level(level), level.particles());
    }
}

#[test]
fn the_number_grows_with_size_and_level() {
    let mut before = [0; 3];
    for side in 1..1000 {
        let now = Level::ALL.map(|level| at(side.into(), level));
        assert!(now.iter().zip(before).all(|(now, before)| *now >= before));
        assert!(now[0] <= now[1] && now[1] <= now[2], "{now:?} at {side}");
        before = now;
    }
}

#[test]
fn small_changes_of_size_do_not_change_the_number() {
    for start in [64.0, 90.0, 200.0, 268.0, 300.0, 500.0, 559.0, 800.0] {
        let mut limit = SizeLimit::of(start);
        for side in [1.04, 0.96, 1.08, 1.0, 0.93, 1.0] {
            let before = limit;
            let matters = limit.resize(side * start);
            // Only the ends are followed exactly.
            assert!(!matters || [64.0, 560.0].contains(&(side * start).clamp(64.0, 560.0)));
            assert_eq!(matters, limit != before);
        }
        let settled = limit;
        for side in [1.02, 0.99, 1.0] {
            limit.resize(side * start);
        }
        assert_eq!(limit, settled);
    }
}

#[test]
fn a_growing_element_reaches_all_particles_in_few_changes() {
    let mut limit = SizeLimit::of(240.0);
    let changes = (240..1000)
        .filter(|&side| limit.resize(side.into()))
        .count();
    assert_eq!(limit.of_level(Level::High), Level::High.particles());
    assert!((2..=12).contains(&changes), "{changes}");
    assert!(!limit.resize(0.0), "a hidden element keeps its particles");
    assert!(limit.resize(64.0));
    assert_eq!(limit.of_level(Level::High), 300);
}

#[test]
fn a_scene_has_its_own_number_except_in_small_elements() {
    for number in [2000, 4000] {
        for side in [320.0, 426.0, 2000.0] {
            assert_eq!(SizeLimit::of(side).of_scene(number), number);
        }
        assert_eq!(SizeLimit::of(64.0).of_scene(number), 300);
        assert!(SizeLimit::of(72_000_f64.sqrt()).of_scene(number) <= 700);
    }
    assert_eq!(SizeLimit::of(100.0).of_scene(250), 250);
}
