use super::*;
use crate::bounds::Bounds;
use crate::combustion::gas::{periodic_bounds, tests::scene_with as with};
use crate::params::Input;
use crate::random::Random;
use crate::scene::{Scene, SceneSource};
use crate::solids::Solids;

fn source(scene: &Scene) -> SceneSource<'_> {
    scene.first_source().expect("a source")
}

fn fed(scene: &Scene, seconds: f32) -> Option<Gas> {
    let spacing = scene.world().spacing();
    let mut gas = Gas::air(scene.world(), spacing, &mut Random::new(1));
    Burner::new(&source(scene), spacing)?.feed(
        &mut gas,
        &source(scene),
        (0.4, seconds),
        &[],
        &mut Vec::new(),
    );
    Some(gas)
}

#[test]
fn its_power_is_exact_at_any_width_resolution_and_noise() {
    for (n, width, noise) in [
        (1000.0, 0.4, 0.0),
        (12_000.0, 0.4, 1.0),
        (3000.0, 1.0, 0.5),
        (3000.0, 0.01, 0.2),
    ] {
        let scene = with(&[
            ("particles", n),
            ("source_width", width),
            ("emission_noise", noise),
        ]);
        let seconds = 1e-3;
        let gas = fed(&scene, seconds).expect("a burner");
        let fuel: f32 = gas.state.iter().map(|state| state.y * gas.mass).sum();
        let power = fuel * heat_of_combustion(scene.world()) / seconds;
        assert!(
            (power / source(&scene).power - 1.0).abs() < 1e-3,
            "{power} at {n}, {width}, {noise}"
        );
    }
}

#[test]
fn it_may_be_turned_and_keeps_its_power() {
    for angle in [-180.0, -90.0, -37.0, 15.0, 90.0, 140.0] {
        let scene = with(&[
            ("particles", 12_000.0),
            ("source_height", 0.8),
            ("source_angle", angle),
        ]);
        let seconds = 1e-3;
        let gas = fed(&scene, seconds).expect("a burner");
        let fuel = |i: usize| gas.state[i].y * gas.mass;
        let all: f32 = (0..gas.len()).map(fuel).sum();
        let power = all * heat_of_combustion(scene.world()) / seconds;
        assert!(
            (power / source(&scene).power - 1.0).abs() < 1e-3,
            "{power} at {angle}°"
        );
        // It lies on the side to which it emits, within its height of three spacings.
        let out = Vec2::from_angle((angle as f32).to_radians()).perp();
        let burner = Burner::of(&source(&scene));
        let [low, high] = burner.around();
        for i in (0..gas.len()).filter(|&i| fuel(i) > 0.0) {
            let at = gas.position[i];
            let depth = (at - Vec2::new(burner.middle, burner.bottom)).dot(out);
            assert!(
                (0.0..3.01 * scene.world().spacing()).contains(&depth),
                "{depth}"
            );
            assert!(at.cmpge(low - 1e-4).all() && at.cmple(high + 1e-4).all());
            let speed = gas.velocity[i].dot(out);
            assert!(speed > 0.3 * source(&scene).speed, "{speed} m/s");
        }
    }
}

#[test]
fn its_noise_moves_with_it() {
    // The fuel by the distance from the middle of the burner.
    let fuel = |x: f64| {
        let values = [("source_x", x), ("emission_noise", 1.0)];
        let scene = with(&[&values[..], &[("particles", 50_000.0)]].concat());
        let gas = fed(&scene, 1e-3).expect("a burner");
        let middle = Burner::of(&source(&scene)).middle;
        assert!((f64::from(middle) - x).abs() < 1e-6);
        let mut parts = [(0.0_f32, 0.0_f32); 10];
        for (position, state) in gas.position.iter().zip(&gas.state) {
            let across = (position.x - middle) / source(&scene).width + 0.5;
            if state.y > 0.0 {
                let (sum, n) = &mut parts[(across * 10.0) as usize];
                *sum += state.y;
                *n += 1.0;
            }
        }
        parts.map(|(sum, n)| sum / n)
    };
    let there = fuel(0.0);
    for x in [-0.25, 0.3] {
        for (here, there) in fuel(x).into_iter().zip(there) {
            assert!((here / there - 1.0).abs() < 0.1, "{here}, {there} at {x}");
        }
    }
}

#[test]
fn without_power_there_is_no_burner() {
    assert!(fed(&with(&[("fuel_power", 0.0)]), 1e-3).is_none());
}

#[test]
fn its_gas_is_above_the_ignition_temperature() {
    let scene = with(&[
        ("source_temperature", 500.0),
        ("ignition_temperature", 900.0),
    ]);
    let gas = fed(&scene, 1e-3).expect("a burner");
    assert!(
        gas.state
            .iter()
            .any(|state| state.x > scene.world().ignition_temperature)
    );
}

#[test]
fn it_stays_between_the_seams() {
    for (height, seam) in [(0.0, 0.2), (1.0, 0.2), (1.0, 0.0)] {
        let scene = with(&[
            ("source_height", height),
            ("seam", seam),
            ("domain_height", 0.5),
        ]);
        let burner = Burner::new(&source(&scene), scene.world().spacing()).expect("a burner");
        let thickness = scene.world().seam * scene.world().domain_height;
        assert!(burner.bottom >= thickness - 1e-6);
        assert!(burner.top <= scene.world().domain_height - thickness + 1e-6);
    }
}

#[test]
fn excess_fuel_goes_to_the_gas_above() {
    // In a quarter of a second, far more fuel than the capacity of the block.
    for n in [1000.0, 3000.0, 20_000.0] {
        let scene = with(&[
            ("fuel_power", 600.0),
            ("source_width", 0.1),
            ("emission_noise", 0.0),
            ("particles", n),
        ]);
        let gas = fed(&scene, 0.25).expect("a burner");
        let fuel: f32 = gas.state.iter().map(|state| state.y * gas.mass).sum();
        let expected = 600.0 / heat_of_combustion(scene.world()) * 0.25;
        assert!((fuel / expected - 1.0).abs() < 1e-3, "{fuel} of {expected}");
        assert!(gas.state.iter().all(|state| state.y <= 1.0));
    }
}

#[test]
fn its_gas_has_the_oxygen_of_the_parameter() {
    for oxygen in [0.0, 0.4, 1.0] {
        let gas = fed(&with(&[("source_oxygen", oxygen)]), 1e-3).expect("a burner");
        let inside = gas.state.iter().filter(|state| state.y > 0.0);
        let max = inside.map(|state| state.z).fold(0.0, f32::max);
        assert!((f64::from(max) - oxygen).abs() < 1e-6);
    }
}

/// The solids of every shape: name, number properties, and text properties.
const SHAPES: [(&str, &str, &str); 6] = [
    ("circle", "", ""),
    ("box", "", ""),
    ("line", "", ""),
    (
        "polygon",
        "points",
        "0,0.15 -0.09,-0.12 0.14,0.04 -0.14,0.04 0.09,-0.12",
    ),
    ("stroke", "points", "-0.1,0.1 0.1,0 -0.05,-0.1"),
    ("mask", "mask", "8x4:3PSqSo"),
];

/// A scene with a solid on which its source is.
fn on_solid(scene: &Scene, place: [f64; 3], (shape, outline, text): (&str, &str, &str)) -> Scene {
    let mut scene = scene.clone();
    assert_eq!(scene.set("source_shape", "solid"), Ok(()));
    assert_eq!(scene.set("source_solid", 7.0), Ok(()));
    let mut fields = vec![
        ("kind", Input::Text("solid")),
        ("id", Input::Number(7.0)),
        ("shape", Input::Text(shape)),
        ("x", Input::Number(place[0])),
        ("y", Input::Number(place[1])),
        ("angle", Input::Number(place[2])),
    ];
    fields.extend((!outline.is_empty()).then_some((outline, Input::Text(text))));
    assert_eq!(scene.add(&fields), Ok(7));
    scene
}

/// Air that the source of a scene has fed, and the heat of the fuel in it [kW/m].
fn fed_on_solid(scene: &Scene, bounds: &Bounds, seconds: f32) -> (Gas, f32) {
    let values = scene.world();
    let spacing = values.spacing();
    let mut gas = Gas::air(values, spacing, &mut Random::new(1));
    let solids = Solids::of(scene, bounds, 3.0 * spacing);
    let source = source(scene);
    let parts = solids.parts(&source);
    assert!(!parts.is_empty());
    let burner = Burner::new(&source, spacing).expect("a burner");
    burner.feed(&mut gas, &source, (0.4, seconds), parts, &mut Vec::new());
    let fuel: f32 = gas.state.iter().map(|state| state.y * gas.mass).sum();
    let power = fuel * heat_of_combustion(values) / seconds;
    (gas, power)
}

#[test]
fn on_a_solid_it_keeps_its_power_and_burns_at_the_surface_alone() {
    for shape in SHAPES {
        // The last one crosses a periodic edge, so that half of it is an image.
        for place in [[0.0, 0.9, 0.0], [0.2, 0.6, 37.0], [-0.6, 1.2, -140.0]] {
            for noise in [0.0, 1.0] {
                let scene = with(&[("particles", 12_000.0), ("emission_noise", noise)]);
                let scene = on_solid(&scene, place, shape);
                let bounds = periodic_bounds(scene.world());
                let (gas, power) = fed_on_solid(&scene, &bounds, 1e-3);
                assert!(
                    (power / source(&scene).power - 1.0).abs() < 1e-3,
                    "{power} kW/m on {shape:?} at {place:?}"
                );
                let solids = Solids::of(&scene, &bounds, 3.0 * scene.world().spacing());
                let thickness = HEIGHT_ROWS * scene.world().spacing();
                for (state, &position) in gas.state.iter().zip(&gas.position) {
                    let distances = solids
                        .bodies
                        .iter()
                        .map(|body| body.surface.distance(position).0);
                    let distance = distances.fold(f32::MAX, f32::min);
                    let is_beside = distance > 0.0 && distance <= thickness;
                    // Noise may leave a particle without fuel, but not without heat.
                    let is_hot = state.x > scene.world().ignition_temperature;
                    assert_eq!(is_hot, is_beside, "{distance} m from {shape:?}");
                    assert!(is_beside || state.y == 0.0);
                }
            }
        }
    }
}

#[test]
fn on_a_solid_excess_fuel_goes_to_the_gas_farther_from_it() {
    let scene = with(&[("fuel_power", 600.0), ("emission_noise", 0.0)]);
    let scene = on_solid(&scene, [0.0, 0.9, 0.0], SHAPES[0]);
    let (gas, power) = fed_on_solid(&scene, &periodic_bounds(scene.world()), 1.0);
    assert!((power / 600.0 - 1.0).abs() < 1e-3, "{power} kW/m");
    let (_, surface) = scene.solid_of(&source(&scene)).expect("a surface");
    let fuelled = gas
        .state
        .iter()
        .zip(&gas.position)
        .filter(|(state, _)| state.y > 0.0);
    let distances = fuelled.map(|(_, &position)| surface.distance(position).0);
    let (near, far) = distances.fold((f32::MAX, 0.0_f32), |(near, far), distance| {
        (near.min(distance), far.max(distance))
    });
    assert!(
        near > 0.0 && far > HEIGHT_ROWS * scene.world().spacing(),
        "{near} to {far} m"
    );
    assert!(gas.state.iter().all(|state| state.y <= 1.0));
}

#[test]
fn on_a_solid_it_leaves_the_velocity_of_the_gas() {
    let scene = with(&[("emission_speed", 1.5)]);
    let scene = on_solid(&scene, [0.0, 0.9, 0.0], SHAPES[0]);
    let (gas, _) = fed_on_solid(&scene, &periodic_bounds(scene.world()), 1e-3);
    assert!(gas.velocity.iter().all(|velocity| *velocity == Vec2::ZERO));
}

#[test]
fn without_gas_around_the_solid_no_fuel_flows() {
    let scene = with(&[]);
    let scene = on_solid(&scene, [9.0, 9.0, 0.0], SHAPES[0]);
    let (_, power) = fed_on_solid(&scene, &periodic_bounds(scene.world()), 1e-3);
    assert_eq!(power, 0.0);
}
