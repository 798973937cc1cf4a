//! Undo and redo of steps between which the page has changed the settings.

use crate::harness::{after, in_order, number, object, sent, set, text};
use hearth_settings::untrusted::Untrusted;
use hearth_settings::{Change, OBJECTS, Settings, export, whole};

/// The settings after this step is undone.
fn undone(now: &Settings, before: &Settings, after: &Settings) -> Settings {
    match now.after_steps(&[whole(before)], &[whole(after)]) {
        Ok(settings) => settings,
        Err(errors) => panic!("{errors:?}"),
    }
}

#[test]
fn undo_changes_no_object_that_has_come_since() {
    let solid = sent([("kind", text("solid")), ("x", number(0.1))]);
    let first = after(&Settings::default(), Change::AddObject(&solid));
    let moved = after(&first, Change::ChangeObject(2, &sent([("x", number(0.5))])));
    let other = after(
        &after(&moved, Change::RemoveObject(2)),
        Change::AddObject(&solid),
    );
    assert_eq!(undone(&other, &first, &moved), other);
    assert_eq!(undone(&other, &moved, &first), other);
    // Neither do values of an object of another scene reach one of the scene before.
    let campfire = after(&first, Change::Preset("campfire"));
    let candle = after(&campfire, Change::Preset("candle"));
    let wax = candle
        .scene()
        .objects()
        .nth(1)
        .map_or(0, |object| object.id);
    let page = after(
        &candle,
        Change::ChangeObject(wax, &sent([("x", number(0.5))])),
    );
    assert_eq!(undone(&page, &campfire, &candle), campfire);
}

#[test]
fn undo_of_a_removal_survives_another_model() {
    let combustion = after(&Settings::default(), Change::Preset("campfire"));
    let classic = set(&Settings::default(), "model", text("classic"));
    for (page, model) in [(combustion, "classic"), (classic, "combustion")] {
        let source = sent([
            ("kind", text("source")),
            ("x", number(0.2)),
            ("speed", number(0.7)),
        ]);
        let solid = sent([
            ("kind", text("solid")),
            ("material", text("wood")),
            ("y", number(0.4)),
        ]);
        let page = after(
            &after(&page, Change::AddObject(&source)),
            Change::AddObject(&solid),
        );
        let all: Vec<u32> = page.scene().objects().map(|object| object.id).collect();
        for id in all {
            let removed = after(&page, Change::RemoveObject(id));
            let other = set(&removed, "model", text(model));
            let wanted = set(&page, "model", text(model));
            assert_eq!(
                whole(&undone(&other, &page, &removed)),
                whole(&wanted),
                "{id}"
            );
            assert_eq!(
                whole(&undone(&wanted, &removed, &page)),
                whole(&other),
                "{id}"
            );
        }
    }
}

/// Children of a page that state this of their x.
fn children(list: &[(f64, &str, Option<f64>)]) -> Vec<Untrusted> {
    let child = |(id, kind, x): &(f64, &str, Option<f64>)| {
        let values = x.map_or(object([]), |x| object([("x", number(x))]));
        object([
            ("id", number(*id)),
            ("kind", text(kind)),
            ("values", values),
            ("changed", Untrusted::List(Vec::new())),
        ])
    };
    list.iter().map(child).collect()
}

#[test]
fn undo_of_a_scene_gives_no_value_of_its_sources_to_those_of_the_scene_before() {
    let list = children(&[(1003.0, "solid", None), (1002.0, "source", None)]);
    let campfire = after(&Settings::default(), Change::Preset("campfire"));
    let before = campfire.with_children(&list, &mut Vec::new());
    let burner = after(&before, Change::Preset("gas-burner"));
    // A solid before the source in the document puts the first source of the page behind the others in what burns.
    let now = burner.with_children(&[], &mut Vec::new());
    assert_eq!(whole(&undone(&now, &before, &burner)), whole(&campfire));
}

#[test]
fn an_import_of_the_own_export_leaves_each_source_to_the_page_or_to_its_child() {
    let list = children(&[(1001.0, "source", Some(-0.6))]);
    let page = Settings::default().with_children(&list, &mut Vec::new());
    let solid = [(
        OBJECTS.to_owned(),
        Untrusted::List(vec![object([("kind", text("solid"))])]),
    )];
    let page = after(&page, Change::State(&solid));
    let page = after(
        &page,
        Change::AddObject(&sent([("kind", text("source")), ("x", number(0.3))])),
    );
    let again = page
        .after_file(&export(&page))
        .unwrap_or_else(|errors| panic!("{errors:?}"));
    assert_eq!(in_order(again.scene()), in_order(page.scene()));
    let bare = |settings: &Settings| settings.with_children(&[], &mut Vec::new());
    assert_eq!(
        in_order(bare(&again).scene()),
        in_order(bare(&page).scene())
    );
    // The child comes back, and no source of the page is taken for it.
    let back = bare(&again).with_children(&list, &mut Vec::new());
    let undone = undone(&back, &page, &again);
    assert_eq!(whole(&bare(&undone)), whole(&bare(&page)));
}
