//! Laws of sources on solids: the whole outline burns, wherever the solid is.

use hearth_core::params::{Input, Model};
use hearth_core::{Scene, Simulation, Vec2};
use hearth_tests::fires::{burn_on, combustion, in_the_open, mean, watch, with_numbers};

/// The id of the solid.
const ID: u32 = 5;

/// A scene with its source on a solid with these numbers.
fn on_solid(mut scene: Scene, shape: &str, numbers: &[(&str, f64)]) -> Scene {
    let solid = f64::from(ID);
    assert_eq!(scene.set("source_shape", "solid"), Ok(()));
    assert_eq!(scene.set("source_solid", solid), Ok(()));
    let mut fields = vec![
        ("kind", Input::Text("solid")),
        ("id", Input::Number(solid)),
        ("shape", Input::Text(shape)),
    ];
    fields.extend(numbers.iter().map(|&(name, x)| (name, Input::Number(x))));
    assert_eq!(scene.add(&fields), Ok(ID));
    scene
}

fn change(fire: &mut Simulation, numbers: &[(&str, f64)]) {
    let mut scene = fire.scene().clone();
    let fields = numbers.iter().map(|&(name, x)| (name, Input::Number(x)));
    assert_eq!(scene.change(ID, &fields.collect::<Vec<_>>()), Ok(()));
    fire.set_scene(scene);
}

/// Height above the lowest burning gas beyond which the flame wanders \[m\].
const STEADY: f32 = 0.3;

/// Mean place of the foot of the flame and its lowest height \[m\].
fn burning(fire: &Simulation) -> (Vec2, f32) {
    let hot = fire.positions().into_iter().zip(fire.temperatures());
    let hot: Vec<Vec2> = hot
        .filter(|particle| particle.1 > 900.0)
        .map(|particle| particle.0)
        .collect();
    let lowest = hot.iter().map(|at| at.y).fold(f32::MAX, f32::min);
    let hot: Vec<_> = hot
        .into_iter()
        .filter(|at| at.y < lowest + STEADY)
        .collect();
    assert!(!hot.is_empty());
    (hot.iter().sum::<Vec2>() / hot.len() as f32, lowest)
}

/// The means of [`burning`] over a second: the foot of a flame wanders by the width of its solid.
fn mean_of_burning(fire: &mut Simulation) -> (Vec2, f32) {
    const INSTANTS: u8 = 20;
    let (mut middle, mut lowest) = (Vec2::ZERO, 0.0);
    for _ in 0..INSTANTS {
        burn_on(fire, 1.0 / f64::from(INSTANTS));
        let now = burning(fire);
        middle += now.0 / f32::from(INSTANTS);
        lowest += now.1 / f32::from(INSTANTS);
    }
    (middle, lowest)
}

/// Mean power over so many seconds [kW/m].
fn power(fire: &mut Simulation, seconds: f64) -> f64 {
    let (mut heat, mut length) = (0.0, 0.0);
    watch(fire, seconds, |fire| {
        heat += f64::from(fire.power().unwrap_or_default()) * fire.step_length();
        length += fire.step_length();
    });
    heat / length
}

/// A closed domain and open air.
fn in_both_edges(values: &[(&str, f64)]) -> [Scene; 2] {
    let closed = combustion(values);
    [closed.clone(), in_the_open(closed, 3000)]
}

#[test]
fn a_fire_on_a_solid_has_its_power_and_moves_with_the_solid() {
    for settings in in_both_edges(&[("fuel_power", 100.0), ("ember_rate", 0.0)]) {
        let edges = settings.world().edges;
        let place = [("x", -0.2), ("y", 0.5), ("width", 0.3), ("angle", 20.0)];
        let mut fire = Simulation::new(on_solid(settings, "line", &place));
        burn_on(&mut fire, 1.0);
        // Some fuel is always on its way, and some leaves unburnt.
        let there = power(&mut fire, 2.0);
        assert!((90.0..=103.0).contains(&there), "{there} kW/m, {edges:?}");
        let (middle, lowest) = mean_of_burning(&mut fire);
        // A flame leans, but it is nearer to this place than to the other one.
        assert!((middle.x + 0.2).abs() < 0.2, "{middle}, {edges:?}");
        assert!((lowest - 0.5).abs() < 0.15, "{lowest} m, {edges:?}");

        change(&mut fire, &[("x", 0.2), ("y", 0.8), ("angle", -50.0)]);
        burn_on(&mut fire, 1.5);
        let here = power(&mut fire, 2.0);
        assert!((90.0..=103.0).contains(&here), "{here} kW/m, {edges:?}");
        let (middle, lowest) = mean_of_burning(&mut fire);
        assert!((middle.x - 0.2).abs() < 0.2, "{middle}, {edges:?}");
        assert!((lowest - 0.8).abs() < 0.15, "{lowest} m, {edges:?}");
    }
}

#[test]
fn no_gas_and_so_no_fuel_is_inside_of_the_solid() {
    for settings in in_both_edges(&[("fuel_power", 200.0)]) {
        let mut fire = Simulation::new(on_solid(settings, "box", &[("y", 0.4), ("angle", 30.0)]));
        watch(&mut fire, 1.0, |fire| {
            let (.., surface) = fire.scene().surfaces().next().expect("a solid");
            let inside = |at: &Vec2| surface.distance(*at).0 <= 0.0;
            assert!(!fire.positions().iter().any(inside));
        });
        assert!(
            fire.fuels()
                .unwrap_or_default()
                .iter()
                .any(|fuel| *fuel > 0.01)
        );
    }
}

#[test]
fn a_source_on_a_solid_that_does_not_exist_is_its_line() {
    for (model, settings) in [
        (Model::Combustion, combustion(&[("source_x", 0.1)])),
        (Model::Classic, with_numbers(&[("source_x", 0.1)])),
    ] {
        let mut line = Simulation::new(settings.clone());
        let mut missing = on_solid(settings, "circle", &[]);
        assert_eq!(missing.remove(ID), Ok(()));
        let mut missing = Simulation::new(missing);
        for _ in 0..60 {
            line.step();
            missing.step();
        }
        assert!(line.count() > 0);
        assert_eq!(line.positions(), missing.positions(), "{model:?}");
        assert_eq!(line.temperatures(), missing.temperatures(), "{model:?}");
    }
}

#[test]
fn a_fire_follows_a_solid_that_sways_by_itself() {
    for settings in in_both_edges(&[("fuel_power", 100.0), ("ember_rate", 0.0)]) {
        let edges = settings.world().edges;
        let place = [("y", 0.5), ("sway", 0.3), ("period", 6.0)];
        let mut scene = on_solid(settings, "circle", &place);
        let sways = [("motion", Input::Text("sway"))];
        assert_eq!(scene.change(ID, &sways), Ok(()));
        let mut fire = Simulation::new(scene);
        // At a turning point it is slow, so that its flame is upright.
        for (until, x) in [(1.5, 0.3), (4.5, -0.3)] {
            let seconds = until - fire.time();
            burn_on(&mut fire, seconds);
            let (middle, lowest) = burning(&fire);
            assert!((middle.x - x).abs() < 0.15, "{middle}, {edges:?}");
            assert!(lowest > 0.25, "{lowest} m, {edges:?}");
        }
    }
}

#[test]
fn two_sources_on_one_solid_add_up() {
    let settings = combustion(&[("fuel_power", 50.0), ("ember_rate", 0.0)]);
    let mut scene = on_solid(settings, "circle", &[("y", 0.5)]);
    let added = scene.add(&[
        ("kind", Input::Text("source")),
        ("shape", Input::Text("solid")),
        ("solid", Input::Number(ID.into())),
        ("power", Input::Number(50.0)),
    ]);
    assert!(added.is_ok(), "{added:?}");
    let mut fire = Simulation::new(scene);
    burn_on(&mut fire, 1.0);
    let power = power(&mut fire, 2.0);
    assert!((90.0..=103.0).contains(&power), "{power} kW/m");
}

#[test]
fn a_solid_out_of_reach_neither_burns_nor_stops_the_fire() {
    for settings in in_both_edges(&[]) {
        let mut fire = Simulation::new(on_solid(settings, "circle", &[("x", 9.0)]));
        burn_on(&mut fire, 0.5);
        assert!(fire.temperatures().iter().all(|kelvin| *kelvin < 300.0));
        change(&mut fire, &[("x", 0.0)]);
        burn_on(&mut fire, 1.0);
        let (middle, _) = burning(&fire);
        assert!(middle.x.abs() < 0.2, "{middle}");
    }
}

#[test]
fn classic_particles_are_born_along_the_whole_outline_and_leave_it() {
    let values = [
        ("lifetime_min", 0.1),
        ("lifetime_max", 0.1),
        ("gravity", 0.0),
        ("buoyancy", 0.0),
        ("thermal_buoyancy", 0.0),
        ("emission_spread", 0.0),
        ("emission_noise", 0.0),
    ];
    for shape in ["circle", "box"] {
        let place = [("y", 0.7), ("width", 0.3), ("height", 0.3), ("angle", 25.0)];
        let mut fire = Simulation::new(on_solid(with_numbers(&values), shape, &place));
        let mut sides = [0_u32; 4];
        let mut births = 0;
        watch(&mut fire, 3.0, |fire| {
            let (.., surface) = fire.scene().surfaces().next().expect("a solid");
            let dt = fire.parameters().time_step;
            let born = fire
                .particles()
                .into_iter()
                .filter(|particle| particle.age <= 1.5 * dt);
            for particle in born {
                let (distance, normal) = surface.distance(particle.position);
                assert!((0.0..0.02).contains(&distance), "{distance} m, {shape}");
                assert!(particle.velocity.dot(normal) > 0.0, "{shape}");
                let local = surface.frame.local(particle.position);
                let side = usize::from(local.x.abs() > local.y.abs());
                let far = if side == 1 { local.x } else { local.y };
                sides[2 * side + usize::from(far > 0.0)] += 1;
                births += 1;
            }
        });
        // Five standard deviations of a binomial count would be wider.
        let quarter = births / 4;
        assert!(births > 500, "{births} births, {shape}");
        for side in sides {
            assert!(side.abs_diff(quarter) < births / 20, "{sides:?}, {shape}");
        }
    }
}

#[test]
fn a_classic_fire_on_a_solid_moves_with_it() {
    let mut fire = Simulation::new(on_solid(
        with_numbers(&[]),
        "circle",
        &[("x", -0.2), ("y", 0.3)],
    ));
    burn_on(&mut fire, 1.5);
    let middle = |fire: &Simulation| mean(fire.positions().into_iter().map(|at| at.x));
    assert!((middle(&fire) + 0.2).abs() < 0.1, "{}", middle(&fire));
    change(&mut fire, &[("x", 0.2)]);
    burn_on(&mut fire, 2.0);
    assert!((middle(&fire) - 0.2).abs() < 0.1, "{}", middle(&fire));
}

#[test]
fn the_same_seed_gives_the_same_bits() {
    for settings in [combustion(&[]), with_numbers(&[])] {
        let scene = on_solid(settings, "box", &[("y", 0.4), ("angle", 10.0)]);
        let mut fires = [Simulation::new(scene.clone()), Simulation::new(scene)];
        for fire in &mut fires {
            burn_on(fire, 0.5);
        }
        assert_eq!(fires[0].particles(), fires[1].particles());
    }
}
