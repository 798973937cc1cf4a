//! Laws of the series of parts of steps that sound follows from: recording changes no fire, and what the records have adds up to
//! what the fire has.

use hearth_core::params::{Input, Model, Parameters};
use hearth_core::preset::Preset;
use hearth_core::sound::{Mix, Synthesis};
use hearth_core::warm_up::WarmUp;
use hearth_core::{Simulation, StepRecord, Vec2};
use hearth_tests::fires::combustion;

/// A recorded fire.
fn recorded(mut fire: Simulation) -> Simulation {
    fire.record_series(true);
    fire
}

fn scene(name: &str) -> Simulation {
    let mut all = Preset::all().iter();
    let preset = all.find(|preset| preset.name == name);
    Simulation::new(preset.map_or_else(Default::default, Preset::scene))
}

/// The records of so many steps.
fn records(fire: &mut Simulation, steps: u32) -> Vec<StepRecord> {
    let mut all = Vec::new();
    for _ in 0..steps {
        fire.step();
        all.extend(fire.read_series());
    }
    all
}

fn sum(records: &[StepRecord], number: impl Fn(&StepRecord) -> f32) -> f64 {
    records.iter().map(|record| f64::from(number(record))).sum()
}

#[test]
fn a_recorded_fire_has_the_bits_of_any_other() {
    for (name, parts) in [("burning-logs", 2), ("classic", 1)] {
        let (mut fire, mut other) = (recorded(scene(name)), scene(name));
        assert_eq!(records(&mut fire, 60).len(), 60 * parts);
        assert_eq!(records(&mut other, 60), []);
        assert_eq!(fire.particles(), other.particles(), "{name}");
        assert_eq!(fire.embers(), other.embers(), "{name}");
    }
}

#[test]
fn lengths_of_parts_add_up_to_the_age_and_their_mean_power_is_that_of_each_step() {
    let mut fire = recorded(scene("candle"));
    for _ in 0..50 {
        fire.step();
        let (length, power) = (fire.step_length(), fire.power());
        let parts = fire.read_series();
        assert_eq!(parts.len(), 2);
        assert!((sum(&parts, |part| part.length) - length).abs() < 1e-9);
        let mean = 0.5 * sum(&parts, |part| part.power);
        let power = f64::from(power.unwrap_or(f32::NAN));
        assert!((mean - power).abs() <= 1e-5 * power, "{mean} of {power}");
    }
    let mut fire = recorded(scene("candle"));
    let seconds = sum(&records(&mut fire, 50), |step| step.length);
    assert!((seconds - fire.time()).abs() < 1e-6, "{seconds} s");
}

#[test]
fn solids_dry_and_char_by_what_they_lose() {
    let mut fire = recorded(scene("burning-logs"));
    let all = records(&mut fire, 600);
    let solids = fire.burning_solids();
    let steam: f64 = solids.iter().map(|solid| solid.steam).sum();
    let gas: f64 = solids.iter().map(|solid| solid.gas).sum();
    assert!(steam > 0.0 && gas > 0.0, "the logs burn");
    let dried = sum(&all, |step| step.dried);
    assert!(
        (dried / steam - 1.0).abs() < 1e-3,
        "{dried} of {steam} kg/m"
    );
    // A fifth of wood is char.
    let charred = sum(&all, |step| step.charred);
    assert!(
        (charred / gas / 0.25 - 1.0).abs() < 1e-3,
        "{charred} for {gas} kg/m"
    );
    let load = all.last().map(|step| step.load);
    assert!(
        load.is_some_and(|load| (load - 12.0).abs() < 1e-5),
        "{load:?}"
    );
}

#[test]
fn sparks_have_a_number_and_a_place() {
    let mut fire = recorded(Simulation::new(combustion(&[("ember_rate", 0.0)])));
    assert_eq!(sum(&records(&mut fire, 5), |step| step.sparks), 0.0);
    fire.throw_embers(Vec2::new(0.3, 0.5), 20);
    let all = records(&mut fire, 1);
    assert_eq!(all[0].sparks, 20.0);
    assert!((all[0].place - 0.3).abs() < 1e-6, "{} m", all[0].place);
}

#[test]
fn steam_is_the_water_that_evaporates() {
    let mut fire = recorded(scene("campfire"));
    let mut all = records(&mut fire, 100);
    assert_eq!(sum(&all, |step| step.steam), 0.0);
    assert_eq!(
        fire.spray(Vec2::new(0.0, 0.8), Vec2::new(0.0, -3.0), 0.02),
        Ok(())
    );
    all = records(&mut fire, 100);
    let totals = fire.sprayed().unwrap();
    let steam = totals.evaporated + totals.boiled;
    assert!(steam > 0.0);
    assert!((sum(&all, |step| step.steam) / steam - 1.0).abs() < 1e-3);
}

#[test]
fn only_a_narrow_source_that_burns_is_a_jet() {
    for (width, speed) in [(0.1, 0.6), (0.4, 0.0)] {
        let values = [("source_width", width), ("emission_speed", 0.6)];
        let mut fire = recorded(Simulation::new(combustion(&values)));
        let last = *records(&mut fire, 5).last().unwrap();
        assert_eq!(last.jet, speed);
        assert_eq!(fire.set("fuel_power", Input::Number(0.0)), Ok(()));
        assert_eq!(records(&mut fire, 1)[0].jet, 0.0);
    }
}

#[test]
fn a_wide_source_flutters_by_its_speed_or_the_wind_over_its_width() {
    for (width, wind, flutter) in [(0.1, 0.0, 0.0), (0.4, 0.0, 1.5), (0.4, -1.0, 2.5)] {
        let values = [
            ("source_width", width),
            ("emission_speed", 0.6),
            ("wind", wind),
        ];
        let mut fire = recorded(Simulation::new(combustion(&values)));
        let last = *records(&mut fire, 5).last().unwrap();
        assert!(
            (last.flutter - flutter).abs() < 1e-6,
            "{} 1/s",
            last.flutter
        );
    }
}

#[test]
fn a_backdrop_is_a_wall() {
    for (name, wall) in [("fireside", 1.0), ("campfire", 0.0)] {
        assert_eq!(
            records(&mut recorded(scene(name)), 1)[0].wall,
            wall,
            "{name}"
        );
    }
}

#[test]
fn a_pop_throws_an_ember_that_is_larger_and_faster_than_any_other_in_the_same_step() {
    let mut fire = recorded(scene("forge"));
    let size = fire.scene().world().ember_size;
    let (mut sparks, mut pops) = (0.0, 0.0);
    while fire.time() < 4.0 {
        let step = records(&mut fire, 1)[0];
        sparks += step.sparks;
        pops += step.pops;
        let fresh = fire
            .embers()
            .iter()
            .filter(|ember| f64::from(ember.age) <= fire.step_length());
        let popped: Vec<_> = fresh.filter(|ember| ember.size > size).collect();
        assert_eq!(popped.len(), step.pops as usize);
        assert!(
            popped.iter().all(|ember| ember.velocity.y > 1.0),
            "{popped:?}"
        );
    }
    let share = pops / sparks;
    assert!((0.004..0.02).contains(&share), "{pops} of {sparks}");
}

#[test]
fn a_copy_of_a_fire_and_of_its_sound_goes_on_to_the_same_samples() {
    let rate = 48_000.0;
    let mut fire = recorded(scene("fireside"));
    let mut sound = Synthesis::new(rate, 3, Mix::default());
    let heard = |fire: &mut Simulation, sound: &mut Synthesis| {
        sound.push(&records(fire, 100), 1.0, 0.5);
        let frames = (sound.ahead() * rate) as usize;
        let (mut left, mut right) = (vec![0.0; frames], vec![0.0; frames]);
        sound.render(&mut left, &mut right);
        [left, right]
    };
    let first = heard(&mut fire, &mut sound);
    assert!(first.iter().all(|side| side.iter().any(|x| *x != 0.0)));
    let (mut copied_fire, mut copied_sound) = (fire.clone(), sound.clone());
    let after = heard(&mut fire, &mut sound);
    assert_eq!(after, heard(&mut copied_fire, &mut copied_sound));
    assert_ne!(after, first);
}

#[test]
fn births_less_deaths_are_the_particles() {
    let mut fire = recorded(Simulation::new(Parameters::new(Model::Classic)));
    let all = records(&mut fire, 600);
    let alive = sum(&all, |step| step.births - step.deaths);
    assert!(sum(&all, |step| step.deaths) > 0.0);
    assert_eq!(alive, fire.count() as f64);
}

#[test]
fn what_nobody_reads_is_dropped_and_a_reset_gives_nothing() {
    let mut settings = Parameters::new(Model::Classic);
    assert_eq!(settings.set("max_particles", Input::Number(100.0)), Ok(()));
    let mut fire = recorded(Simulation::new(settings));
    for _ in 0..5000 {
        fire.step();
    }
    let kept = fire.series_numbers().len() / StepRecord::NUMBERS;
    assert!((1..=2048).contains(&kept), "{kept} records");
    assert!(fire.series_numbers().is_empty());
    fire.reset();
    let first = records(&mut fire, 1)[0];
    assert!(first.births <= 100.0 && first.deaths == 0.0, "{first:?}");
    fire.record_series(false);
    assert_eq!(records(&mut fire, 3), []);
}

#[test]
fn a_fire_that_warms_up_anew_or_has_another_number_of_particles_stays_recorded() {
    let scene = |name| scene(name).scene().clone();
    let mut fire = recorded(Simulation::new(scene("default")));
    let mut warm_up = WarmUp::new(0.1, Vec::new());
    assert!(warm_up.begin(&mut fire, scene("candle")).is_none());
    assert_eq!(records(&mut fire, 3).len(), 6);
    warm_up.begin(&mut fire, scene("forge"));
    fire.adapt(scene("campfire"));
    let steps = records(&mut fire, 3);
    assert_eq!(steps.len(), 6);
    // It gives what it gives itself alone.
    assert_eq!(
        steps,
        records(&mut recorded(Simulation::new(scene("campfire"))), 3)
    );
}
