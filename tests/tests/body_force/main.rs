//! The worked example of CONTRIBUTING.md: a body force is a file and a line.
#![cfg(not(target_arch = "wasm32"))]

mod coriolis;

use coriolis::Coriolis;
use hearth_core::params::Model;
use hearth_core::{LocalGas, Parameters, Simulation, Vec2};
use hearth_tests::fires::{closed_box, filled, mean};

fn turned(fire: &mut Simulation, force: &Coriolis, seconds: f64) {
    while fire.time() < seconds {
        fire.step_in_stages(Some(force), &mut |_| ());
    }
}

#[test]
fn the_coriolis_force_turns_the_gas_and_does_no_work() {
    let force = Coriolis {
        angular_velocity: 1.5,
    };
    let mut fire = filled(closed_box(&[]), 32, |particle| particle.velocity = Vec2::X);
    turned(&mut fire, &force, 0.2);
    let velocities = fire.velocities();
    let velocity = Vec2::new(
        mean(velocities.iter().map(|v| v.x)) as f32,
        mean(velocities.iter().map(|v| v.y)) as f32,
    );
    let angle = -2.0 * force.angular_velocity * fire.time() as f32;
    assert!((velocity.length() - 1.0).abs() < 0.01, "{velocity}");
    assert!((velocity.to_angle() - angle).abs() < 0.01, "{velocity}");
}

#[test]
fn both_models_pass_the_state_of_the_gas_to_a_force() {
    for model in [Model::Classic, Model::Combustion] {
        let mut fire = Simulation::new(Parameters::new(model));
        while fire.time() < 0.3 {
            fire.step();
        }
        let hottest = std::cell::Cell::new(0.0_f32);
        let widest = std::cell::Cell::new(0.0_f32);
        let listen = Listener(|gas: &LocalGas| {
            hottest.set(hottest.get().max(gas.temperature));
            widest.set(widest.get().max(gas.expansion));
        });
        fire.step_in_stages(Some(&listen), &mut |_| ());
        assert!(hottest.get() > 800.0, "{model:?}: {} K", hottest.get());
        assert!(widest.get() > 1.0, "{model:?}: {}", widest.get());
    }
}

/// A force that accelerates nothing.
struct Listener<F: Fn(&LocalGas)>(F);

impl<F: Fn(&LocalGas)> hearth_core::BodyForce for Listener<F> {
    fn acceleration(&self, gas: &LocalGas) -> Vec2 {
        (self.0)(gas);
        Vec2::ZERO
    }
}

#[test]
fn contributing_shows_this_file() {
    let guide = include_str!("../../../CONTRIBUTING.md");
    assert!(guide.contains(include_str!("coriolis.rs").trim_end()));
}
