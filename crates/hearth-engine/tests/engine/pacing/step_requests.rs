//! Steps that a script requests.

use hearth_core::params::Model;
use hearth_core::{Parameters, Simulation};
use hearth_engine::pacing::step_requests::StepRequests;

fn fire() -> Simulation {
    Simulation::new(Parameters::new(Model::Classic))
}

/// Makes the next requested step. Returns whether there was one.
fn step(fire: &mut Simulation, requests: &mut StepRequests) -> bool {
    let Some(request) = requests.next_open() else {
        return false;
    };
    let end = request.end(fire.time());
    fire.step_towards(end, None, &mut |_| ());
    request.take(fire.time());
    requests.close();
    true
}

#[test]
fn requests_are_answered_in_their_order_at_their_exact_times() {
    let (mut fire, mut library) = (fire(), fire());
    let mut requests = StepRequests::default();
    requests.add(0, 1.0 / 30.0, 1);
    requests.add(0, 0.0, 2);
    requests.add(7, 0.0, 3);
    requests.add(0, 0.1, 4);
    let mut answers = Vec::new();
    while step(&mut fire, &mut requests) {
        let answered = requests.answers();
        answers.extend(answered.into_iter().map(|request| (request, fire.time())));
    }
    library.advance(1.0 / 30.0);
    let first = library.time();
    (0..7).for_each(|_| library.step());
    let third = library.time();
    library.advance(0.1);
    assert_eq!(
        answers,
        [(1, first), (2, first), (3, third), (4, library.time())]
    );
    assert_eq!(fire.particles(), library.particles());
}

#[test]
fn a_fire_that_starts_again_makes_the_rest_of_a_duration() {
    let (mut fire, mut requests) = (fire(), StepRequests::default());
    fire.advance(5.0);
    requests.add(0, 1.0, 1);
    while fire.time() < 5.5 {
        step(&mut fire, &mut requests);
    }
    let made = fire.time() - 5.0;
    fire.reset();
    while step(&mut fire, &mut requests) {}
    assert!((fire.time() + made - 1.0).abs() < 1e-12);
    assert_eq!(requests.answers(), [1]);
}
