//! Laws of the open air: gas in a band around a fire, without a box.

mod views;

use hearth_core::params::Input;
use hearth_core::{Particle, Scene, Simulation, Vec2};
use hearth_tests::fires::{self, on_floor};

/// A fire in the open with these numbers changed: coarse, which is quick.
fn open(values: &[(&str, f64)]) -> Scene {
    let mut scene = fires::in_the_open(fires::combustion(&[]), 3000);
    for &(id, value) in values {
        assert_eq!(scene.set(id, value), Ok(()));
    }
    scene
}

fn burn(scene: Scene, seconds: f64) -> Simulation {
    let mut fire = Simulation::new(scene);
    burn_on(&mut fire, seconds);
    fire
}

/// Burns on; the mean power [kW/m].
fn burn_on(fire: &mut Simulation, seconds: f64) -> f64 {
    let (start, mut heat) = (fire.time(), 0.0);
    while fire.time() < start + seconds {
        fire.step();
        assert_eq!(fire.report().clamped, 0, "at {} s", fire.time());
        heat += f64::from(fire.power().unwrap_or_default()) * fire.step_length();
    }
    heat / (fire.time() - start)
}

/// Root mean square speed relative to a wind [m/s].
fn restlessness(fire: &Simulation, wind: f32) -> f32 {
    let velocities = fire.velocities();
    let squares = velocities
        .iter()
        .map(|v| (*v - Vec2::new(wind, 0.0)).length_squared());
    (squares.sum::<f32>() / velocities.len() as f32).sqrt()
}

#[test]
fn still_air_stays_still() {
    for width in [0.1, 1.0] {
        let unlit = open(&[
            ("fuel_power", 0.0),
            ("source_width", width),
            ("source_temperature", 500.0),
            ("ember_rate", 0.0),
        ]);
        for parameters in [unlit.clone(), on_floor(unlit)] {
            let mut fire = burn(parameters, 1.0);
            burn_on(&mut fire, 1.0);
            assert!(fire.count() > 50, "{}", fire.count());
            let rms = restlessness(&fire, 0.0);
            assert!(rms < 0.01, "{rms} m/s");
        }
    }
}

#[test]
fn the_number_of_particles_follows_the_fire() {
    let mut fire = burn(open(&[]), 0.0);
    let unlit = fire.count();
    burn_on(&mut fire, 2.0);
    let lit = fire.count();
    assert!(lit > 2 * unlit, "{unlit} unlit, {lit} lit");
    assert_eq!(fire.set("fuel_power", Input::Number(0.0)), Ok(()));
    burn_on(&mut fire, 6.0);
    assert!(
        fire.count() < lit / 2,
        "{lit} lit, {} afterwards",
        fire.count()
    );
}

#[test]
fn the_fire_delivers_its_power_in_the_air_and_on_a_floor() {
    for (parameters, height) in [
        (open(&[]), 0.3),
        (on_floor(open(&[("source_height", 0.0)])), 0.0),
    ] {
        let mut fire = burn(parameters, 1.5);
        let power = burn_on(&mut fire, 2.0);
        assert!(
            (power / 220.0 - 1.0).abs() < 0.1,
            "{power} kW/m at {height} m"
        );
    }
}

#[test]
fn gas_stays_in_the_extent_and_above_a_floor() {
    for floor in [false, true] {
        let values = open(&[("source_height", 0.0), ("wind", 1.0)]);
        let parameters = if floor { on_floor(values) } else { values };
        let mut fire = Simulation::new(parameters);
        let [low, high] = fire.extent();
        assert!((low.y == 0.0) == floor && low.y <= 0.0);
        assert!(high.y > fire.parameters().domain_height);
        while fire.time() < 1.5 {
            fire.step();
            let spacing = Vec2::splat(fire.parameters().spacing());
            let inside = |at: Vec2| {
                let [low, high] = [low - spacing, high + spacing];
                at.cmpge(low).all() && at.cmple(high).all() && (!floor || at.y > 0.0)
            };
            assert!(fire.positions().into_iter().all(inside));
        }
    }
}

#[test]
fn an_id_stays_with_its_particle_and_none_is_used_twice() {
    let mut fire = burn(open(&[]), 0.5);
    let mut newest = 0;
    for _ in 0..200 {
        let before: Vec<_> = fire.ids().into_iter().zip(fire.positions()).collect();
        let most = before.iter().map(|particle| particle.0).max().unwrap_or(0);
        newest = newest.max(most);
        fire.step();
        let after: Vec<_> = fire.ids().into_iter().zip(fire.positions()).collect();
        assert!(after.is_sorted_by(|a, b| a.0 < b.0));
        for (id, position) in after {
            match before.binary_search_by_key(&id, |particle| particle.0) {
                Ok(at) => assert!(before[at].1.distance(position) < 0.05, "{id}"),
                Err(_) => assert!(id > newest, "{id} is not new"),
            }
        }
    }
}

#[test]
fn there_are_never_more_particles_than_allowed_and_the_report_has_the_sleeping_share() {
    let mut fire = Simulation::new(open(&[("max_particles", 500.0)]));
    while fire.time() < 2.0 {
        fire.step();
        assert!(fire.count() <= 500);
    }
    let asleep = fire.report().asleep;
    assert!(asleep > Some(0.1), "{asleep:?}");
    let highest = |fire: &Simulation| {
        let heights = fire.positions().into_iter().map(|at| at.y);
        heights.fold(0.0, f32::max)
    };
    let cut = highest(&fire);
    assert_eq!(fire.set("max_particles", Input::Number(3000.0)), Ok(()));
    while fire.time() < 4.0 {
        fire.step();
    }
    assert_eq!(fire.report().asleep, Some(0.0));
    assert!(highest(&fire) > cut + 0.3, "{cut} and {}", highest(&fire));
}

#[test]
fn particles_that_are_put_in_burn_on() {
    let fire = burn(open(&[]), 1.5);
    let particles = fire.particles();
    let mut other = Simulation::new(open(&[]));
    assert_eq!(other.set_particles(&particles), Ok(()));
    assert_eq!(other.positions(), fire.positions());
    let power = burn_on(&mut other, 0.5);
    assert!((power / 220.0 - 1.0).abs() < 0.2, "{power} kW/m");
    let crowd = vec![Particle::at(Vec2::new(0.0, 0.5)); 3001];
    assert!(other.set_particles(&crowd).is_err());
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn a_fire_that_starts_again_is_as_calm_as_before() {
    for width in [1.0, 1.2, 1.3, 1.35, 1.4, 1.6, 2.0] {
        for floor in [false, true] {
            let values = open(&[("domain_width", width)]);
            let values = if floor { on_floor(values) } else { values };
            let mut fire = burn(values.clone(), 2.0);
            let bytes = fire.burning().unwrap_or_default();
            let [mut put_in, mut restored] = [(); 2].map(|()| Simulation::new(values.clone()));
            assert_eq!(put_in.set_particles(&fire.particles()), Ok(()));
            assert_eq!(restored.restore_burning(&bytes), Ok(()));
            let expected = fastest(&mut fire, 0.5);
            for fire in [&mut put_in, &mut restored] {
                let speed = fastest(fire, 0.5);
                // A pulse that focuses in the fire doubles the speed.
                assert!(
                    speed < 1.25 * expected,
                    "{speed} m/s for {expected} m/s in a frame {width} m wide"
                );
            }
        }
    }
}

/// Burns on; the largest speed [m/s].
fn fastest(fire: &mut Simulation, seconds: f64) -> f32 {
    let (until, mut speed) = (fire.time() + seconds, 0.0_f32);
    while fire.time() < until {
        fire.step();
        assert_eq!(fire.report().clamped, 0, "at {} s", fire.time());
        speed = speed.max(fire.report().max_speed);
    }
    speed
}

/// The largest distance of a place around the source to the nearest particle, in spacings.
fn largest_gap(fire: &Simulation) -> f32 {
    let (positions, spacing) = (fire.positions(), fire.parameters().spacing());
    let lowest = fire.extent()[0].y.max(-2.0 * spacing);
    let places = (0..400).map(|at| {
        let place = Vec2::new((at % 20) as f32 - 9.5, (at / 20) as f32);
        Vec2::new(0.0, lowest + 0.5 * spacing) + place * (0.5 * spacing)
    });
    let gap = |place: Vec2| {
        let squares = positions.iter().map(|at| at.distance_squared(place));
        squares.fold(f32::MAX, f32::min).sqrt()
    };
    places.map(gap).fold(0.0, f32::max) / spacing
}

#[test]
fn air_fills_what_another_floor_or_kernel_opens() {
    let mut fire = burn(open(&[("source_height", 0.0)]), 1.5);
    let changes = [
        ("floor", Input::Text("solid")),
        ("floor", Input::Text("none")),
        ("smoothing_ratio", Input::Number(2.0)),
        ("smoothing_ratio", Input::Number(1.3)),
    ];
    for (id, input) in changes {
        assert_eq!(fire.set(id, input), Ok(()));
        fire.step();
        // Hot gas takes twice the room of air.
        let gap = largest_gap(&fire);
        assert!(gap < 2.5, "{gap} spacings after another {id}");
        let power = burn_on(&mut fire, 0.5);
        assert!((power / 220.0 - 1.0).abs() < 0.25, "{power} kW/m");
    }
}

/// Heat in the gas above the air's, per metre [kJ/m].
fn heat(fire: &Simulation) -> f64 {
    let p = fire.parameters();
    let mass = f64::from(p.ambient_density) * f64::from(p.spacing()).powi(2);
    let excess = fire.temperatures().into_iter();
    mass * excess
        .map(|t| f64::from(t - p.ambient_temperature))
        .sum::<f64>()
}

#[test]
fn another_spacing_keeps_the_fire() {
    // Room for the particles of the finest spacing.
    let mut fire = burn(open(&[("max_particles", 8000.0)]), 1.5);
    let (mut before, count) = (heat(&fire), fire.count());
    for spacing in [0.028, 0.05, 0.04] {
        assert_eq!(fire.set("spacing", Input::Number(spacing)), Ok(()));
        let after = heat(&fire);
        assert!(
            (after / before - 1.0).abs() < 0.1,
            "{before} before, {after} at {spacing} m"
        );
        before = after;
    }
    let now = fire.count() as f64 / count as f64;
    assert!((now - 1.0).abs() < 0.2, "{now} times as many");
    let power = burn_on(&mut fire, 0.5);
    assert!((power / 220.0 - 1.0).abs() < 0.25, "{power} kW/m");
}

#[test]
fn another_frame_keeps_every_particle_in_it() {
    let mut fire = burn(open(&[]), 1.5);
    let before = fire.particles();
    assert_eq!(fire.set("domain_width", Input::Number(2.0)), Ok(()));
    assert_eq!(fire.particles(), before);
    let power = burn_on(&mut fire, 0.5);
    assert!((power / 220.0 - 1.0).abs() < 0.2, "{power} kW/m");
}

#[test]
fn the_air_follows_a_source_that_jumps() {
    let mut fire = burn(open(&[("domain_width", 3.0), ("source_x", -0.8)]), 1.0);
    assert_eq!(fire.set("source_x", Input::Number(0.8)), Ok(()));
    burn_on(&mut fire, 0.5);
    let power = burn_on(&mut fire, 1.0);
    assert!((power / 220.0 - 1.0).abs() < 0.15, "{power} kW/m");
}

#[test]
fn a_stored_fire_continues_at_any_spacing() {
    // Room for the particles of the finest spacing.
    let open = |spacing| open(&[("spacing", spacing), ("max_particles", 8000.0)]);
    let fire = burn(open(0.0268), 1.5);
    let bytes = fire.burning().unwrap_or_default();
    for spacing in [0.04, 0.03, 0.055] {
        let mut other = Simulation::new(open(spacing));
        assert_eq!(other.restore_burning(&bytes), Ok(()));
        let (before, after) = (heat(&fire), heat(&other));
        assert!(
            (after / before - 1.0).abs() < 0.1,
            "{before} before, {after} at {spacing} m"
        );
        let power = burn_on(&mut other, 0.5);
        assert!((power / 220.0 - 1.0).abs() < 0.25, "{power} kW/m");
    }
    let mut closed = Simulation::new(fires::combustion(&[]));
    assert!(closed.restore_burning(&bytes).is_err());
}

#[test]
fn edges_open_and_close_while_it_burns() {
    let mut fire = burn(open(&[]), 1.0);
    for edges in ["periodic", "open"] {
        assert_eq!(fire.set("edges", Input::Text(edges)), Ok(()));
        assert!(
            fire.temperatures()
                .into_iter()
                .any(|kelvin| kelvin > 1000.0)
        );
        while fire.time() < 2.0 {
            fire.step();
        }
        assert!(fire.positions().iter().all(|at| at.is_finite()));
    }
}

#[test]
fn the_wind_blows_through_the_air_as_fast_as_it_is_set() {
    for wind in [-0.5_f32, 0.5, 1.0, -2.0, 3.0] {
        let mut fire = burn(
            open(&[
                ("fuel_power", 0.0),
                ("source_width", 1.0),
                ("domain_width", 2.0),
                ("source_temperature", 500.0),
                ("ember_rate", 0.0),
                ("wind", wind.into()),
            ]),
            2.0,
        );
        let (mut sum, mut count) = (0.0, 0.0);
        while fire.time() < 10.0 {
            fire.step();
            for velocity in fire.velocities() {
                sum += f64::from(velocity.x);
                count += 1.0;
            }
        }
        let share = sum / count / f64::from(wind);
        assert!((share - 1.0).abs() < 0.05, "{share} of {wind} m/s");
    }
}
