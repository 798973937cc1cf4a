//! What a user of the simulation relies on: walls, own initial states and
//! forces, live parameters.

use hearth_core::params::{Input, Model};
use hearth_core::{Parameters, Particle, Scene, Simulation, Vec2};
use hearth_tests::fires::{self, with};

fn burn(fire: &mut Simulation, steps: u32) {
    (0..steps).for_each(|_| fire.step());
}

fn particle(x: f32, y: f32, vx: f32, vy: f32) -> Particle {
    Particle {
        velocity: Vec2::new(vx, vy),
        temperature: 1000.0,
        lifetime: 100.0,
        ..Particle::at(Vec2::new(x, y))
    }
}

/// No source to speak of and no lift: what is put in moves by itself.
fn still(walls: &str) -> Scene {
    with([
        ("walls", Input::Text(walls)),
        ("gravity", Input::Number(0.0)),
        ("emission_rate", Input::Number(50.0)),
        ("max_particles", Input::Number(100.0)),
    ])
}

#[test]
fn a_reset_fire_repeats_itself() {
    let mut fire = Simulation::new(Parameters::new(Model::Classic));
    burn(&mut fire, 300);
    let first = fire.particles();
    fire.reset();
    assert_eq!((fire.count(), fire.time()), (0, 0.0));
    burn(&mut fire, 300);
    assert_eq!(fire.particles(), first);
}

/// A small fire of each model.
fn small() -> [Simulation; 2] {
    let classic = Scene::of_model(Model::Classic);
    [classic, fires::combustion(&[("particles", 1000.0)])].map(Simulation::new)
}

#[test]
fn frames_stand_at_exactly_the_time_that_is_asked_for() {
    for mut fire in small() {
        for rate in [24.0, 30.0, 60.0, 1000.0] {
            fire.reset();
            for frame in 1..=30 {
                let before = fire.time();
                fire.advance(1.0 / rate);
                assert_eq!(fire.time(), before + 1.0 / rate);
                assert!((fire.time() - f64::from(frame) / rate).abs() < 1e-14);
            }
        }
        for none in [0.0, -0.1, f64::NAN] {
            let before = (fire.time(), fire.particles());
            fire.advance(none);
            assert_eq!((fire.time(), fire.particles()), before);
        }
    }
}

#[test]
fn the_last_steps_before_a_time_are_no_shorter_than_half_of_the_others() {
    for mut fire in small() {
        fire.advance(0.2);
        for _ in 0..20 {
            let (mut free, end) = (fire.clone(), fire.time() + 0.021);
            while fire.time() < end {
                free.clone_from(&fire);
                free.step();
                fire.step_towards(end, None, &mut |_| ());
                let (length, longest) = (fire.step_length(), free.step_length());
                assert!(length >= 0.499 * longest, "{length} s of {longest} s");
                assert!(length <= 1.001 * longest, "{length} s of {longest} s");
            }
        }
    }
}

#[test]
fn a_fire_in_frames_is_the_same_fire() {
    // Frames that cut every step: as much is born, burns and is left as in whole steps.
    for (fire, mut whole) in small().into_iter().zip(small()) {
        let mut framed = fire.clone();
        for _ in 0..200 {
            framed.advance(0.01);
        }
        let mut again = fire;
        for _ in 0..200 {
            again.advance(0.01);
        }
        assert_eq!(framed.particles(), again.particles());
        while whole.time() < 2.0 {
            whole.step();
        }
        let counts = [&framed, &whole].map(|fire| fire.count() as f64);
        assert!(
            (counts[0] / counts[1] - 1.0).abs() < 0.05,
            "{counts:?} particles"
        );
    }
}

#[test]
fn readers_do_not_change_a_fire() {
    let mut read = Simulation::new(Parameters::new(Model::Classic));
    let mut left = Simulation::new(Parameters::new(Model::Classic));
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
    let mut fire = Simulation::new(Parameters::new(Model::Classic));
    burn(&mut fire, 200);
    // Ages in the order of birth never rise: younger particles come later,
    // but for those born within the same step.
    let step = fire.parameters().time_step;
    assert!(fire.ages().windows(2).all(|pair| pair[1] <= pair[0] + step));
}

#[test]
fn particles_that_are_put_in_are_read_back() {
    let mut fire = Simulation::new(still("open"));
    let given: Vec<Particle> = (0..50)
        .map(|i| particle(-0.5 + 0.02 * i as f32, 0.5, 0.0, 0.1))
        .collect();
    fire.set_particles(&given).expect("they are fine");
    assert_eq!(fire.particles(), given);
}

#[test]
fn invalid_particles_are_errors_and_change_nothing() {
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
        assert_eq!(error.index, Some(1));
        assert!(error.to_string().contains("particle 1"), "{error}");
        assert_eq!(fire.particles(), [good]);
    }
}

/// Air that fills the domain of the combustion model, thinly.
fn gas() -> Vec<Particle> {
    let place = |i: i32| Vec2::new((i % 30) as f32 * 0.04 - 0.58, (i / 30) as f32 * 0.09 + 0.04);
    let fast = |i: i32| Particle {
        velocity: Vec2::new(0.002 * i as f32, -0.5),
        temperature: 300.0 + 0.25 * i as f32,
        fuel: 0.0005 * i as f32,
        oxygen: 1.0 - 0.0008 * i as f32,
        soot: 0.001 * i as f32,
        ..Particle::at(place(i))
    };
    (0..600).map(fast).collect()
}

#[test]
fn gas_that_is_put_in_is_read_back_and_burns() {
    let mut fire = Simulation::new(fires::combustion(&[]));
    let mut given = gas();
    fire.set_particles(&given).expect("it is fine");
    assert_eq!(fire.particles(), given);
    assert_eq!(fire.count(), given.len());
    let of = |figure: fn(&Particle) -> f32| given.iter().map(figure).collect::<Vec<_>>();
    assert_eq!(fire.temperatures(), of(|p| p.temperature));
    assert_eq!(fire.fuels(), Some(of(|p| p.fuel)));
    assert_eq!(fire.oxygens(), Some(of(|p| p.oxygen)));
    assert_eq!(fire.soots(), Some(of(|p| p.soot)));

    // What came out goes in again, another time.
    fires::burn_on(&mut fire, 0.2);
    given = fire.particles();
    assert!(given.iter().all(|p| p.age > 0.19));
    fire.set_particles(&given).expect("it came from there");
    assert_eq!(fire.particles(), given);
}

#[test]
fn invalid_gas_is_an_error_and_changes_nothing() {
    let mut fire = fires::burn(fires::combustion(&[]), 0.3);
    let (before, embers) = (fire.particles(), fire.embers().to_vec());
    let good = gas()[70];
    type Spoil = fn(&mut Particle);
    let spoilt: [(&str, Spoil); 16] = [
        ("position", |p| p.position.x = f32::NAN),
        ("position", |p| p.position.x = 0.61),
        ("position", |p| p.position.y = -0.01),
        ("position", |p| p.position.y = 1.81),
        ("velocity", |p| p.velocity.y = f32::INFINITY),
        ("temperature", |p| p.temperature = 0.5),
        ("temperature", |p| p.temperature = f32::NAN),
        ("age", |p| p.age = -1.0),
        ("lifetime", |p| p.lifetime = 0.0),
        ("fuel", |p| p.fuel = -0.1),
        ("fuel", |p| p.fuel = f32::NAN),
        ("fuel", |p| p.fuel = 1.1),
        ("oxygen", |p| p.oxygen = 1.1),
        ("oxygen", |p| p.oxygen = f32::NAN),
        ("soot", |p| p.soot = -0.1),
        ("soot", |p| p.soot = f32::INFINITY),
    ];
    for (what, spoil) in spoilt {
        let mut gas = gas();
        gas[70] = good;
        spoil(&mut gas[70]);
        let error = fire.set_particles(&gas).expect_err(what);
        assert_eq!(error.index, Some(70), "{what}");
        let text = error.to_string();
        assert!(
            text.contains("particle 70") && text.contains(what),
            "{text}"
        );
    }
    // The smoothing length goes with `particles`, which is 1000.
    for count in [0, 499, 2001] {
        let error = fire
            .set_particles(&vec![good; count])
            .expect_err("a wrong number");
        assert_eq!(error.index, None);
        assert!(error.to_string().contains("half to twice"), "{error}");
    }
    assert_eq!(fire.particles(), before);
    assert_eq!(fire.embers(), embers);
    assert_eq!(fire.set_particles(&vec![good; 500]), Ok(()));
}

#[test]
fn a_domain_that_leaves_all_gas_outside_is_filled_with_air() {
    let mut fire = Simulation::new(fires::combustion(&[]));
    let aside = Particle::at(Vec2::new(0.55, 0.9));
    assert_eq!(fire.set_particles(&vec![aside; 800]), Ok(()));
    assert_eq!(fire.set("domain_width", Input::Number(0.5)), Ok(()));
    assert!((1..=1000).contains(&fire.count()), "{}", fire.count());
    fire.step();
    assert!(fire.positions().iter().all(|at| at.x.abs() <= 0.25));
}

#[test]
fn a_reset_combustion_fire_repeats_itself() {
    let mut fire = fires::burn(fires::everything(), 0.6);
    let (first, embers, time) = (fire.particles(), fire.embers().to_vec(), fire.time());
    assert!(!embers.is_empty());
    fire.reset();
    assert_eq!((fire.time(), fire.embers().len()), (0.0, 0));
    while fire.time() < time {
        fire.step();
    }
    assert_eq!(fire.particles(), first);
    assert_eq!(fire.embers(), embers);
}

#[test]
fn step_lengths_add_up_to_the_time() {
    let mut fire = Simulation::new(fires::combustion(&[]));
    assert!(fire.step_length() > 0.0);
    let mut sum = 0.0;
    for _ in 0..200 {
        fire.step();
        assert_eq!(fire.step_length() as f32, fire.report().length);
        sum += fire.step_length();
    }
    assert_eq!(fire.time(), sum);
    // The finer the gas, the shorter its steps.
    let [coarse, fine] =
        [1000.0, 4000.0].map(|count| fires::burn(fires::combustion(&[("particles", count)]), 0.1));
    assert!(fine.step_length() < 0.7 * coarse.step_length());
}

#[test]
fn a_user_force_accelerates_both_models() {
    let pushed = |scene: &Scene, strength: f32| {
        let mut fire = Simulation::new(scene.clone());
        while fire.time() < 0.2 {
            fire.step_with(|_, _| Vec2::new(strength, 0.0));
        }
        fires::mean(fire.velocities().iter().map(|v| v.x))
    };
    // 5 m/s² for 0.2 s. The seam would hold the air, so the box is closed.
    let air = fires::closed_box(&[]);
    assert!((pushed(&air, 5.0) - 1.0).abs() < 0.05);
    let classic = Scene::of_model(Model::Classic);
    assert!(pushed(&classic, 5.0) > pushed(&classic, 0.0) + 0.3);
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
fn particles_leave_at_open_walls_stop_at_solid_ones_and_wrap_at_periodic_ones() {
    assert_eq!(flown_at_the_wall("open"), None);

    let stopped = flown_at_the_wall("solid").expect("it stays");
    assert_eq!((stopped.position.x, stopped.velocity.x), (0.6, 0.0));

    // 0.5 + 2 · 0.2 − 1.2 = −0.3
    let round = flown_at_the_wall("periodic").expect("it stays");
    assert!((round.position.x + 0.3).abs() < 1e-3, "{round:?}");
    assert_eq!(round.velocity.x, 2.0);
}

#[test]
fn the_top_is_open_with_any_walls() {
    for walls in ["open", "solid", "periodic"] {
        let mut fire = Simulation::new(still(walls));
        fire.set_particles(&[particle(0.0, 1.4, 0.0, 2.0)])
            .expect("it is fine");
        burn(&mut fire, 48);
        assert!(fire.positions().iter().all(|p| p.y < 0.9), "{walls}");
    }
}

#[test]
fn neighbours_interact_across_a_periodic_edge() {
    let pair = [
        particle(0.595, 1.0, 0.0, 0.0),
        particle(-0.595, 1.0, 0.0, 0.0),
    ];
    let neighbours = |walls| {
        let mut fire = Simulation::new(still(walls));
        fire.set_particles(&pair).expect("they are fine");
        fire.step();
        fire.report().max_neighbours
    };
    assert_eq!(neighbours("periodic"), 1);
    assert_eq!(neighbours("solid"), 0);
}

#[test]
fn a_smaller_domain_removes_the_particles_outside() {
    let mut fire = Simulation::new(with([("walls", Input::Text("solid"))]));
    burn(&mut fire, 300);
    fire.set("domain_width", Input::Number(0.2))
        .expect("in range");
    assert!(fire.count() > 0);
    assert!(fire.positions().iter().all(|p| p.x.abs() <= 0.1));
}

#[test]
fn parameters_are_live() {
    let mut fire = Simulation::new(Parameters::new(Model::Classic));
    burn(&mut fire, 480);
    let before = fire.count();
    fire.set("emission_rate", Input::Number(100.0))
        .expect("in range");
    burn(&mut fire, 480);
    assert!(fire.count() < before / 4);
}

/// A classic fire whose steps need all substeps, with particles `apart` from each other.
fn stiff(count: u32, apart: f32) -> Simulation {
    let parameters = with([
        ("gas_constant", Input::Number(6.0)),
        ("viscosity", Input::Number(0.1)),
        ("time_step", Input::Number(0.017)),
        ("smoothing_radius", Input::Number(0.02)),
        ("max_particles", Input::Number(20_000.0)),
    ]);
    let mut fire = Simulation::new(parameters);
    let at = |i: u32| {
        let [x, y] = [i % 100, i / 100].map(|cell| apart * cell as f32);
        particle(x - 0.5 * 100.0 * apart, 0.3 + y, 0.0, 0.0)
    };
    let particles: Vec<Particle> = (0..count).map(at).collect();
    assert_eq!(fire.set_particles(&particles), Ok(()));
    fire
}

#[test]
fn a_step_of_crowded_particles_is_short_instead_of_long_in_work() {
    let mut fire = stiff(20_000, 1e-4);
    for _ in 0..2 {
        let before = fire.time();
        fire.step();
        let report = fire.report();
        assert_eq!(report.substeps, 1);
        assert!(report.length < 0.017 / 16.0, "{} s", report.length);
        assert_eq!(fire.time() - before, f64::from(report.length));
        assert_eq!(fire.step_length(), f64::from(report.length));
        assert!(
            fire.particles()
                .iter()
                .all(|particle| particle.position.is_finite())
        );
    }
}

#[test]
fn a_step_of_usual_work_has_its_whole_length() {
    let mut fire = stiff(2000, 0.01);
    for _ in 0..3 {
        fire.step();
        assert!(fire.report().substeps > 4);
        assert_eq!(fire.report().length, 0.017);
    }
}
