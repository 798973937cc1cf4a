//! What a fire burns with: what was asked for, and the level's number of particles.

use hearth_core::Simulation;
use hearth_core::params::Model;
use hearth_engine::message::{Order, SentValues, Start};
use hearth_engine::quality::Level;
use hearth_engine::raw::Raw;
use hearth_engine::wanted::{Wanted, adapt};
use hearth_render::Camera;

/// A start with nothing of its own.
fn start() -> Start {
    Start {
        size: (1, 1),
        side: 0.0,
        warm: 0.0,
        state: Vec::new(),
        preset: None,
        config: Raw::Missing,
        kept: Vec::new(),
        values: Vec::new(),
        own_number: false,
        quality: None,
        guess: None,
        paused: false,
        visible: true,
        camera: Camera::default(),
    }
}

fn at_first(start: &Start) -> Wanted {
    let (wanted, errors) = Wanted::at_first(start);
    assert_eq!(errors, []);
    wanted
}

fn sent<const N: usize>(values: [(&str, Raw); N]) -> SentValues {
    values.map(|(id, value)| (id.to_owned(), value)).into()
}

fn number(particles: u32) -> (&'static str, Raw) {
    ("max_particles", Raw::Number(particles.into()))
}

fn model(name: &str) -> (&'static str, Raw) {
    ("model", Raw::Text(name.to_owned()))
}

fn restore(id: &str) -> Order {
    Order::Restore(vec![id.to_owned()])
}

/// What is wanted after a good order about values.
fn then(wanted: &Wanted, order: &Order) -> Wanted {
    match wanted.after(order) {
        Some(Ok(wanted)) => wanted,
        other => panic!("{order:?} gives {other:?}"),
    }
}

/// What is wanted after these orders.
fn after<const N: usize>(orders: [Order; N]) -> Wanted {
    let first = at_first(&start());
    orders
        .iter()
        .fold(first, |wanted, order| then(&wanted, order))
}

/// The particles that it has at each level.
fn particles(wanted: &Wanted) -> [u32; 3] {
    Level::ALL.map(|level| wanted.at(level.particles()).settings().max_particles)
}

const FOLLOWS: [u32; 3] = [1200, 3000, 6700];

#[test]
fn the_number_is_the_levels_until_somebody_sets_it_to_whatever() {
    assert_eq!(particles(&at_first(&start())), FOLLOWS);
    // The default among them.
    for own in [2000, 2999, 3000, 3001] {
        let wanted = after([Order::Set(sent([number(own)]))]);
        assert_eq!(particles(&wanted), [own; 3]);
        // Until it is put back, by itself or with all others.
        for back in [
            restore("max_particles"),
            Order::Preset("default".to_owned()),
        ] {
            let wanted = then(&wanted, &back);
            assert_eq!(particles(&wanted), FOLLOWS);
        }
        // And not by what is about something else.
        for other in [
            restore("seed"),
            Order::Set(sent([("seed", Raw::Number(7.0))])),
        ] {
            let wanted = then(&wanted, &other);
            assert_eq!(particles(&wanted), [own; 3]);
        }
        assert_eq!(wanted.after(&Order::Play), None);
    }
}

#[test]
fn what_is_refused_sets_no_number() {
    let wanted = at_first(&start());
    let bad = Order::Set(sent([number(3000), ("bloom", Raw::Number(99.0))]));
    assert!(wanted.after(&bad).is_some_and(|after| after.is_err()));
    let alone = Order::Set(sent([number(0)]));
    assert!(wanted.after(&alone).is_some_and(|after| after.is_err()));
}

#[test]
fn the_classic_models_number_is_its_own() {
    let classic = after([Order::Set(sent([model("classic"), number(500)]))]);
    assert_eq!(particles(&classic), [500; 3]);
    let back = then(&classic, &Order::Set(sent([model("combustion")])));
    assert_eq!(particles(&back), FOLLOWS);
    // And the other way round.
    let wanted = after([
        Order::Set(sent([number(3000)])),
        Order::Set(sent([model("classic")])),
        restore("max_particles"),
        Order::Set(sent([model("combustion")])),
    ]);
    assert_eq!(particles(&wanted), [3000; 3]);
}

#[test]
fn a_fire_that_comes_back_knows_whose_number_it_has() {
    for (own_number, expected) in [(true, [3000; 3]), (false, FOLLOWS)] {
        let values = sent([model("combustion"), number(3000)]);
        let start = Start {
            values,
            own_number,
            ..start()
        };
        assert_eq!(particles(&at_first(&start)), expected);
    }
}

#[test]
fn what_makes_other_work_is_known() {
    let wanted = at_first(&start());
    for other in [
        model("classic"),
        number(2000),
        // As many at this level, but for ever.
        number(3000),
        ("time_scale", Raw::Number(0.5)),
    ] {
        assert!(!then(&wanted, &Order::Set(sent([other]))).works_like(&wanted));
    }
    for same in [("bloom", Raw::Number(0.5)), ("wind", Raw::Number(0.2))] {
        assert!(then(&wanted, &Order::Set(sent([same]))).works_like(&wanted));
    }
}

#[test]
fn what_a_fire_starts_with_does_not_depend_on_the_guess_for_the_machine() {
    let wanted = at_first(&start());
    let set = |values| then(&wanted, &Order::Set(values));
    let cases = [
        (wanted.clone(), Level::Medium),
        (set(sent([number(2000)])), Level::Low),
        (set(sent([("domain_height", Raw::Number(1.2))])), Level::Low),
    ];
    for (asked, level) in cases {
        let burnt = |guess: Level| {
            let mut fire = Simulation::new(wanted.at(guess.particles()));
            adapt(&mut fire, asked.at(level.particles()));
            for _ in 0..20 {
                fire.step();
            }
            fire.positions()
        };
        let (low, high) = (burnt(Level::Low), burnt(Level::High));
        assert_eq!(low, high);
        // It is the one that starts again from nothing, too.
        let mut again = Simulation::new(wanted.at(Level::High.particles()));
        again.step();
        adapt(&mut again, asked.at(level.particles()));
        again.reset();
        for _ in 0..20 {
            again.step();
        }
        assert_eq!(again.positions(), low);
    }
}

#[test]
fn a_burning_fire_is_taken_over() {
    let wanted = at_first(&start());
    assert_eq!(wanted.parameters().model(), Model::Combustion);
    let mut fire = Simulation::new(wanted.at(Level::Medium.particles()));
    for _ in 0..20 {
        fire.step();
    }
    let time = fire.time();
    adapt(&mut fire, wanted.at(Level::Low.particles()));
    assert_eq!(fire.time(), time);
    assert!(fire.count() < 1500);
}
