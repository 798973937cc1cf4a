//! A fire burns where its source stands, as it would in the middle, and goes with it
//! without a burst or a hole.

use hearth_core::params::Input;
use hearth_core::{Scene, Simulation, SourcePlace, Vec2};
use hearth_tests::fires::{burn, burn_on, combustion, mean, source, watch, with_numbers};

/// Mean power, number of particles and place across of what burns over so many seconds.
fn means(fire: &mut Simulation, seconds: f64) -> (f64, f64, f64) {
    let (mut heat, mut length, mut alive, mut across) = (0.0, 0.0, 0.0, 0.0);
    watch(fire, seconds, |fire| {
        let dt = fire.step_length();
        heat += f64::from(fire.power().unwrap_or_default()) * dt;
        alive += fire.count() as f64 * dt;
        across += middle(fire) * dt;
        length += dt;
    });
    (heat / length, alive / length, across / length)
}

/// Mean place across of what burns \[m\].
fn middle(fire: &Simulation) -> f64 {
    let hot = fire.positions().into_iter().zip(fire.temperatures());
    mean(
        hot.filter(|(_, kelvin)| *kelvin > 900.0)
            .map(|(at, _)| at.x),
    )
}

fn put(fire: &mut Simulation, x: f64) {
    assert_eq!(fire.set("source_x", Input::Number(x)), Ok(()));
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn a_fire_has_the_same_power_at_any_position() {
    let power = |x: f64| {
        let mut fire = burn(combustion(&[("source_x", x)]), 1.0);
        // The flame sways: a moment is further away than its limit.
        let (power, _, across) = means(&mut fire, 3.0);
        let off = across - x;
        assert!(off.abs() < 0.08, "{off} m off at {x} m");
        power
    };
    let there = power(0.0);
    for x in [-0.3, 0.15] {
        let here = power(x);
        assert!(
            (here / there - 1.0).abs() < 0.05,
            "{here}, {there} kW/m at {x} m"
        );
    }

    let alive = |x: f64| {
        let mut fire = burn(with_numbers(&[("source_x", x)]), 2.0);
        let (_, alive, across) = means(&mut fire, 2.0);
        let off = across - x;
        assert!(off.abs() < 0.05, "{off} m off at {x} m");
        alive
    };
    let there = alive(0.0);
    for x in [-0.3, 0.15] {
        let here = alive(x);
        assert!(
            (here / there - 1.0).abs() < 0.05,
            "{here}, {there} alive at {x} m"
        );
    }
}

#[test]
fn a_fire_continues_smoothly_when_its_source_moves() {
    // From side to side at once is the hardest.
    let mut fire = burn(combustion(&[("source_x", -0.25)]), 2.0);
    let (before, _, _) = means(&mut fire, 1.0);
    let fastest = fire.report().max_speed;
    put(&mut fire, 0.25);
    for _ in 0..10 {
        let (power, _, _) = means(&mut fire, 0.1);
        assert!(
            (0.6..1.4).contains(&(power / before)),
            "{power} after {before} kW/m"
        );
        let now = fire.report().max_speed;
        assert!(now < 2.0 * fastest, "{now} after {fastest} m/s");
    }
    assert!((middle(&fire) - 0.25).abs() < 0.1, "{}", middle(&fire));

    let mut fire = burn(with_numbers(&[("source_x", -0.25)]), 2.0);
    let (_, before, _) = means(&mut fire, 1.0);
    put(&mut fire, 0.25);
    for _ in 0..10 {
        let (_, alive, _) = means(&mut fire, 0.15);
        assert!(
            (0.75..1.25).contains(&(alive / before)),
            "{alive} after {before}"
        );
    }
    assert!((middle(&fire) - 0.25).abs() < 0.05, "{}", middle(&fire));
}

#[test]
fn a_source_beyond_the_side_burns_at_the_side() {
    for parameters in [
        combustion(&[("source_x", 3.0)]),
        with_numbers(&[("source_x", 3.0)]),
    ] {
        let source = SourcePlace::of(&source(&parameters)).base.x;
        assert!(source > 0.2 && source < 0.5 * parameters.world().domain_width);
        let mut fire = burn(parameters, 1.0);
        burn_on(&mut fire, 0.5);
        assert!(fire.temperatures().iter().any(|&kelvin| kelvin > 900.0));
    }
}

#[test]
fn a_turned_source_emits_at_right_angles_to_its_width() {
    for (model, angle) in [("classic", -90.0), ("classic", 45.0), ("combustion", -90.0)] {
        let mut settings = Scene::default();
        let values = [
            ("model", Input::Text(model)),
            ("source_angle", Input::Number(angle)),
            ("source_height", Input::Number(0.7)),
            ("emission_speed", Input::Number(1.5)),
            ("buoyancy", Input::Number(0.0)),
        ];
        for (id, value) in values {
            assert_eq!(settings.set(id, value), Ok(()));
        }
        let out = Vec2::from_angle((angle as f32).to_radians()).perp();
        let mut fire = Simulation::new(settings);
        let mut sum = Vec2::ZERO;
        while fire.time() < 0.5 {
            fire.step();
            let all = fire.velocities().into_iter().zip(fire.temperatures());
            sum += all
                .filter(|particle| particle.1 > 600.0)
                .map(|particle| particle.0)
                .sum::<Vec2>();
        }
        let direction = sum.normalize();
        assert!(direction.dot(out) > 0.9, "{model}, {angle}°: {direction}");
    }
}

#[test]
fn classic_sources_share_the_places_of_a_fire_that_is_full() {
    let mut scene = with_numbers(&[
        ("max_particles", 300.0),
        ("source_width", 0.2),
        ("source_x", -0.4),
    ]);
    for x in [0.0, 0.4] {
        let added = scene.add(&[
            ("kind", Input::Text("source")),
            ("width", Input::Number(0.2)),
            ("x", Input::Number(x)),
        ]);
        assert!(added.is_ok(), "{added:?}");
    }
    let mut fire = Simulation::new(scene);
    burn_on(&mut fire, 3.0);
    let mut born = [0; 3];
    let dt = fire.parameters().time_step;
    for _ in 0..480 {
        fire.step();
        for particle in fire
            .particles()
            .iter()
            .filter(|particle| particle.age < 1.5 * dt)
        {
            born[((particle.position.x + 0.6) / 0.4) as usize] += 1;
        }
    }
    let [least, most] = [born.iter().min(), born.iter().max()];
    assert!(fire.count() >= 290, "{} particles", fire.count());
    assert!(least > most.map(|most| most * 3 / 4).as_ref(), "{born:?}");
}
