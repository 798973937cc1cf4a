//! What a display mode measures is what the gas is, of every particle, and
//! measuring changes nothing. Kernels are wider where open air ends.

use hearth_core::params::{Choice, DisplayMode, Input, Model};
use hearth_core::{Instance, Parameters, Scene, Simulation, Vec2};
use hearth_tests::fires::{burn, closed_box, combustion, filled, mean, with};

/// Neighbours of each particle, every one compared with every other.
fn counted(fire: &Simulation) -> Vec<u32> {
    let parameters = fire.parameters();
    let size = Vec2::new(parameters.domain_width, parameters.domain_height);
    let is_combustion = parameters.model() == Model::Combustion;
    let reach = 2.0 * parameters.smoothing_length();
    let places = fire.positions();
    let near = |a: Vec2, b: Vec2| {
        let mut offset = a - b;
        if is_combustion || parameters.walls.name() == "periodic" {
            offset.x -= size.x * (offset.x / size.x).round();
        }
        if is_combustion {
            offset.y -= size.y * (offset.y / size.y).round();
        }
        offset.length() < reach
    };
    let others = |&a: &Vec2| places.iter().filter(|&&b| near(a, b)).count() as u32 - 1;
    places.iter().map(others).collect()
}

/// What the picture of that mode gets.
fn shown(fire: &Simulation, mode: DisplayMode) -> Vec<Instance> {
    let mut fire = fire.clone();
    let set = fire.set("display_mode", Input::Text(mode.name()));
    assert_eq!(set, Ok(()));
    let mut instances = Vec::new();
    fire.write_instances(&mut instances);
    instances
}

fn fires() -> [Simulation; 4] {
    [
        burn(combustion(&[]), 0.7),
        // Narrow: most particles have neighbours beyond an edge.
        burn(
            combustion(&[("domain_width", 0.3), ("domain_height", 0.6)]),
            0.1,
        ),
        burn(Parameters::new(Model::Classic), 1.0),
        burn(with([("walls", Input::Text("periodic"))]), 1.0),
    ]
}

#[test]
fn the_vorticity_of_a_rigid_rotation_is_twice_its_angular_velocity() {
    for spin in [-3.0, 0.5, 8.0] {
        let middle = Vec2::new(0.0, 0.4);
        let turning = |particle: &mut hearth_core::Particle| {
            particle.velocity = spin * (particle.position - middle).perp();
            particle.lifetime = 9.0;
        };
        let box_of_gas = filled(closed_box(&[]), 32, turning);
        let alone = with([
            ("domain_width", Input::Number(0.8)),
            ("domain_height", Input::Number(0.8)),
        ]);
        for fire in [box_of_gas, filled(alone, 40, turning)] {
            // Beyond a periodic edge it turns otherwise. Gas that ends has its rim.
            let inside = match fire.parameters().model() {
                Model::Combustion => 0.25,
                Model::Classic => 1.0,
            };
            for (place, found) in fire.positions().into_iter().zip(fire.vorticities()) {
                let off = (found / (2.0 * spin) - 1.0).abs();
                assert!(
                    place.distance(middle) > inside || off < 1e-3,
                    "{found} 1/s at {place} where gas turns at {spin} 1/s"
                );
            }
        }
    }
}

#[test]
fn uniform_flow_has_no_vorticity_and_shear_has_the_right_one() {
    let moving = filled(closed_box(&[]), 32, |particle| {
        particle.velocity = Vec2::new(2.0, -1.0);
    });
    assert!(moving.vorticities().iter().all(|&found| found == 0.0));

    let shear = 4.0;
    let sheared = filled(closed_box(&[]), 32, |particle| {
        particle.velocity = Vec2::new(shear * particle.position.y, 0.0);
    });
    let places = sheared.positions().into_iter();
    let inside = places
        .zip(sheared.vorticities())
        .filter(|(place, _)| (0.2..0.6).contains(&place.y))
        .map(|(_, found)| found);
    let found = mean(inside);
    assert!((found / -f64::from(shear) - 1.0).abs() < 0.02, "{found}");
}

#[test]
fn neighbour_counts_are_exact() {
    for fire in fires() {
        assert_eq!(fire.neighbour_counts(), counted(&fire));
    }
    let empty = Simulation::new(Parameters::new(Model::Classic));
    assert!(empty.neighbour_counts().is_empty());
}

#[test]
fn every_instance_has_the_value_of_its_reader() {
    for fire in fires() {
        let speeds = fire.velocities().into_iter().map(|v| v.length());
        let counts = fire.neighbour_counts().into_iter().map(|n| n as f32);
        let ages = fire.particles().into_iter();
        let lived = ages.map(|particle| particle.age / particle.lifetime);
        let (fuels, soots) = match fire.parameters().model() {
            Model::Combustion => (
                fire.fuels().unwrap_or_default(),
                fire.soots().unwrap_or_default(),
            ),
            Model::Classic => lived.map(|lived| (1.0 - lived, lived.powi(3))).unzip(),
        };
        for (mode, expected) in [
            (DisplayMode::Particles, fire.temperatures()),
            (DisplayMode::Temperature, fire.temperatures()),
            (DisplayMode::Density, fire.densities()),
            (DisplayMode::Pressure, fire.pressures()),
            (DisplayMode::Velocity, speeds.collect()),
            (DisplayMode::Vorticity, fire.vorticities()),
            (DisplayMode::Fuel, fuels),
            (DisplayMode::Soot, soots),
            (DisplayMode::Neighbours, counts.collect()),
        ] {
            let sorted = |mut all: Vec<[f32; 3]>| {
                all.sort_by(|a, b| a.partial_cmp(b).unwrap());
                all
            };
            let places = fire.positions().into_iter();
            let expected = places.zip(expected).map(|(at, q)| [at.x, at.y, q]);
            let shown = shown(&fire, mode).into_iter().map(|instance| {
                let [x, y, _, _, _, volume, wider, quantity] = instance;
                assert!(
                    volume > 0.0 && (0.0..=2.0).contains(&wider),
                    "{mode:?}: {instance:?}"
                );
                [x, y, quantity]
            });
            assert_eq!(sorted(shown.collect()), sorted(expected.collect()));
        }
    }
}

/// The place of each particle \[m\], and how much wider its kernel is, in radii.
fn widened(fire: &Simulation, mode: DisplayMode) -> Vec<(Vec2, f32)> {
    let all = shown(fire, mode).into_iter();
    all.map(|instance| (Vec2::new(instance[0], instance[1]), instance[6]))
        .collect()
}

#[test]
fn kernels_are_wider_only_where_open_air_ends() {
    for mode in [
        DisplayMode::Velocity,
        DisplayMode::Vorticity,
        DisplayMode::Particles,
        DisplayMode::Neighbours,
    ] {
        let open = burn(Parameters::new(Model::Combustion), 1.0);
        let all = widened(&open, mode);
        let cell = 2.0 * open.parameters().smoothing_length();
        let farthest = all.iter().map(|(at, _)| at.x).fold(0.0, f32::max);
        let outermost = all.iter().filter(|(at, _)| at.x > farthest - 0.5 * cell);
        let (sum, count) = outermost.fold((0.0, 0), |(sum, count), particle| {
            (sum + particle.1, count + 1)
        });
        assert!(
            count > 0 && sum / count as f32 > 1.0,
            "{mode:?}: {sum} of {count}"
        );
        // The flame is far from the end of its air.
        let flame = |at: Vec2| at.x.abs() < 0.05 && (0.1..0.3).contains(&at.y);
        assert!(all.iter().any(|&(at, _)| flame(at)));
        assert!(all.iter().all(|&(at, wider)| !flame(at) || wider == 0.0));

        for closed in [
            burn(closed_box(&[]), 0.1),
            burn(Parameters::new(Model::Classic), 0.5),
        ] {
            assert!(
                widened(&closed, mode)
                    .iter()
                    .all(|&(_, wider)| wider == 0.0)
            );
        }
    }
}

#[test]
fn a_sprite_keeps_the_number_of_its_particle() {
    let mut fire = burn(Parameters::new(Model::Classic), 1.0);
    let numbers = |fire: &Simulation| {
        let sprites = shown(fire, DisplayMode::Sprites).into_iter();
        let mut numbers: Vec<_> = sprites.map(|sprite| sprite[6] as u64).collect();
        numbers.sort_unstable();
        numbers
    };
    for _ in 0..3 {
        let mut ids: Vec<_> = fire.ids().iter().map(|id| id % 4096).collect();
        ids.sort_unstable();
        assert_eq!(numbers(&fire), ids);
        fire.step();
    }
}

#[test]
fn the_volumes_of_the_instances_fill_the_gas() {
    // The paper's own factor makes densities of another kind, but no other room.
    for printed in [false, true] {
        let parameters = with([
            ("printed_kernel", Input::Flag(printed)),
            ("gas_constant", Input::Number(0.05)),
        ]);
        let fire = burn(parameters, 0.5);
        let room: f32 = shown(&fire, DisplayMode::Fuel).iter().map(|i| i[5]).sum();
        let each = room / fire.count() as f32;
        let h = fire.parameters().smoothing_length();
        assert!((0.02..2.3).contains(&(each / (h * h))), "{each} m²");
    }
}

#[test]
fn displays_do_not_change_a_fire() {
    for parameters in [combustion(&[]), Scene::of_model(Model::Classic)] {
        let mut left = Simulation::new(parameters.clone());
        let mut watched = Simulation::new(parameters);
        let mut instances = Vec::new();
        for (step, name) in DisplayMode::NAMES.iter().cycle().take(60).enumerate() {
            assert_eq!(watched.set("display_mode", Input::Text(name)), Ok(()));
            left.step();
            watched.step();
            watched.write_instances(&mut instances);
            assert_eq!(left.particles(), watched.particles(), "step {step}");
        }
    }
}

#[test]
fn a_distance_is_that_from_the_nearest_solid_or_floor() {
    let open = [("edges", "open"), ("floor", "solid")];
    for (model, choices, has_floor) in [
        (Model::Combustion, &[("edges", "periodic")][..], false),
        (Model::Combustion, &open[..], true),
        (Model::Classic, &[("walls", "solid")][..], true),
        (Model::Classic, &[("walls", "open")][..], false),
    ] {
        let mut settings = Parameters::new(model);
        for &(id, name) in choices {
            assert_eq!(settings.set(id, Input::Text(name)), Ok(()));
        }
        let farthest = Simulation::new(settings.clone()).extent();
        let farthest = farthest[0].distance(farthest[1]);
        for solids in [0, 2] {
            let mut scene = Scene::new(settings.clone());
            for x in [-0.3, 0.2].into_iter().take(solids) {
                let fields = [
                    ("kind", Input::Text("solid")),
                    ("x", Input::Number(x)),
                    ("y", Input::Number(0.4)),
                ];
                assert!(scene.add(&fields).is_ok());
            }
            let mut fire = Simulation::new(scene);
            while fire.time() < 0.1 {
                fire.step();
            }
            let shown = shown(&fire, DisplayMode::Distance);
            assert!(!shown.is_empty());
            for [x, y, _, _, _, _, _, distance] in shown {
                let floor = if has_floor { y } else { farthest };
                let at = Vec2::new(x, y);
                let solids = fire.scene().solids().map(|surface| surface.distance(at).0);
                let expected = solids.fold(floor, f32::min);
                // At an edge, the image of a solid may be nearer.
                if (at - Vec2::new(0.0, 0.4)).abs().max_element() < 0.4 {
                    assert!((distance - expected).abs() < 1e-6, "{distance} at {at}");
                }
            }
        }
    }
}
