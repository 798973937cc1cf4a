//! Gas and bodies push each other, and keep their momentum.

use glam::DVec2;
use hearth_core::{Particle, Simulation, Vec2};
use hearth_tests::fires::{burn_on, closed_box, watch, with_numbers};
use hearth_tests::sweep::heap::gas_in_what_is_left;

use super::{GRAVITY, add, alone, floor, free};

/// Momentum of the gas, whose particles have this mass [kg/m], and of the bodies [kg/s].
pub fn momenta(fire: &Simulation, particle: f64) -> (DVec2, DVec2) {
    let gas = fire.velocities().into_iter();
    let bodies = fire.free_solids().into_iter();
    (
        gas.map(|v| v.as_dvec2() * particle).sum(),
        bodies
            .map(|body| body.velocity.as_dvec2() * f64::from(body.mass))
            .sum(),
    )
}

#[test]
fn bodies_and_gas_in_a_closed_box_keep_their_momentum() {
    let mut scene = closed_box(&[("gravity", 0.0), ("turbulence", 0.0)]);
    let density = ("density", 20.0);
    let ball = add(
        &mut scene,
        "circle",
        "free",
        &[("x", -0.1), ("y", 0.4), ("width", 0.1), density],
    );
    let plate = [
        ("x", 0.2),
        ("y", 0.5),
        ("width", 0.2),
        ("height", 0.03),
        ("angle", 30.0),
        density,
    ];
    add(&mut scene, "line", "free", &plate);
    // Every particle has the same share of the air that would fill the box without them.
    let places = Simulation::new(scene.world().clone()).count();
    let mut fire = Simulation::new(scene);
    let particle = f64::from(fire.parameters().ambient_density) * 0.64 / places as f64;
    // A gust meets them; then nothing acts on the box.
    let gust = |at: Vec2, _: Vec2| {
        if at.x < -0.2 {
            Vec2::new(20.0, 5.0)
        } else {
            Vec2::ZERO
        }
    };
    while fire.time() < 0.1 {
        fire.step_in_stages(Some(&gust), &mut |_| ());
    }
    let (gas, bodies) = momenta(&fire, particle);
    let (whole, mut moved) = (gas + bodies, 0.0_f64);
    watch(&mut fire, 2.0, |fire| {
        let (now, of_bodies) = momenta(fire, particle);
        moved = moved.max((of_bodies - bodies).length());
        let change = (now + of_bodies - whole).length() / whole.length();
        // Rounding: a run has 1e-7.
        assert!(change < 1e-5, "{change} at {} s", fire.time());
    });
    assert!(moved > 0.05 * whole.length(), "{moved} of {whole}");
    assert!(free(&fire, ball).spin.is_finite());
}

#[test]
fn bodies_and_particles_of_the_classic_model_keep_their_momentum() {
    let mut scene = with_numbers(&[
        ("time_step", 0.004),
        ("gravity", 0.0),
        ("buoyancy", 0.0),
        ("domain_width", 4.0),
        ("domain_height", 4.0),
    ]);
    assert_eq!(scene.set("walls", "open"), Ok(()));
    scene.clear();
    let place = [("x", 0.15), ("y", 2.0), ("width", 0.2), ("density", 5.0)];
    let ball = add(&mut scene, "circle", "free", &place);
    let plate = [
        ("x", 0.4),
        ("y", 2.05),
        ("width", 0.2),
        ("height", 0.03),
        ("angle", 70.0),
        ("density", 5.0),
    ];
    add(&mut scene, "line", "free", &plate);
    let mut fire = Simulation::new(scene);
    // A block of gas that flies at them.
    let thrown: Vec<Particle> = (0..200)
        .map(|i| Particle {
            velocity: Vec2::new(2.0, 0.1),
            lifetime: 100.0,
            ..Particle::at(Vec2::new(
                0.012 * (i % 20) as f32 - 0.3,
                0.012 * (i / 20) as f32 + 1.96,
            ))
        })
        .collect();
    assert_eq!(fire.set_particles(&thrown), Ok(()));
    let particle = f64::from(fire.parameters().particle_mass);
    let (whole, _) = momenta(&fire, particle);
    let mut moved = 0.0_f64;
    watch(&mut fire, 0.5, |fire| {
        assert_eq!(fire.count(), thrown.len());
        let (gas, bodies) = momenta(fire, particle);
        moved = moved.max(bodies.length());
        let change = (gas + bodies - whole).length() / whole.length();
        assert!(change < 1e-5, "{change} at {} s", fire.time());
    });
    assert!(moved > 0.1 * whole.length(), "{moved} of {whole}");
    assert!(free(&fire, ball).velocity.x > 0.0);
}

#[test]
fn a_light_sheet_rises_on_a_plume_and_a_block_does_not() {
    let height = |density: f64| {
        let mut scene = floor(&[]);
        for (id, value) in [
            ("fuel_power", 60.0),
            ("source_height", 0.05),
            ("spacing", 0.04),
        ] {
            assert_eq!(scene.set(id, value), Ok(()));
        }
        let sheet = [
            ("y", 0.5),
            ("width", 0.16),
            ("height", 0.01),
            ("density", density),
        ];
        let id = add(&mut scene, "line", "free", &sheet);
        let mut fire = Simulation::new(scene);
        let mut highest = 0.0_f32;
        watch(&mut fire, 2.0, |fire| {
            highest = highest.max(free(fire, id).place.y)
        });
        highest
    };
    let (sheet, block) = (height(4.0), height(500.0));
    assert!(sheet > 0.6, "{sheet}");
    assert!(block < 0.501, "{block}");
}

#[test]
fn a_balloon_rises_and_a_body_of_the_density_of_air_floats() {
    let risen = |density: f64| {
        let mut scene = alone();
        let ball = [("y", 0.5), ("width", 0.2), ("density", density)];
        let id = add(&mut scene, "circle", "free", &ball);
        let mut fire = Simulation::new(scene);
        burn_on(&mut fire, 0.2);
        free(&fire, id).place.y - 0.5
    };
    let air = f64::from(alone().world().ambient_density);
    // With half of its weight, the buoyancy is twice that.
    let path = 0.5 * GRAVITY * 0.04;
    assert!((risen(0.5 * air) / path - 1.0).abs() < 0.05);
    assert!(risen(air).abs() < 1e-5);
    assert!((risen(2.0 * air) / path + 0.5).abs() < 0.05);
}

#[test]
fn gas_yields_to_a_body_that_begins_in_the_floor() {
    // In coarse air the steps are longest. A particle of the first lattice is above each line.
    let mut scene = floor(&[]);
    assert_eq!(scene.set("spacing", 0.1), Ok(()));
    let places = [-0.35, -0.25, -0.15, -0.05, 0.05, 0.15, 0.25, 0.35];
    let ids = places.map(|x| {
        let (length, width) = (("width", 0.08), ("height", 0.02));
        let place = [("x", x), ("y", -0.3), ("angle", 90.0)];
        add(
            &mut scene,
            "line",
            "free",
            &[&place[..], &[length, width]].concat(),
        )
    });
    let mut fire = Simulation::new(scene);
    while fire.time() < 0.5 {
        fire.step();
        assert_eq!(gas_in_what_is_left(&fire), None, "{} s", fire.time());
    }
    for id in ids {
        assert!(free(&fire, id).place.y > -0.01, "{:?}", free(&fire, id));
    }
}
