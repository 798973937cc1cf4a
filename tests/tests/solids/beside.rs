//! Gas beside solids: it rests, flows, burns and is heated as the surfaces require, and has no interaction with what is
//! behind them.

use hearth_core::params::Input;
use hearth_core::{Particle, Scene, Simulation, Vec2};

use super::{CALM, Numbers, add, add_outline, burn, change, scene};

fn restlessness(fire: &Simulation) -> f32 {
    let velocities = fire.velocities();
    let sum: f32 = velocities.iter().map(|v| v.length_squared()).sum();
    (sum / velocities.len() as f32).sqrt()
}

#[test]
fn still_air_beside_solids_stays_still() {
    let wide: Numbers<'_> = &[("source_width", 1.0), ("particles", 3000.0)];
    for (choices, numbers) in [
        (&[][..], &[][..]),
        (&[("edges", "open"), ("floor", "solid")][..], wide),
    ] {
        let mut scene = scene(choices, &[CALM, numbers].concat());
        if numbers.is_empty() {
            let size = [("width", 0.3), ("height", 0.2), ("angle", 20.0)];
            add(
                &mut scene,
                "box",
                &[&[("x", 0.3), ("y", 1.2)], &size[..]].concat(),
            );
            add(
                &mut scene,
                "line",
                &[("x", -0.2), ("height", 0.01), ("angle", 70.0)],
            );
        } else {
            // Within the band of air around the source.
            let size = [("width", 0.1), ("height", 0.06), ("corner", 0.03)];
            add(&mut scene, "box", &[&[("y", 0.25)], &size[..]].concat());
        }
        let mut fire = Simulation::new(scene);
        burn(&mut fire, 4.0);
        let rms = restlessness(&fire);
        assert!(rms <= 0.01, "{choices:?}: {rms} m/s");
    }
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn a_source_keeps_its_power_beside_solids() {
    for choices in [&[][..], &[("edges", "open"), ("floor", "solid")]] {
        let mut scene = scene(choices, &[("particles", 1500.0)]);
        let power = |scene: &Scene| {
            let mut fire = Simulation::new(scene.clone());
            burn(&mut fire, 1.5);
            // Eddies of a second change the power by a tenth.
            burn(&mut fire, 5.0)
        };
        let bare = power(&scene);
        for x in [-0.22, 0.22] {
            add(
                &mut scene,
                "circle",
                &[("x", x), ("y", 0.35), ("width", 0.1)],
            );
        }
        let beside = power(&scene);
        assert!(
            (beside / bare - 1.0).abs() < 0.05,
            "{beside} for {bare} kW/m"
        );
    }
}

#[test]
#[ignore = "burns for minutes: `cargo xtask test burns`"]
fn a_source_keeps_its_power_beside_outlines() {
    for choices in [&[][..], &[("edges", "open"), ("floor", "solid")]] {
        let mut scene = scene(choices, &[("particles", 1500.0)]);
        let power = |scene: &Scene| {
            let mut fire = Simulation::new(scene.clone());
            burn(&mut fire, 1.5);
            // Eddies of a second change the power by a tenth.
            burn(&mut fire, 5.0)
        };
        let bare = power(&scene);
        add_outline(&mut scene, 0, &[("x", -0.4), ("y", 0.35)]);
        add_outline(&mut scene, 1, &[("x", 0.4), ("y", 0.35), ("height", 0.02)]);
        let beside = power(&scene);
        assert!(
            (beside / bare - 1.0).abs() < 0.05,
            "{beside} for {bare} kW/m"
        );
    }
}

#[test]
fn a_surface_of_fixed_temperature_heats_the_gas_and_an_adiabatic_one_does_not() {
    for (thermal, heated) in [("fixed", true), ("adiabatic", false)] {
        let mut scene = scene(&[], CALM);
        let id = add(&mut scene, "circle", &[("y", 0.9), ("temperature", 1200.0)]);
        let fields = [("thermal", Input::Text(thermal))];
        assert_eq!(scene.change(id, &fields), Ok(()));
        let mut fire = Simulation::new(scene);
        burn(&mut fire, 1.0);
        let hottest = fire.temperatures().into_iter().fold(0.0, f32::max);
        assert!((hottest > 320.0) == heated, "{thermal}: {hottest} K");
        assert!(hottest <= 1200.0);
    }
}

#[test]
fn a_moving_solid_pushes_the_gas() {
    let mut scene = scene(&[], CALM);
    let id = add(&mut scene, "circle", &[("x", -0.3), ("y", 0.9)]);
    let mut fire = Simulation::new(scene);
    burn(&mut fire, 0.5);
    let mut x = -0.3;
    for _ in 0..30 {
        burn(&mut fire, 1.0 / 60.0);
        x += 0.5 / 60.0;
        change(&mut fire, id, &[("x", x)]);
    }
    burn(&mut fire, 0.01);
    let all = fire.positions().into_iter().zip(fire.velocities());
    let ahead = |at: Vec2| (at - Vec2::new(x as f32 + 0.13, 0.9)).length() < 0.04;
    let pushed: Vec<f32> = all
        .filter(|particle| ahead(particle.0))
        .map(|particle| particle.1.x)
        .collect();
    let mean = pushed.iter().sum::<f32>() / pushed.len() as f32;
    assert!((0.2..0.7).contains(&mean), "{mean} m/s of {}", pushed.len());
    assert_eq!(fire.removed().map(|gas| gas.particles), Some(0));
}

#[test]
fn gas_does_not_interact_across_a_thin_plate() {
    let mut scene = scene(
        &[],
        &[CALM, &[("seam", 0.0), ("kinematic_viscosity", 0.01)]].concat(),
    );
    for y in [0.45, 1.35] {
        add(
            &mut scene,
            "line",
            &[("y", y), ("width", 2.0), ("height", 0.01)],
        );
    }
    let mut fire = Simulation::new(scene);
    burn(&mut fire, 1.0);
    let middle = |at: Vec2| (0.45..1.35).contains(&at.y);
    let particles: Vec<Particle> = fire.particles();
    let moving = particles.iter().map(|particle| {
        let speed = if middle(particle.position) { 1.0 } else { 0.0 };
        Particle {
            velocity: Vec2::new(speed, 0.0),
            ..*particle
        }
    });
    assert_eq!(fire.set_particles(&moving.collect::<Vec<_>>()), Ok(()));
    burn(&mut fire, 0.2);
    let mean = |inside: bool| {
        let all = fire.positions().into_iter().zip(fire.velocities());
        let these: Vec<f32> = all
            .filter(|particle| middle(particle.0) == inside)
            .map(|particle| particle.1.x)
            .collect();
        these.iter().sum::<f32>() / these.len() as f32
    };
    assert!(mean(true) > 0.6, "{}", mean(true));
    assert!(mean(false).abs() < 0.01, "{}", mean(false));
}

#[test]
fn gas_in_a_closed_ring_does_not_interact_with_the_gas_around_it() {
    // A step of the gas is longer than the thinner wall.
    for thickness in [0.01, 0.003] {
        let mut scene = scene(&[], &[CALM, &[("particles", 3000.0)]].concat());
        let id = add(&mut scene, "stroke", &[("y", 0.9), ("height", thickness)]);
        let ring = "-0.3,-0.3 0.3,-0.3 0.3,0.3 -0.3,0.3 -0.3,-0.3";
        assert_eq!(scene.change(id, &[("points", Input::Text(ring))]), Ok(()));
        let mut fire = Simulation::new(scene);
        burn(&mut fire, 0.5);
        let inside = |at: Vec2| at.x.abs() < 0.3 && (at.y - 0.9).abs() < 0.3;
        let moving = fire.particles().into_iter().map(|particle| Particle {
            velocity: if inside(particle.position) {
                Vec2::ZERO
            } else {
                Vec2::new(0.5, 0.0)
            },
            temperature: if inside(particle.position) {
                800.0
            } else {
                particle.temperature
            },
            ..particle
        });
        assert_eq!(fire.set_particles(&moving.collect::<Vec<_>>()), Ok(()));
        burn(&mut fire, 0.3);
        let all = fire.positions().into_iter().zip(fire.temperatures());
        let hottest = all
            .filter(|particle| !inside(particle.0))
            .map(|particle| particle.1)
            .fold(0.0, f32::max);
        assert!(hottest < 320.0, "{hottest} K outside of {thickness} m");
    }
}
