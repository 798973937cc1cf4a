//! A probe measures the gas that is there: temperature, velocity, fuel, oxygen and soot at a place and along
//! the vertical through it, and the height and the light of the flame. Measuring changes nothing.

use hearth_core::params::{Input, Model};
use hearth_core::{Parameters, Simulation, Vec2};
use hearth_tests::fires::{burn, closed_box, combustion, filled, in_the_open, on_floor, source};

/// Numbers of the fire, and of each place.
const OF_FIRE: usize = 6;
const OF_PLACE: usize = 8;

/// What is measured at the places of a column, the place itself first.
fn places(numbers: &[f32]) -> Vec<&[f32]> {
    numbers[OF_FIRE..].chunks(OF_PLACE).collect()
}

fn close(found: f32, expected: f32, off: f32) {
    assert!((found - expected).abs() <= off, "{found}, not {expected}");
}

#[test]
fn a_linear_field_is_read_where_the_probe_is() {
    let shape = |particle: &mut hearth_core::Particle| {
        let Vec2 { x, y } = particle.position;
        particle.temperature = 300.0 + 500.0 * y;
        particle.velocity = Vec2::new(2.0 * y, -x);
        particle.oxygen = 0.5;
        particle.lifetime = 9.0;
    };
    let fire = filled(closed_box(&[]), 32, shape);
    let [width, height] = [
        fire.parameters().domain_width,
        fire.parameters().domain_height,
    ];
    for place in [
        Vec2::new(0.0, 0.5 * height),
        Vec2::new(0.2 * width, 0.3 * height),
    ] {
        let numbers = fire.measure(place);
        let read = places(&numbers);
        assert_eq!(read.len(), 65);
        close(read[0][0], 300.0 + 500.0 * place.y, 3.0);
        close(read[0][1], 2.0 * place.y, 0.02);
        close(read[0][2], -place.x, 0.02);
        for (row, at) in read[1..].iter().enumerate().skip(8).take(48) {
            let y = height * (row as f32 + 0.5) / 64.0;
            close(at[0], 300.0 + 500.0 * y, 3.0);
        }
    }
}

#[test]
fn still_air_has_the_air_temperature_and_a_flame_is_hot() {
    let parameters = on_floor(in_the_open(
        combustion(&[("ambient_temperature", 281.0)]),
        2000,
    ));
    let mut fire = burn(parameters, 1.5);
    let far = fire.measure(Vec2::new(0.55, 1.7));
    let at = places(&far)[0];
    close(at[0], 281.0, 3.0);
    close(at[3], fire.parameters().ambient_density, 0.15);
    for (found, expected) in at[4..7].iter().zip([0.0, 1.0, 0.0]) {
        close(*found, expected, 1e-3);
    }
    // What is beyond the gas that the fire moves rests.
    let away = fire.measure(Vec2::new(0.0, 900.0));
    assert_eq!(places(&away)[0][..3], [281.0, fire.parameters().wind, 0.0]);

    // The mean over a second: a flame turns.
    let base = source(fire.scene()).y;
    let (mut numbers, mut flame, mut looks) = (Vec::new(), [0.0; OF_PLACE], 0.0);
    while fire.time() < 2.5 {
        fire.step();
        numbers = fire.measure(Vec2::new(0.0, base + 0.3));
        for (sum, number) in flame.iter_mut().zip(places(&numbers)[0]) {
            *sum += number;
        }
        looks += 1.0;
    }
    let flame = flame.map(|sum| sum / looks);
    assert!(flame[0] > 1000.0, "{flame:?}");
    assert!(flame[2] > 0.5, "it rises: {flame:?}");
    assert!(flame[3] < 0.6 * at[3], "it is light: {flame:?}");
    assert!(flame[5] < 0.9, "oxygen is used: {flame:?}");
    let column = &places(&numbers)[1..];
    let hottest = column.iter().map(|at| at[0]).fold(0.0, f32::max);
    assert!(hottest > 1000.0 && hottest > column[63][0] + 300.0);
}

#[test]
fn the_flame_has_the_height_power_and_light_of_its_gas() {
    let fire = burn(combustion(&[]), 1.0);
    let numbers = fire.measure(Vec2::ZERO);
    let hot = || {
        let all = fire.positions().into_iter().zip(fire.temperatures());
        all.filter(|(_, temperature)| *temperature > 900.0)
    };
    let high = hot().map(|(at, _)| at.y).fold(f32::MIN, f32::max);
    let low = hot().map(|(at, _)| at.y).fold(f32::MAX, f32::min);
    assert_eq!(numbers[0] + numbers[1], fire.time() as f32);
    assert_eq!(numbers[2], fire.parameters().domain_height);
    assert_eq!(Some(numbers[3]), fire.power());
    assert_eq!(numbers[4], high - low);
    let area = fire.parameters().domain_width * fire.parameters().domain_height;
    assert!(numbers[5] > 0.001 && numbers[5] < area, "{}", numbers[5]);
    let cold = Simulation::new(combustion(&[])).measure(Vec2::ZERO);
    assert_eq!(cold[4..6], [0.0, 0.0]);
}

#[test]
fn nothing_is_read_that_is_not_there() {
    let classic = burn(Parameters::new(Model::Classic), 1.0);
    let numbers = classic.measure(Vec2::new(0.0, 0.2));
    let at = places(&numbers)[0];
    assert!(
        at[0] > 1000.0 && at[..4].iter().all(|number| number.is_finite()),
        "{at:?}"
    );
    assert!(at[4..7].iter().all(|number| number.is_nan()), "{at:?}");
    assert!(numbers[3].is_nan() && numbers[4] > 0.1 && numbers[5] > 0.0);
    let empty = classic.measure(Vec2::new(0.59, 1.79));
    assert!(places(&empty)[0][..7].iter().all(|number| number.is_nan()));

    let mut scene = on_floor(in_the_open(combustion(&[]), 2000));
    let fields = [
        ("kind", Input::Text("solid")),
        ("shape", Input::Text("box")),
        ("x", Input::Number(0.3)),
        ("y", Input::Number(0.6)),
        ("width", Input::Number(0.2)),
        ("height", Input::Number(0.2)),
    ];
    assert!(scene.add(&fields).is_ok());
    let fire = Simulation::new(scene);
    for place in [Vec2::new(0.3, 0.6), Vec2::new(0.0, -0.2)] {
        let numbers = fire.measure(place);
        assert!(
            places(&numbers)[0][..7]
                .iter()
                .all(|number| number.is_nan()),
            "{place}"
        );
    }
    let numbers = fire.measure(Vec2::new(0.3, 0.6));
    close(places(&numbers)[0][7], -0.1, 1e-4);
    close(places(&numbers)[64][0], 293.0, 0.1);
}

#[test]
fn measuring_changes_nothing() {
    let mut fires = [0, 1].map(|_| burn(combustion(&[]), 0.3));
    fires[0].measure(Vec2::new(0.1, 0.4));
    for fire in &mut fires {
        fire.step();
    }
    assert_eq!(fires[0].positions(), fires[1].positions());
    assert_eq!(fires[0].temperatures(), fires[1].temperatures());
}
