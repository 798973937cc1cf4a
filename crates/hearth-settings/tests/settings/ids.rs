//! Ids of objects: a fire gives none of them twice.

use crate::harness::{after, in_order, number, object, sent, set, text};
use hearth_core::Scene;
use hearth_settings::untrusted::Untrusted;
use hearth_settings::{Change, OBJECTS, Settings, export, whole};

/// The ids and the kinds of all objects.
fn ids(scene: &Scene) -> Vec<String> {
    let all = scene.objects();
    all.map(|object| format!("{} {}", object.id, object.kind.name))
        .collect()
}

fn imported(settings: &Settings, config: &Untrusted) -> Settings {
    match settings.after_file(config) {
        Ok(after) => after,
        Err(errors) => panic!("{errors:?}"),
    }
}

#[test]
fn an_object_gets_an_id_that_none_had() {
    let solid = sent([("kind", text("solid"))]);
    let add = |settings: &Settings| after(settings, Change::AddObject(&solid));
    let two = add(&Settings::default());
    assert_eq!(ids(two.scene()), ["1 source", "2 solid"]);
    let other = add(&after(&two, Change::RemoveObject(2)));
    assert_eq!(ids(other.scene()), ["1 source", "3 solid"]);
    // Undo restores the first one under its id, and counts on.
    let undone = imported(&other, &whole(&two));
    assert_eq!(ids(undone.scene()), ["1 source", "2 solid"]);
    assert_eq!(ids(add(&undone).scene())[2], "4 solid");
    let restarted = Settings::of_file(&whole(&two)).map(|settings| settings.following(7));
    assert_eq!(
        restarted.map(|settings| ids(add(&settings).scene())[2].clone()),
        Ok("8 solid".into())
    );
    // An id that is stated is free, and the largest one leaves room.
    let stated = |id: f64| sent([("kind", text("solid")), ("id", number(id))]);
    let last = after(&other, Change::AddObject(&stated(1e6)));
    assert_eq!(
        ids(add(&last).scene()),
        ["1 source", "3 solid", "1000000 solid", "2 solid"]
    );
}

#[test]
fn another_scene_has_other_objects_and_its_sources_stay_on_their_solids() {
    let [first, second] = ["burning-word", "burning-logs"]
        .map(|name| Settings::of_preset(name).unwrap_or_else(|errors| panic!("{errors:?}")));
    let solids_of = |scene: &Scene| -> Vec<bool> {
        scene
            .sources()
            .map(|source| scene.solid_of(source).is_some())
            .collect()
    };
    assert!(solids_of(first.scene()).contains(&true));
    let other = after(&second, Change::Preset("burning-word"));
    let count = second.scene().objects().len() as u32;
    assert!(other.scene().objects().all(|object| object.id > count));
    assert_eq!(solids_of(other.scene()), solids_of(first.scene()));
    assert_eq!(in_order(other.scene()), *first.scene());
    for name in ["rope", "curtains"] {
        let hanging = after(&second, Change::Preset(name));
        let of_preset = Settings::of_preset(name).map(|preset| preset.scene().clone());
        assert_eq!(Ok(in_order(hanging.scene())), of_preset);
    }
    // A file numbers them from 1, and is a scene, too.
    assert_eq!(export(&other), export(&first));
    let moved = set(&other, "source_x", number(0.2));
    let opened = imported(&second, &export(&moved));
    assert_eq!(in_order(opened.scene()), in_order(moved.scene()));
    assert!(opened.scene().objects().all(|object| object.id > count));
    // The same objects again keep their ids.
    for again in [
        after(&other, Change::Preset("burning-word")),
        imported(&other, &export(&other)),
        imported(&set(&other, "wind", number(0.3)), &export(&other)),
    ] {
        assert_eq!(again, other);
    }
    assert_ne!(
        ids(after(&moved, Change::Preset("burning-word")).scene()),
        ids(moved.scene())
    );
}

#[test]
fn an_object_of_a_list_without_an_id_is_the_one_in_its_place() {
    let [source, solid] = ["source", "solid"].map(|kind| object([("kind", text(kind))]));
    let set_all = |settings: &Settings, list: &[&Untrusted]| {
        let list = list.iter().map(|object| (*object).clone()).collect();
        set(settings, OBJECTS, Untrusted::List(list))
    };
    let page = set_all(
        &after(&Settings::default(), Change::Preset("candle")),
        &[&source, &solid],
    );
    let both = ids(page.scene());
    assert_eq!(ids(set_all(&page, &[&source, &solid]).scene()), both);
    let surface = object([
        ("kind", text("source")),
        ("shape", text("solid")),
        ("solid", number(1.0)),
    ]);
    let other = set_all(&page, &[&solid, &surface]);
    assert!(other.scene().objects().all(|object| {
        object.id
            > page
                .scene()
                .objects()
                .map(|known| known.id)
                .max()
                .unwrap_or_default()
    }));
    let mut sources = other.scene().sources();
    assert!(sources.all(|source| other.scene().solid_of(source).is_some()));
    assert_eq!(ids(set(&page, OBJECTS, Untrusted::Null).scene()), both[..1]);
}
