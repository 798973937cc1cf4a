//! Laws of solids thinner than the reach of the kernel: the gas of the two sides does not interact.

use hearth_core::params::Input;
use hearth_core::{Particle, Scene, Simulation, Vec2};
use hearth_tests::fires;

/// Adds a plate across the domain at a height \[m\].
fn add_plate(scene: &mut Scene, y: f64) {
    let added = scene.add(&[
        ("kind", Input::Text("solid")),
        ("shape", Input::Text("line")),
        ("y", Input::Number(y)),
        ("width", Input::Number(2.0)),
        ("height", Input::Number(0.01)),
    ]);
    assert!(added.is_ok(), "{added:?}");
}

/// A classic fire without gravity: a dense cloud that turns below y = 0.5 m, and a particle at
/// rest above. It has its number of particles, so the source emits none.
fn cloud(plate: bool) -> Simulation {
    let still = [
        ("gravity", 0.0),
        ("buoyancy", 0.0),
        ("thermal_buoyancy", 0.0),
        ("max_particles", 100.0),
    ];
    let mut scene = fires::with_numbers(&still);
    if plate {
        add_plate(&mut scene, 0.5);
    }
    let mut fire = Simulation::new(scene);
    let apart = 0.4 * fire.parameters().smoothing_radius;
    let mut particles = vec![Particle::at(Vec2::new(0.0, 0.507))];
    for i in 0..120 {
        let place = Vec2::new((i % 12) as f32 - 5.5, -((i / 12) as f32)) * apart;
        particles.push(Particle {
            velocity: place.perp(),
            ..Particle::at(Vec2::new(0.0, 0.493) + place)
        });
    }
    for particle in &mut particles {
        particle.lifetime = 100.0;
    }
    assert_eq!(fire.set_particles(&particles), Ok(()));
    fire
}

#[test]
fn a_classic_particle_at_rest_stays_at_rest_beside_a_plate_with_a_cloud_behind_it() {
    for plate in [false, true] {
        let mut fire = cloud(plate);
        for _ in 0..20 {
            fire.step();
        }
        let speed = fire.velocities()[0].length();
        assert_eq!(speed > 0.0, !plate, "{speed} m/s");
    }
}

#[test]
fn particles_behind_a_plate_are_no_neighbours_in_a_display() {
    for plate in [false, true] {
        let fire = cloud(plate);
        let (vorticity, neighbours) = (fire.vorticities()[0], fire.neighbour_counts()[0]);
        assert_eq!(neighbours > 0, !plate, "{neighbours}");
        assert_eq!(vorticity != 0.0, !plate, "{vorticity}/s");
    }
}

#[test]
fn another_number_of_particles_mixes_nothing_through_a_plate() {
    let calm = [("fuel_power", 0.0), ("particles", 1500.0)];
    let mut scene = fires::combustion(&calm);
    let kelvin = scene.world().ambient_temperature;
    add_plate(&mut scene, 0.45);
    add_plate(&mut scene, 1.35);
    let mut fire = Simulation::new(scene);
    let is_between = |at: Vec2| (0.45..1.35).contains(&at.y);
    let mut gas = fire.particles();
    for particle in &mut gas {
        if is_between(particle.position) {
            particle.temperature = 1200.0;
        }
    }
    assert_eq!(fire.set_particles(&gas), Ok(()));
    for count in [2500.0, 1000.0] {
        assert_eq!(fire.set("particles", Input::Number(count)), Ok(()));
        for particle in fire.particles() {
            let expected = if is_between(particle.position) {
                1200.0
            } else {
                kelvin
            };
            // A mean of equal numbers, rounded.
            let error = (particle.temperature - expected).abs();
            assert!(error < 0.1, "{error} K at {}", particle.position);
        }
    }
}
