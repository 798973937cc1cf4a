//! What a user of the simulation relies on: walls, own
//! initial states, live parameters, refusals.

use hearth_core::params::{Input, Kind, PARAMETERS, Param, Refusal};
use hearth_core::{Parameters, Particle, Simulation, Vec2};
use hearth_tests::fires::with;

fn burn(fire: &mut Simulation, steps: u32) {
    (0..steps).for_each(|_| fire.step());
}

fn particle(x: f32, y: f32, vx: f32, vy: f32) -> Particle {
    Particle {
        position: Vec2::new(x, y),
        velocity: Vec2::new(vx, vy),
        temperature: 1000.0,
        age: 0.0,
        lifetime: 100.0,
    }
}

/// No source to speak of and no lift: what is put in moves by itself.
fn still(walls: &str) -> Parameters {
    with([
        ("walls", Input::Text(walls)),
        ("gravity", Input::Number(0.0)),
        ("emission_rate", Input::Number(50.0)),
        ("max_particles", Input::Number(100.0)),
    ])
}

#[test]
fn a_reset_fire_burns_the_same_again() {
    let mut fire = Simulation::new(Parameters::default());
    burn(&mut fire, 300);
    let first = fire.particles();
    fire.reset();
    assert_eq!((fire.count(), fire.time()), (0, 0.0));
    burn(&mut fire, 300);
    assert_eq!(fire.particles(), first);
}

#[test]
fn reading_does_not_disturb() {
    let mut read = Simulation::new(Parameters::default());
    let mut left = Simulation::new(Parameters::default());
    for _ in 0..300 {
        read.step();
        left.step();
        let _ = (read.positions(), read.densities(), read.report());
        read.write_instances(&mut Vec::new());
    }
    assert_eq!(read.particles(), left.particles());
}

#[test]
fn readers_keep_the_order_of_birth() {
    let mut fire = Simulation::new(Parameters::default());
    burn(&mut fire, 200);
    // Ages in the order of birth never rise: whoever is younger comes later,
    // but for those born within the same step.
    let step = fire.parameters().time_step;
    assert!(fire.ages().windows(2).all(|pair| pair[1] <= pair[0] + step));
}

#[test]
fn particles_that_are_put_in_come_out_again() {
    let mut fire = Simulation::new(still("open"));
    let given: Vec<Particle> = (0..50)
        .map(|i| particle(-0.5 + 0.02 * i as f32, 0.5, 0.0, 0.1))
        .collect();
    fire.set_particles(&given).expect("they are fine");
    assert_eq!(fire.particles(), given);
}

#[test]
fn bad_particles_are_refused_and_change_nothing() {
    let mut fire = Simulation::new(still("open"));
    let good = particle(0.0, 0.5, 0.0, 0.0);
    fire.set_particles(&[good]).expect("it is fine");
    for bad in [
        particle(f32::NAN, 0.5, 0.0, 0.0),
        particle(10.0, 0.5, 0.0, 0.0),
        particle(0.0, -0.1, 0.0, 0.0),
        particle(0.0, 0.5, f32::INFINITY, 0.0),
        Particle {
            temperature: 0.0,
            ..good
        },
        Particle {
            lifetime: 0.0,
            ..good
        },
        Particle {
            age: f32::NAN,
            ..good
        },
    ] {
        let error = fire.set_particles(&[good, bad]).expect_err("it is bad");
        assert_eq!(error.index, 1);
        assert!(error.to_string().contains("particle 1"), "{error}");
        assert_eq!(fire.particles(), [good]);
    }
}

/// Where a particle that flies at a side wall is afterwards, if anywhere.
fn flown_at_the_wall(walls: &str) -> Option<Particle> {
    let mut fire = Simulation::new(still(walls));
    let given = fire.set_particles(&[particle(0.5, 1.0, 2.0, 0.0)]);
    assert_eq!(given, Ok(()));
    burn(&mut fire, 48);
    let mut high = fire.particles();
    high.retain(|p| p.position.y > 0.9);
    high.first().copied()
}

#[test]
fn open_walls_let_out_solid_ones_stop_and_periodic_ones_turn_round() {
    assert_eq!(flown_at_the_wall("open"), None);

    let stopped = flown_at_the_wall("solid").expect("it stays");
    assert_eq!((stopped.position.x, stopped.velocity.x), (0.6, 0.0));

    // 0.5 + 2 · 0.2 − 1.2 = −0.3
    let round = flown_at_the_wall("periodic").expect("it stays");
    assert!((round.position.x + 0.3).abs() < 1e-3, "{round:?}");
    assert_eq!(round.velocity.x, 2.0);
}

#[test]
fn the_top_is_open_whatever_the_walls() {
    for walls in ["open", "solid", "periodic"] {
        let mut fire = Simulation::new(still(walls));
        fire.set_particles(&[particle(0.0, 1.4, 0.0, 2.0)])
            .expect("it is fine");
        burn(&mut fire, 48);
        assert!(fire.positions().iter().all(|p| p.y < 0.9), "{walls}");
    }
}

#[test]
fn periodic_neighbours_feel_each_other_across_the_edge() {
    let pair = [
        particle(0.595, 1.0, 0.0, 0.0),
        particle(-0.595, 1.0, 0.0, 0.0),
    ];
    let neighbours = |walls| {
        let mut fire = Simulation::new(still(walls));
        fire.set_particles(&pair).expect("they are fine");
        fire.step();
        fire.report().most_neighbours
    };
    assert_eq!(neighbours("periodic"), 1);
    assert_eq!(neighbours("solid"), 0);
}

#[test]
fn a_smaller_domain_takes_away_what_stands_outside() {
    let mut fire = Simulation::new(with([("walls", Input::Text("solid"))]));
    burn(&mut fire, 300);
    fire.set("domain_width", Input::Number(0.2))
        .expect("in range");
    assert!(fire.count() > 0);
    assert!(fire.positions().iter().all(|p| p.x.abs() <= 0.1));
}

#[test]
fn parameters_are_live() {
    let mut fire = Simulation::new(Parameters::default());
    burn(&mut fire, 480);
    let before = fire.count();
    fire.set("emission_rate", Input::Number(100.0))
        .expect("in range");
    burn(&mut fire, 480);
    assert!(fire.count() < before / 4);
}

/// Values of a parameter that are not its default.
fn others(param: &Param) -> Vec<Input<'static>> {
    let domain = &param.domains[0];
    match (param.kind, domain.default) {
        (Kind::Choice(names), _) => names.iter().map(|&name| Input::Text(name)).collect(),
        (Kind::Flag, _) => vec![Input::Flag(true)],
        (Kind::Colour, _) => vec![Input::Text("#123456")],
        _ => [domain.range.0, domain.range.1].map(Input::Number).to_vec(),
    }
}

#[test]
fn every_parameter_of_the_fire_changes_it_and_none_of_its_look_does() {
    for param in PARAMETERS {
        // Nothing reaches the speed limit but gas that is lifted as printed.
        let wild = ("printed_divisor", Input::Flag(param.id == "speed_limit"));
        // The domain is no wider than the source, so that there are walls to meet.
        let narrow = ("domain_width", Input::Number(0.36));
        let burnt = |more: Option<(&'static str, Input<'static>)>| {
            let mut fire = Simulation::new(with([wild, narrow].into_iter().chain(more)));
            while fire.time() < 1.0 {
                fire.step();
            }
            fire.particles()
        };
        let plain = burnt(None);
        let changed = others(param)
            .into_iter()
            .any(|value| burnt(Some((param.id, value))) != plain);
        let shown_only = param.group == "Look" || param.id == "time_scale";
        assert_eq!(changed, !shown_only, "{}", param.id);
    }
}

#[test]
fn whole_numbers_end_exactly_at_their_range_and_there_is_one_zero() {
    let mut parameters = Parameters::default();
    let beyond = f64::from(u32::MAX) + 1.0;
    assert!(parameters.set("seed", Input::Number(beyond)).is_err());
    assert!(
        parameters
            .set("max_particles", Input::Number(100_001.0))
            .is_err()
    );
    assert_eq!(parameters.set("viscosity", Input::Number(-0.0)), Ok(()));
    assert!(parameters.viscosity.is_sign_positive());
}

#[test]
fn a_refused_value_changes_nothing_and_says_what_is_allowed() {
    let mut fire = Simulation::new(Parameters::default());
    let before = fire.parameters().clone();
    let error = fire
        .set("viscosity", Input::Number(5.0))
        .expect_err("out of range");
    assert_eq!(
        error.to_string(),
        "viscosity = 5 is refused: it must be a number from 0 to 0.1 Pa·s"
    );
    for (id, input) in [
        ("viscosity", Input::Number(f64::NAN)),
        ("viscosity", Input::Text("lots")),
        ("viscosity", Input::Flag(true)),
        ("max_particles", Input::Number(200.5)),
        ("walls", Input::Text("rubber")),
        ("printed_euler", Input::Text("perhaps")),
        ("background", Input::Text("#12")),
        ("seed", Input::Number(-1.0)),
    ] {
        let error = fire.set(id, input).expect_err(id);
        assert!(error.to_string().contains(id), "{error}");
    }
    assert_eq!(*fire.parameters(), before);
}

#[test]
fn an_unknown_id_names_the_nearest_known_one() {
    let nearest = |id| match Parameters::default()
        .set(id, Input::Number(0.0))
        .expect_err("unknown")
        .reason
    {
        Refusal::UnknownId { nearest } => nearest,
        other => panic!("{other:?}"),
    };
    assert_eq!(nearest("viscosty"), Some("viscosity"));
    assert_eq!(nearest("bouyancy"), Some("buoyancy"));
    assert_eq!(nearest("xyzzy"), None);
}

#[test]
fn texts_spell_every_kind_of_value() {
    let parameters = with([
        ("viscosity", Input::Text(" 0.02 ")),
        ("max_particles", Input::Text("500")),
        ("walls", Input::Text("solid")),
        ("printed_euler", Input::Text("")),
        ("background", Input::Text("#102030")),
        ("seed", Input::Text("4294967295")),
    ]);
    assert_eq!(parameters.viscosity, 0.02);
    assert_eq!(parameters.max_particles, 500);
    assert!(parameters.printed_euler);
    assert_eq!(parameters.background.rgba, [16, 32, 48, 255]);
    assert_eq!(parameters.seed, u32::MAX);
    // What is written reads back as the same.
    for (param, value) in parameters.changed() {
        let mut again = Parameters::default();
        again
            .set(param.id, Input::Text(&value.to_string()))
            .expect(param.id);
        assert_eq!(again.get(param.id), Some(value));
    }
}
