//! Undo and redo of single steps, beside what a page has changed since.

use crate::harness::{after, number, object, sent, set, text};
use hearth_core::scene::MAX_OBJECTS;
use hearth_settings::untrusted::Untrusted;
use hearth_settings::{Change, Settings, delta, whole};

/// What a step has done, by its deltas back and on.
struct Step {
    undo: Untrusted,
    redo: Untrusted,
}

/// The settings after a step.
fn step(settings: &Settings, change: Change<'_>) -> (Settings, Step) {
    let now = after(settings, change);
    let (undo, redo) = (delta(&now, settings), delta(settings, &now));
    (now, Step { undo, redo })
}

fn moved(settings: &Settings, delta: &Untrusted) -> Settings {
    match settings.after_deltas(std::slice::from_ref(delta)) {
        Ok(moved) => moved,
        Err(errors) => panic!("{delta:?} is refused: {errors:?}"),
    }
}

fn number_of(settings: &Settings, id: &str) -> Option<f64> {
    settings.scene().get(id).and_then(|value| value.as_number())
}

#[test]
fn one_value_is_one_value_of_a_delta() {
    let (_, step) = step(
        &Settings::default(),
        Change::Set(&sent([("wind", number(0.5))])),
    );
    assert_eq!(
        step.redo,
        object([("values", object([("wind", number(0.5))]))])
    );
    assert_eq!(
        step.undo,
        object([("values", object([("wind", number(0.0))]))])
    );
}

#[test]
fn a_step_keeps_what_it_did_when_its_undo_changes_nothing() {
    let (settings, step) = step(
        &Settings::default(),
        Change::Set(&sent([("wind", number(0.5))])),
    );
    let settings = set(&settings, "wind", number(0.0));
    let undone = moved(&settings, &step.undo);
    assert_eq!(undone, settings);
    assert_eq!(number_of(&moved(&undone, &step.redo), "wind"), Some(0.5));
}

#[test]
fn undo_keeps_what_a_page_has_changed_since() {
    let x = sent([("x", number(0.3))]);
    let (settings, step) = step(&Settings::default(), Change::ChangeObject(1, &x));
    let settings = set(&settings, "fuel_power", number(90.0));
    let settings = set(&settings, "wind", number(0.5));
    let undone = moved(&settings, &step.undo);
    let seen = ["source_x", "fuel_power", "wind"].map(|id| number_of(&undone, id));
    assert_eq!(seen, [Some(0.0), Some(90.0), Some(0.5)]);
}

#[test]
fn a_step_changes_no_object_of_another_list_and_no_later_object() {
    let x = sent([("x", number(0.3))]);
    let (moved_fire, drag) = step(&Settings::default(), Change::ChangeObject(1, &x));
    let candle = after(&moved_fire, Change::Preset("candle"));
    assert_eq!(moved(&candle, &drag.undo), candle);
    // The numbers of objects are not used again.
    let solid = sent([("kind", text("solid"))]);
    let (two, add) = step(&Settings::default(), Change::AddObject(&solid));
    let one = moved(&two, &add.undo);
    let again = after(&one, Change::AddObject(&solid));
    assert_eq!(again.scene().ids().collect::<Vec<_>>(), [1, 3]);
    assert_eq!(moved(&again, &add.undo), again);
}

#[test]
fn undo_restores_a_whole_scene_and_a_removed_object_in_either_model() {
    let campfire = after(&Settings::default(), Change::Preset("campfire"));
    let campfire = set(&campfire, "wind", number(1.0));
    let (candle, chosen) = step(&campfire, Change::Preset("candle"));
    assert_eq!(moved(&candle, &chosen.undo), campfire);
    assert_eq!(moved(&campfire, &chosen.redo), candle);
    let (classic, switched) = step(&campfire, Change::Set(&sent([("model", text("classic"))])));
    assert_eq!(moved(&classic, &switched.undo), campfire);
    // An undo of a removal survives a change of the model between.
    let (removed, removal) = step(&campfire, Change::RemoveObject(1));
    let classic = set(&removed, "model", text("classic"));
    let restored = moved(&classic, &removal.undo);
    let sources = restored
        .scene()
        .objects()
        .filter(|object| object.source().is_some());
    assert_eq!(sources.map(|source| source.id).collect::<Vec<_>>(), [1]);
    assert_eq!(
        number_of(&restored, "source_height"),
        number_of(&campfire, "source_height")
    );
}

#[test]
fn a_delta_with_a_refused_value_changes_nothing() {
    for (wrong, named) in [
        (
            object([("values", object([("wind", number(9.0))]))]),
            "wind",
        ),
        (object([("preset", text("candl"))]), "preset"),
        (
            object([
                ("list", number(0.0)),
                ("objects", object([("1", object([("x", number(9.0))]))])),
            ]),
            "objects[0].x",
        ),
    ] {
        let errors = Settings::default()
            .after_deltas(&[wrong])
            .expect_err("refused");
        assert_eq!(errors[0].id, named);
    }
}

#[test]
fn objects_are_added_beside_one_with_the_largest_id() {
    let solid = |id| sent([("kind", text("solid")), ("id", id)]);
    let largest = after(&Settings::default(), Change::AddObject(&solid(number(1e6))));
    let both = after(&largest, Change::AddObject(&solid(Untrusted::Missing)));
    let two = after(&both, Change::AddObject(&solid(Untrusted::Missing)));
    assert_eq!(Settings::of_whole(&whole(&two)), Ok(two.clone()));
    assert_eq!(
        two.scene().objects().len(),
        largest.scene().objects().len() + 2
    );
}

#[test]
fn the_list_after_the_one_with_the_largest_number_is_another_list() {
    let file = object([("list", number(f64::from(u32::MAX)))]);
    let settings = Settings::of_whole(&file).unwrap_or_default();
    let objects = Untrusted::List(vec![object([("kind", text("solid"))])]);
    let (now, step) = step(&settings, Change::Set(&sent([("objects", objects)])));
    assert_eq!(step.undo.field("replaces"), &Untrusted::Flag(true));
    assert_eq!(moved(&now, &step.undo), settings);
}

#[test]
fn an_object_that_goes_leaves_its_room_to_one_that_comes() {
    let solid = sent([("kind", text("solid"))]);
    let add = |settings: &Settings| after(settings, Change::AddObject(&solid));
    let full = (0..MAX_OBJECTS).fold(Settings::default(), |settings, _| add(&settings));
    let last = full.scene().ids().last().unwrap_or_default();
    let other = add(&after(&full, Change::RemoveObject(last)));
    for (from, to) in [(&full, &other), (&other, &full)] {
        assert_eq!(moved(from, &delta(from, to)).scene(), to.scene());
    }
}
