//! Laws of solids that burn: what they give off is what they lose, and fire spreads by the
//! equations.

use hearth_core::params::Input;
use hearth_core::{BurningSolid, BurningState, IgnitionTarget, Scene, Simulation, Vec2};
use hearth_tests::fires::{burn_on, closed_box, combustion, in_the_open, watch};

/// The id of the solid.
const ID: u32 = 2;

/// Open air without a source.
fn open(values: &[(&str, f64)]) -> Scene {
    let unlit = [("fuel_power", 0.0), ("ember_rate", 0.0)];
    let mut scene = in_the_open(combustion(&[&unlit, values].concat()), 5000);
    assert_eq!(scene.set("spacing", 0.03), Ok(()));
    scene
}

/// A scene with a solid of that shape and fuel.
fn with_solid(mut scene: Scene, shape: &str, fuel: &str, numbers: &[(&str, f64)]) -> Scene {
    let mut fields = vec![
        ("kind", Input::Text("solid")),
        ("shape", Input::Text(shape)),
        ("fuel", Input::Text(fuel)),
    ];
    fields.extend(numbers.iter().map(|&(name, x)| (name, Input::Number(x))));
    assert_eq!(scene.add(&fields), Ok(ID));
    scene
}

fn solid(fire: &Simulation) -> BurningSolid {
    let all = fire.burning_solids();
    assert_eq!(all.len(), 1);
    all[0]
}

/// Whether two quantities are the same within 1 % of the larger.
fn within_a_percent(first: f64, second: f64) -> bool {
    (first - second).abs() <= 0.01 * first.abs().max(second.abs())
}

/// A strip of paper, 0.6 m long, at that angle.
fn strip(values: &[(&str, f64)], angle: f64, moisture: f64) -> Simulation {
    let numbers = [
        ("y", 0.5),
        ("width", 0.6),
        ("height", 0.02),
        ("angle", angle),
        ("load", 0.5),
        ("moisture", moisture),
    ];
    Simulation::new(with_solid(open(values), "line", "paper", &numbers))
}

/// The share of a strip that has burnt so many seconds after it was lit at a place.
fn spread(mut fire: Simulation, place: Vec2, seconds: f64) -> f64 {
    burn_on(&mut fire, 0.2);
    assert_eq!(fire.ignite(IgnitionTarget::Place(place, 0.0)), Ok(()));
    burn_on(&mut fire, seconds);
    let solid = solid(&fire);
    1.0 - solid.fuel / solid.first
}

const SEEDS: [f64; 3] = [1.0, 2.0, 3.0];
const LEFT: Vec2 = Vec2::new(-0.3, 0.5);
const BOTTOM: Vec2 = Vec2::new(0.0, 0.2);
const TOP: Vec2 = Vec2::new(0.0, 0.8);

#[test]
fn what_a_solid_gives_off_is_what_it_loses() {
    for (fuel, load) in [
        ("wood", 2.0),
        ("paper", 0.5),
        ("coal", 4.0),
        ("wax", 2.0),
        ("cloth", 0.5),
    ] {
        let numbers = [("y", 0.4), ("width", 0.3), ("height", 0.1), ("load", load)];
        let mut fire = Simulation::new(with_solid(open(&[]), "box", fuel, &numbers));
        burn_on(&mut fire, 0.2);
        let before = solid(&fire);
        // 0.3 m × 0.1 m of that load, and 8 % of water.
        assert!(
            within_a_percent(before.first, 0.03 * load),
            "{fuel}: {before:?}"
        );
        assert!(
            within_a_percent(before.water, 0.08 * before.first),
            "{fuel}"
        );
        assert_eq!(fire.ignite(IgnitionTarget::Object(ID)), Ok(()));
        burn_on(&mut fire, 5.0);
        let after = solid(&fire);
        assert!(after.gas > 0.2 * after.first, "{fuel}: {after:?}");
        let mass = after.fuel + after.char + after.gas + after.oxidised + after.fallen;
        assert!(within_a_percent(mass, after.first), "{fuel}: {after:?}");
        assert!(
            within_a_percent(after.water + after.steam, before.water),
            "{fuel}"
        );
        let heat = after.stored + after.lost;
        assert!(within_a_percent(heat, after.gained), "{fuel}: {after:?}");
    }
}

#[test]
fn the_gas_gets_the_fuel_and_the_heat_that_a_solid_loses() {
    // No gas leaves, radiates or burns: what is given off stays fuel.
    let scene = closed_box(&[("ignition_temperature", 900.0)]);
    let numbers = [("y", 0.4), ("width", 0.2), ("load", 5.0), ("moisture", 0.0)];
    let mut fire = Simulation::new(with_solid(scene, "circle", "wood", &numbers));
    let area = 0.64 - 0.01 * std::f64::consts::PI;
    let density = f64::from(fire.parameters().ambient_density);
    let particle = density * area / fire.count() as f64;
    let sum = |all: Vec<f32>| all.into_iter().map(f64::from).sum::<f64>();
    let heat = |fire: &Simulation| particle * sum(fire.temperatures());
    let before = heat(&fire);
    assert_eq!(fire.ignite(IgnitionTarget::Object(ID)), Ok(()));
    // The pilot heats gas beside the solid too.
    let piloted = heat(&fire) - before;
    let mut burnt = 0.0;
    watch(&mut fire, 1.0, |fire| {
        burnt += f64::from(fire.power().unwrap_or_default()) * fire.step_length();
    });
    let solid = solid(&fire);
    let values = fire.parameters();
    let per_kilogram = f64::from(values.flame_rise * (1.0 + values.air_demand));
    let fuel = particle * sum(fire.fuels().unwrap_or_default()) * per_kilogram;
    assert!(solid.gas > 0.0);
    // Combustion heats the gas and, in the film at the surface, the solid.
    assert!(
        within_a_percent(fuel + burnt, solid.gas_heat),
        "{fuel} kJ/m in the gas, {burnt} burnt, {solid:?}"
    );
    // What the gas lost, the solid got.
    let lost = before + piloted + burnt - solid.flames - heat(&fire);
    assert!(
        (lost - solid.exchanged).abs() < 0.01 * solid.exchanged.abs().max(solid.gained),
        "{lost} kJ/m lost, {burnt} burnt, {solid:?}"
    );
}

#[test]
fn fire_spreads_faster_upward_than_downward() {
    for seed in SEEDS {
        let up = spread(strip(&[("seed", seed)], 90.0, 8.0), BOTTOM, 1.5);
        let down = spread(strip(&[("seed", seed)], 90.0, 8.0), TOP, 1.5);
        assert!(up > 1.5 * down, "{up} upward, {down} downward, seed {seed}");
    }
}

#[test]
fn fire_spreads_faster_with_the_wind() {
    for seed in SEEDS {
        let burnt = [0.0, 0.5, 1.0].map(|wind| {
            spread(
                strip(&[("seed", seed), ("wind", wind)], 0.0, 8.0),
                LEFT,
                0.8,
            )
        });
        assert!(burnt.is_sorted(), "{burnt:?}, seed {seed}");
        assert!(burnt[2] > 1.5 * burnt[0], "{burnt:?}, seed {seed}");
    }
}

#[test]
fn fire_spreads_slower_over_a_wet_fuel() {
    for seed in SEEDS {
        // Later, the drier strips are burnt up.
        let burnt = [60.0, 30.0, 0.0]
            .map(|moisture| spread(strip(&[("seed", seed)], 90.0, moisture), BOTTOM, 1.0));
        assert!(burnt.is_sorted(), "{burnt:?}, seed {seed}");
        assert!(burnt[2] > 1.2 * burnt[0], "{burnt:?}, seed {seed}");
    }
}

#[test]
fn a_thick_solid_burns_longer_than_a_thin_one() {
    // The time in which half of its fuel burns.
    let half = |load: f64| {
        let numbers = [("y", 0.4), ("width", 0.4), ("height", 0.06), ("load", load)];
        let mut fire = Simulation::new(with_solid(open(&[]), "line", "wood", &numbers));
        assert_eq!(fire.ignite(IgnitionTarget::Object(ID)), Ok(()));
        while solid(&fire).fuel > 0.5 * solid(&fire).first && fire.time() < 8.0 {
            fire.step();
        }
        fire.time()
    };
    let all = [1.0, 4.0, 16.0].map(half);
    assert!(all[1] > 1.2 * all[0] && all[2] > 2.0 * all[1], "{all:?}");
}

#[test]
fn a_burnt_solid_has_that_state_and_the_next_one_can_be_lit() {
    let numbers = [
        ("x", -0.3),
        ("y", 0.4),
        ("width", 0.2),
        ("height", 0.02),
        ("load", 0.3),
    ];
    let mut scene = with_solid(open(&[]), "line", "paper", &numbers);
    let other = [
        ("kind", Input::Text("solid")),
        ("fuel", Input::Text("wood")),
        ("x", Input::Number(0.4)),
        ("load", Input::Number(4.0)),
    ];
    assert_eq!(scene.add(&other), Ok(3));
    let mut fire = Simulation::new(scene);
    assert_eq!(fire.ignite(IgnitionTarget::Object(ID)), Ok(()));
    burn_on(&mut fire, 1.0);
    assert_eq!(fire.fuel_total().map(|fuel| fuel.state), Some("burning"));
    burn_on(&mut fire, 4.0);
    let states = |fire: &Simulation| {
        fire.burning_solids()
            .iter()
            .map(|solid| solid.state)
            .collect::<Vec<_>>()
    };
    assert_eq!(states(&fire), [BurningState::Burnt, BurningState::Unlit]);
    assert_eq!(fire.ignite(IgnitionTarget::Object(3)), Ok(()));
    // Nothing is left where the paper was: gas goes through.
    let inside = |at: &Vec2| (at.x + 0.3).abs() < 0.08 && (at.y - 0.4).abs() < 0.008;
    let mut goes_through = false;
    watch(&mut fire, 1.0, |fire| {
        goes_through |= fire.positions().iter().any(inside);
    });
    assert!(goes_through);
    assert_eq!(states(&fire), [BurningState::Burnt, BurningState::Burning]);
}

#[test]
fn fire_goes_out_for_want_of_oxygen() {
    let mut scene = closed_box(&[("gravity", 9.81), ("radiative_cooling", 500.0)]);
    assert_eq!(scene.set("ember_rate", 0.0), Ok(()));
    let numbers = [("y", 0.3), ("width", 0.25), ("load", 20.0)];
    let mut fire = Simulation::new(with_solid(scene, "circle", "wood", &numbers));
    assert_eq!(fire.ignite(IgnitionTarget::Object(ID)), Ok(()));
    burn_on(&mut fire, 1.0);
    assert_eq!(solid(&fire).state, BurningState::Burning);
    burn_on(&mut fire, 30.0);
    let solid = solid(&fire);
    assert_eq!(solid.state, BurningState::Starved, "{solid:?}");
    assert!(solid.fuel > 0.5 * solid.first, "{solid:?}");
    let oxygen = fire
        .oxygens()
        .unwrap_or_default()
        .into_iter()
        .map(f64::from)
        .sum::<f64>()
        / fire.count() as f64;
    assert!(oxygen < 0.9, "{oxygen}");
}

#[test]
fn a_fire_that_is_put_out_stays_out_and_can_be_lit_again() {
    let numbers = [("y", 0.4), ("width", 0.3), ("height", 0.1), ("load", 8.0)];
    let mut fire = Simulation::new(with_solid(open(&[]), "box", "wood", &numbers));
    assert_eq!(fire.ignite(IgnitionTarget::Object(ID)), Ok(()));
    burn_on(&mut fire, 3.0);
    assert_eq!(solid(&fire).state, BurningState::Burning);
    assert_eq!(fire.extinguish(IgnitionTarget::Object(ID)), Ok(()));
    burn_on(&mut fire, 3.0);
    assert_eq!(solid(&fire).state, BurningState::Out);
    assert_eq!(fire.ignite(IgnitionTarget::Object(ID)), Ok(()));
    burn_on(&mut fire, 1.0);
    assert_eq!(solid(&fire).state, BurningState::Burning);
    assert_eq!(
        fire.extinguish(IgnitionTarget::Place(Vec2::new(0.0, 0.4), 1.0)),
        Ok(())
    );
    burn_on(&mut fire, 3.0);
    assert_eq!(solid(&fire).state, BurningState::Out);
}

#[test]
fn what_has_no_fuel_is_refused() {
    let mut fire = strip(&[], 0.0, 8.0);
    for at in [
        IgnitionTarget::Object(1),
        IgnitionTarget::Object(99),
        IgnitionTarget::Place(Vec2::new(0.0, 2.0), 0.0),
        IgnitionTarget::Place(Vec2::NAN, 0.1),
    ] {
        assert!(fire.ignite(at).is_err(), "{at:?}");
    }
    assert!(fire.extinguish(IgnitionTarget::Object(1)).is_err());
    let mut classic = Simulation::new(with_solid(
        hearth_tests::fires::with([]),
        "circle",
        "wood",
        &[],
    ));
    assert!(classic.ignite(IgnitionTarget::Object(ID)).is_err());
    assert_eq!(classic.burning_solids(), []);
}

#[test]
fn the_same_seed_gives_the_same_bits_and_other_changes_keep_the_state() {
    let numbers = [("y", 0.4), ("width", 0.3), ("height", 0.05), ("load", 1.0)];
    let scene = with_solid(open(&[("ember_rate", 50.0)]), "line", "wood", &numbers);
    let mut fires = [Simulation::new(scene.clone()), Simulation::new(scene)];
    for fire in &mut fires {
        assert_eq!(fire.ignite(IgnitionTarget::Object(ID)), Ok(()));
        burn_on(fire, 2.0);
    }
    let [fire, other] = &mut fires;
    assert_eq!(fire.particles(), other.particles());
    assert_eq!(fire.burning_solids(), other.burning_solids());
    let before = solid(fire);
    let mut scene = fire.scene().clone();
    let moved = [("x", Input::Number(0.1)), ("material", Input::Text("coal"))];
    assert_eq!(scene.change(ID, &moved), Ok(()));
    fire.set_scene(scene);
    assert_eq!(solid(fire), before);
    fire.reset();
    assert_eq!(solid(fire).fuel, before.first);
}
