//! The ranges hold: at whatever corner the sliders stand, the fire stays finite,
//! stays inside, and is not held together by the speed limit.

use hearth_core::params::{Choice, Input, Kind, PARAMETERS, Param, Walls};
use hearth_core::random::Random;
use hearth_core::{Parameters, Simulation};

/// Most particles of a corner: enough for every neighbourhood that there is,
/// and few enough for a test.
const MOST_PARTICLES: f64 = 1500.0;

/// Simulated time of a corner [s].
const SECONDS: f64 = 2.0;

/// Parameters that move particles and have a range, without those that only
/// say how the result is shown or how fast it is played, and without the
/// speed limit, whose own corner is the stricter the lower it is.
fn swept() -> Vec<&'static Param> {
    PARAMETERS
        .iter()
        .filter(|p| matches!(p.kind, Kind::Number(_) | Kind::Integer(_)))
        .filter(|p| p.group != "Look" && !["time_scale", "speed_limit"].contains(&p.id))
        .collect()
}

fn end(param: &Param, upper: bool) -> f64 {
    let (min, max) = param.domains[0].range;
    let end = if upper { max } else { min };
    if param.id == "max_particles" {
        end.min(MOST_PARTICLES)
    } else {
        end
    }
}

fn set(parameters: &mut Parameters, id: &str, input: Input<'_>) {
    assert_eq!(parameters.set(id, input), Ok(()));
}

/// Burns and checks; returns the share of particle-steps at the speed limit.
fn burn(parameters: Parameters, name: &str) -> f64 {
    let (width, height) = (parameters.domain_width, parameters.domain_height);
    let steps = (SECONDS / f64::from(parameters.time_step)).ceil() as u32;
    let mut fire = Simulation::new(parameters);
    let (mut limited, mut moved) = (0.0, 0.0);
    for _ in 0..steps {
        fire.step();
        limited += f64::from(fire.report().at_speed_limit);
        moved += fire.count() as f64;
    }
    for particle in fire.particles() {
        let all = [
            particle.position.x,
            particle.position.y,
            particle.velocity.x,
            particle.velocity.y,
            particle.temperature,
        ];
        assert!(all.iter().all(|x| x.is_finite()), "{name}: {particle:?}");
        assert!(
            particle.position.x.abs() <= 0.5 * width,
            "{name}: {particle:?}"
        );
        assert!(
            (0.0..=height).contains(&particle.position.y),
            "{name}: {particle:?}"
        );
    }
    limited / f64::max(moved, 1.0)
}

#[test]
fn each_slider_at_either_end() {
    for param in swept() {
        for upper in [false, true] {
            let mut parameters = Parameters::default();
            set(
                &mut parameters,
                "max_particles",
                Input::Number(MOST_PARTICLES),
            );
            set(&mut parameters, param.id, Input::Number(end(param, upper)));
            let name = format!("{} = {}", param.id, end(param, upper));
            let limited = burn(parameters, &name);
            assert!(
                limited < 0.05,
                "{name}: {:.1} % at the speed limit",
                100.0 * limited
            );
        }
    }
}

#[test]
fn random_corners_of_all_sliders() {
    let swept = swept();
    let mut random = Random::new(2026);
    for corner in 0..40 {
        let mut parameters = Parameters::default();
        let mut name = format!("corner {corner}:");
        for param in &swept {
            let value = end(param, random.bits() & 1 == 1);
            set(&mut parameters, param.id, Input::Number(value));
            name += &format!(" {}={value}", param.id);
        }
        let walls = Walls::NAMES[random.bits() as usize % Walls::NAMES.len()];
        set(&mut parameters, "walls", Input::Text(walls));
        name += &format!(" walls={walls}");
        let limited = burn(parameters, &name);
        assert!(
            limited < 0.05,
            "{name}: {:.1} % at the speed limit",
            100.0 * limited
        );
    }
}

#[test]
fn the_printed_equations_stay_finite_each_alone_and_all_together() {
    let flags: Vec<&str> = PARAMETERS
        .iter()
        .filter(|p| p.id.starts_with("printed_"))
        .map(|p| p.id)
        .collect();
    assert_eq!(flags.len(), 5);
    let mut all = Parameters::default();
    for flag in flags {
        let mut alone = Parameters::default();
        set(&mut alone, flag, Input::Flag(true));
        set(&mut all, flag, Input::Flag(true));
        // What the printed forms do at the speed limit is the paper's affair.
        burn(alone, flag);
    }
    burn(all, "all printed");
}

#[test]
fn a_fire_that_was_driven_to_a_corner_recovers() {
    let mut fire = Simulation::new(Parameters::default());
    let mut wild = Parameters::default();
    for (id, value) in [("gas_constant", 6.0), ("buoyancy", 1.0), ("gravity", 20.0)] {
        set(&mut wild, id, Input::Number(value));
    }
    set(&mut wild, "printed_divisor", Input::Flag(true));
    let burn = |fire: &mut Simulation| (0..480).for_each(|_| fire.step());
    burn(&mut fire);
    let before = fire.count() as f64;
    fire.set_parameters(wild);
    burn(&mut fire);
    fire.set_parameters(Parameters::default());
    burn(&mut fire);
    let after = fire.count() as f64;
    assert_eq!(fire.report().at_speed_limit, 0);
    assert!(
        (after / before - 1.0).abs() < 0.2,
        "{before} particles before, {after} after"
    );
}
