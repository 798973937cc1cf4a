//! What a page, a link or a file can send keeps the laws of its decoder: random settings, objects
//! and arguments, and damaged burning fires.
//!
//! `cargo measure fuzz --minutes N` looks for longer. A case that fails names the seed that
//! repeats it.

use std::path::PathBuf;
use std::time::{Duration, Instant};
use std::{env, fs, io, thread};

use hearth_core::Simulation;
use hearth_core::params::PARAMETERS;
use hearth_core::preset::Preset;
use hearth_core::random::Random;
use hearth_core::scene::KINDS;
use hearth_settings::untrusted::{Check, Form, Untrusted, ValidationError};
use hearth_settings::{Change, Settings};
use hearth_tests::sweep;
use hearth_tests::valid::is_valid;
use serde_json::Value as Json;

/// Longest message of a refusal in bytes.
const LONGEST_MESSAGE: usize = 8000;

#[rustfmt::skip]
const NUMBERS: [f64; 17] = [
    0.0, -0.0, 1.0, -1.0, 0.5, 2.0, 63.0, 64.0, 65.0, 1e6, 4_294_967_296.0, -2_147_483_649.0,
    1e300, 5e-324, f64::NAN, f64::INFINITY, f64::NEG_INFINITY,
];

const TEXTS: [&str; 24] = [
    "8x4:3PSqSo",
    "0,0.1 0.2,-0.1",
    "",
    " ",
    "\0",
    "0",
    "-0.0",
    "1e5",
    "1e999999999",
    "0x10",
    ".5.",
    "NaN",
    "true",
    "#ff8800",
    "#12345g",
    "#é0é0",
    "transparent",
    "classic",
    "combustion",
    "__proto__",
    "٣",
    "🔥",
    "\u{feff}1",
    "99999999999999999999999999999999999999999999999999",
];

/// Choices of parameters, presets and kinds.
const CHOICES: [&str; 7] = [
    "source",
    "solid",
    "black-body",
    "high",
    "fire",
    "seed",
    "clear",
];

/// Names of fields of settings.
const FIELDS: [&str; 7] = [
    "values", "objects", "kind", "id", "hearth", "preset", "model",
];

/// Runs one case after another: so many, or as long as `HEARTH_FUZZ_MINUTES` allows. Each has a
/// seed of its own, from `HEARTH_FUZZ_SEED` on.
fn cases(count: u32, case: impl Fn(&mut Random)) {
    let given = |name: &str| {
        env::var(name)
            .ok()
            .and_then(|text| text.parse::<u32>().ok())
    };
    let first = given("HEARTH_FUZZ_SEED").unwrap_or(1);
    let end = given("HEARTH_FUZZ_MINUTES")
        .map(|minutes| Instant::now() + Duration::from_secs(60 * u64::from(minutes)));
    for number in 0.. {
        if end.map_or(number == count, |end| Instant::now() >= end) {
            break;
        }
        let named = Named(first.wrapping_add(number));
        case(&mut Random::new(named.0));
    }
}

/// Names its seed if the case of it panics.
struct Named(u32);

impl Drop for Named {
    fn drop(&mut self) {
        if thread::panicking() {
            eprintln!(
                "`cargo measure fuzz --seed {}` repeats this case first",
                self.0
            );
        }
    }
}

fn below(random: &mut Random, count: usize) -> usize {
    random.bits() as usize % count.max(1)
}

fn one_of<'a, T>(random: &mut Random, all: &'a [T]) -> &'a T {
    &all[below(random, all.len())]
}

fn name(random: &mut Random) -> String {
    match below(random, 8) {
        0..4 => one_of(random, PARAMETERS).id.to_owned(),
        4 | 5 => {
            let kind = one_of(random, KINDS);
            (*one_of(random, kind.names)).to_owned()
        }
        6 => (*one_of(random, &FIELDS)).to_owned(),
        _ => text(random),
    }
}

fn text(random: &mut Random) -> String {
    match below(random, 4) {
        0 => (0..below(random, 1000))
            .map(|_| char::from(random.bits() as u8))
            .collect(),
        1 => (*one_of(random, &CHOICES)).to_owned(),
        _ => (*one_of(random, &TEXTS)).to_owned(),
    }
}

fn number(random: &mut Random) -> f64 {
    match below(random, 3) {
        0 => *one_of(random, &NUMBERS),
        1 => f64::from_bits(u64::from(random.bits()) << 32 | u64::from(random.bits())),
        _ => f64::from(random.between(-3.0, 20.0)),
    }
}

/// Any value that the boundary can copy, this deep at most.
fn value(random: &mut Random, depth: u32) -> Untrusted {
    let count = below(random, 5);
    match below(random, if depth == 0 { 7 } else { 10 }) {
        0 => Untrusted::Missing,
        1 => Untrusted::Flag(random.bits() & 1 == 0),
        2 => Untrusted::Bytes((0..count).map(|_| random.bits() as u8).collect()),
        3 => Untrusted::Other("a value that is no plain data"),
        4 => Untrusted::Text(text(random)),
        5 | 6 => Untrusted::Number(number(random)),
        7 => Untrusted::List((0..30 * count).map(|_| value(random, depth - 1)).collect()),
        _ => Untrusted::Object(
            (0..count)
                .map(|_| (name(random), value(random, depth - 1)))
                .collect(),
        ),
    }
}

/// Changes a part of a value that is often deep inside.
fn damage(random: &mut Random, part: &mut Untrusted) {
    match part {
        Untrusted::Object(fields) if !fields.is_empty() && below(random, 8) > 0 => {
            let at = below(random, fields.len());
            match below(random, 8) {
                0 => fields[at].0 = name(random),
                1 => fields.push(fields[at].clone()),
                2 => drop(fields.remove(at)),
                3 => fields.push((name(random), value(random, 2))),
                _ => damage(random, &mut fields[at].1),
            }
        }
        Untrusted::List(list) if !list.is_empty() && below(random, 8) > 0 => {
            let at = below(random, list.len());
            match below(random, 6) {
                0 => drop(list.remove(at)),
                1 => (0..below(random, 70)).for_each(|_| list.push(list[at].clone())),
                _ => damage(random, &mut list[at]),
            }
        }
        other => *other = value(random, 3),
    }
}

/// The settings of every scene file, and of `tests/tests/fuzz.json`.
fn corpus() -> io::Result<Vec<Untrusted>> {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/..");
    let mut files = vec![format!("{root}/tests/tests/fuzz.json").into()];
    for folder in ["scenes", "scenes/community"] {
        for entry in fs::read_dir(format!("{root}/{folder}"))? {
            files.push(entry?.path());
        }
    }
    files.retain(|file: &PathBuf| file.extension().is_some_and(|it| it == "json"));
    files.sort();
    let mut all = Vec::new();
    for file in files {
        match serde_json::from_slice(&fs::read(file)?)? {
            Json::Array(list) => all.extend(list.iter().map(untrusted)),
            scene => all.push(untrusted(&scene)),
        }
    }
    Ok(all)
}

/// Plain data as JavaScript sends it.
fn untrusted(json: &Json) -> Untrusted {
    match json {
        Json::Null => Untrusted::Missing,
        Json::Bool(on) => Untrusted::Flag(*on),
        Json::Number(number) => Untrusted::Number(number.as_f64().unwrap_or(f64::NAN)),
        Json::String(text) => Untrusted::Text(text.clone()),
        Json::Array(list) => Untrusted::List(list.iter().map(untrusted).collect()),
        Json::Object(fields) => {
            let fields = fields.iter();
            Untrusted::Object(
                fields
                    .map(|(name, value)| (name.clone(), untrusted(value)))
                    .collect(),
            )
        }
    }
}

fn decided(done: Result<Settings, Vec<ValidationError>>) -> Option<Settings> {
    match done {
        Ok(settings) => {
            is_valid(settings.scene());
            Some(settings)
        }
        Err(errors) => {
            assert!(!errors.is_empty());
            for error in errors {
                assert!(!error.message.is_empty(), "{}", error.id);
                assert!(
                    error.message.len() <= LONGEST_MESSAGE,
                    "{} bytes",
                    error.message.len()
                );
            }
            None
        }
    }
}

#[test]
fn random_settings_give_a_valid_scene_or_reasons() -> io::Result<()> {
    let corpus = corpus()?;
    cases(3000, |random| {
        let mut config = one_of(random, &corpus).clone();
        for _ in 0..below(random, 4) {
            damage(random, &mut config);
        }
        let fields = config.fields();
        let nulls: Vec<_> = fields
            .iter()
            .map(|(name, _)| (name.clone(), Untrusted::Null))
            .collect();
        let settings = decided(Settings::of_file(&config)).unwrap_or_default();
        let id = [1, random.bits() % 70][below(random, 2)];
        for change in [
            Change::Set(fields),
            Change::Set(&nulls),
            Change::AddObject(fields),
            Change::ChangeObject(id, fields),
            Change::RemoveObject(id),
        ] {
            decided(settings.after(&change));
        }
        is_valid(settings.after_valid(fields, &mut Vec::new()).scene());
    });
    Ok(())
}

#[test]
fn random_arguments_have_the_form_that_their_check_accepts() {
    const NAMES: &[&str] = &["fire", "smoke"];
    cases(20_000, |random| {
        let sent = value(random, 3);
        let [a, b] = [random.bits(), random.bits()].map(|bits| (bits % 2000) as i32 - 1000);
        let (min, max) = (a.min(b), a.max(b));
        let whole = random.bits() & 1 == 0;
        let (form, holds) = match below(random, 6) {
            0 => (Form::Finite, sent.number().is_finite()),
            1 => (
                Form::Within { min, max, whole },
                (f64::from(min)..=f64::from(max)).contains(&sent.number())
                    && (!whole || sent.number().fract() == 0.0),
            ),
            2 => (
                Form::Positive(max),
                sent.number() > 0.0 && sent.number() <= f64::from(max),
            ),
            3 => (Form::Flag, matches!(sent, Untrusted::Flag(_))),
            4 => (Form::OneOf(NAMES), NAMES.contains(&sent.text())),
            _ => (Form::Values, matches!(sent, Untrusted::Object(_))),
        };
        let tested = Check::required(form).test("argument", &sent);
        assert_eq!(tested.is_ok(), holds, "{form:?}: {sent:?}");
        let missing = Check::optional(form).test("argument", &Untrusted::Missing);
        assert_eq!(missing, Ok(()));
        if let Err(error) = tested {
            assert!(
                error.message.len() <= LONGEST_MESSAGE,
                "{} bytes",
                error.message.len()
            );
        }
    });
}

#[test]
fn a_damaged_fire_burns_on_within_its_bounds_or_is_refused_and_changes_nothing() {
    const STORED: &[u8] = include_bytes!("../../web/prewarmed/fireside.fire");
    /// The bytes of the header after those that identify the fire.
    const COUNTS: std::ops::Range<usize> = 16..56;
    let mut scene = Preset::find("fireside").expect("the scene").scene();
    scene.set("max_particles", 500.0).expect("a number");
    // Undamaged it is taken up.
    assert_eq!(
        Simulation::new(scene.clone()).restore_burning(STORED),
        Ok(())
    );
    cases(1500, |random| {
        let mut bytes = STORED.to_vec();
        for _ in 0..below(random, 6) {
            let at = below(random, bytes.len());
            let end = (at + below(random, 300)).min(bytes.len());
            match below(random, 8) {
                0 => bytes.truncate(at),
                1 => drop(bytes.drain(at..end)),
                2 => bytes.extend_from_within(at..end),
                3 => bytes[at..end].fill(random.bits() as u8),
                4 => {
                    let at = COUNTS.start + 4 * below(random, COUNTS.len() / 4);
                    let odd = number(random) as f32;
                    if let Some(word) = bytes.get_mut(at..at + 4) {
                        word.copy_from_slice(&odd.to_le_bytes());
                    }
                }
                _ => bytes[at] ^= 1 << below(random, 8),
            }
            if bytes.is_empty() {
                break;
            }
        }
        let mut fire = Simulation::new(scene.clone());
        let before = (fire.positions(), fire.time());
        if fire.restore_burning(&bytes).is_ok() {
            let outcome = sweep::burn(&mut fire, 0.02);
            assert_eq!(outcome.broken, None);
        } else {
            assert_eq!((fire.positions(), fire.time()), before);
        }
    });
}
