//! The decoders of what a page, a link or a file can send, as targets of libFuzzer. `HEARTH_DECODER` names one.
//!
//! A target panics where its law does not hold: refused with a reason, or decoded to a valid value.
#![no_main]

use std::env;
use std::sync::LazyLock;

use hearth_cli::decoders;
use hearth_core::preset::Preset;
use hearth_core::scene::Scene;
use hearth_core::{Simulation, params::Input};
use hearth_engine::commands::Command;
use hearth_settings::untrusted::{Untrusted, ValidationError};
use hearth_settings::{Change, Settings};
use hearth_tests::{sweep, valid};

/// A decoder under test.
type Decoder = fn(&[u8]);

const DECODERS: [(&str, Decoder); 7] = [
    ("link", |bytes| decoded(decoders::link(&text(bytes)))),
    ("scene", |bytes| decoded(decoders::scene(bytes))),
    ("changes", changes),
    ("calls", calls),
    ("outlines", outlines),
    ("checkpoint", decoders::checkpoint),
    ("saved", saved),
];

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    static DECODER: LazyLock<Decoder> = LazyLock::new(|| {
        let name = env::var("HEARTH_DECODER").unwrap_or_default();
        let found = DECODERS.iter().find(|(known, _)| *known == name);
        let names = DECODERS.map(|(name, _)| name).join(", ");
        found
            .unwrap_or_else(|| panic!("HEARTH_DECODER is one of {names}, not \"{name}\""))
            .1
    });
    DECODER(bytes);
});

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

/// The settings of what was decoded are valid, or their refusals have reasons.
fn decoded(value: Result<Untrusted, String>) {
    match value {
        Ok(config) => drop(accepted(Settings::of_file(&config))),
        Err(why) => assert!(!why.is_empty() && why.len() < 2000, "{why}"),
    }
}

fn accepted(done: Result<Settings, Vec<ValidationError>>) -> Option<Settings> {
    match done {
        Ok(settings) => {
            valid::is_valid(settings.scene());
            Some(settings)
        }
        Err(errors) => {
            assert!(!errors.is_empty() && errors.iter().all(|error| !error.message.is_empty()));
            None
        }
    }
}

/// A list of changes in JSON, each an object: values, an object to add, deltas, children. Deltas lead from one to the next,
/// except to children: a delta changes those that the page has, and makes none.
fn changes(bytes: &[u8]) {
    let Ok(list) = decoders::scene(bytes) else {
        return;
    };
    let mut settings = Settings::default();
    for (at, change) in list.list().iter().enumerate() {
        let (fields, id) = (change.fields(), at as u32);
        let after = match at % 5 {
            0 => settings.after(&Change::Set(fields)),
            1 => settings.after(&Change::AddObject(fields)),
            2 => settings.after(&Change::ChangeObject(id, fields)),
            3 => settings.after_deltas(change.list()),
            _ => Ok(settings.with_children(change.list(), &mut Vec::new())),
        };
        if let Some(after) = accepted(after) {
            let delta = hearth_settings::delta(&settings, &after);
            let again = settings.after_deltas(&[delta]);
            if at % 5 < 4 {
                assert_eq!(
                    again.map(|it| it.scene().clone()),
                    Ok(after.scene().clone())
                );
            }
            settings = after;
        }
    }
}

/// A call of a page in JSON: its name and its arguments.
fn calls(bytes: &[u8]) {
    if let Ok(call) = decoders::scene(bytes)
        && let [name, arguments @ ..] = call.list()
        && let Err(error) = Command::parse(name, arguments)
    {
        assert!(!error.message.is_empty());
    }
}

/// An outline of a solid: the first letter decides its kind. The solid is there before, so that a refusal costs no distances.
fn outlines(bytes: &[u8]) {
    static SOLIDS: LazyLock<[(Scene, u32); 3]> = LazyLock::new(|| {
        ["mask", "stroke", "polygon"].map(|shape| {
            let fields = [("kind", "solid"), ("shape", shape)];
            let mut scene = Scene::default();
            let added = scene.add(&fields.map(|(name, text)| (name, Input::Text(text))));
            let id = added.expect("a solid");
            (scene, id)
        })
    });
    let outline = text(bytes);
    let (place, name) = match outline.as_bytes().first() {
        Some(b'm') => (0, "mask"),
        Some(b's') => (1, "points"),
        _ => (2, "points"),
    };
    let outline = outline.get(1..).unwrap_or_default();
    let (mut scene, id) = SOLIDS[place].clone();
    match scene.change(id, &[(name, Input::Text(outline))]) {
        Ok(()) => valid::is_valid(&scene),
        Err(refusals) => assert!(!format!("{refusals:?}").is_empty()),
    }
}

/// A saved fire with that damage: it burns on, or is refused.
fn saved(damage: &[u8]) {
    const STORED: &[u8] = include_bytes!("../../../web/prewarmed/fireside.fire");
    static SCENE: LazyLock<Scene> = LazyLock::new(|| {
        let mut scene = Preset::find("fireside").expect("the scene").scene();
        scene.set("max_particles", 500.0).expect("a number");
        scene
    });
    let bytes = decoders::damaged(STORED.to_vec(), damage);
    let mut fire = Simulation::new(SCENE.clone());
    if fire.restore_burning(&bytes).is_ok() {
        assert_eq!(sweep::burn(&mut fire, 0.01).broken, None);
    }
}
