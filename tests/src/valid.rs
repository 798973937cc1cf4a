//! The law of every decoder: a scene that it accepts has only values that its tables accept.

use hearth_core::Scene;
use hearth_core::params::{AnyValue, Input, PARAMETERS};
use hearth_core::scene::MAX_OBJECTS;

/// Every value of a scene is one that its own table accepts and reads back, and the scene has a legal size.
pub fn is_valid(scene: &Scene) {
    assert!(scene.sources().count() <= MAX_OBJECTS);
    assert!(scene.solids().count() <= MAX_OBJECTS);
    let mut copy = Scene::of_model(scene.model());
    copy.clear();
    let used = PARAMETERS
        .iter()
        .filter(|param| param.domain(scene.model()).is_some());
    for param in used {
        if let Some(value) = scene.world().get(param.id) {
            let words = value.to_string();
            assert_eq!(copy.set(param.id, input(value, &words)), Ok(()));
        }
    }
    for object in scene.objects() {
        let words: Vec<_> = object
            .properties()
            .map(|property| (property.0, property.2, property.2.to_string()))
            .collect();
        let properties = words
            .iter()
            .filter(|(.., words)| !words.is_empty())
            .map(|(name, value, words)| (*name, input(*value, words)));
        let identity = [
            ("kind", Input::Text(object.kind.name)),
            ("id", Input::Number(object.id.into())),
        ];
        let fields: Vec<_> = identity.into_iter().chain(properties).collect();
        assert_eq!(copy.add(&fields), Ok(object.id));
    }
    assert_eq!(&copy, scene);
}

/// A value as a page sends it, given its text.
fn input<'a>(value: AnyValue<'_>, words: &'a str) -> Input<'a> {
    match value {
        AnyValue::Flag(on) => Input::Flag(on),
        other => other.as_number().map_or(Input::Text(words), Input::Number),
    }
}
