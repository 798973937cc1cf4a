//! Untrusted values and objects applied to a scene.

use crate::untrusted::{Untrusted, ValidationError, Values};
use hearth_core::params::{AnyValue, Input, Param, ParamError};
use hearth_core::preset::Preset;
use hearth_core::scene::{MAX_ID, Object, Scene};

/// The id of the model.
pub(crate) const MODEL: &str = "model";

/// The name of the list of objects among values.
pub const OBJECTS: &str = "objects";

/// The required form of a list of objects.
const A_LIST: &str = "an array of objects, each with a kind and its properties";

/// Applies values to a scene, and appends an error for each that is refused: the model first, because it decides the
/// domains of the others, then `objects`, then the others, which may be properties of the first source. `null`
/// restores a default, which another model has anyway; that of `objects` is one source.
pub(crate) fn set_values(scene: &mut Scene, values: Values<'_>, errors: &mut Vec<ValidationError>) {
    let rank = |id: &str| {
        [MODEL, OBJECTS]
            .iter()
            .position(|first| id == *first)
            .unwrap_or(2)
    };
    for turn in 0..=2 {
        let stated = values
            .iter()
            .filter(|(id, value)| rank(id) == turn && !value.is_missing());
        for (id, value) in stated {
            if id == OBJECTS {
                replace_objects(scene, value, errors);
            } else if matches!(value, Untrusted::Null) && is_of_other_model(scene, id) {
                // It has its default, which that model gets.
            } else if let Err(error) = scene.set(id, input(value)) {
                errors.push(ValidationError::of_parameter(&error, value));
            }
        }
    }
}

/// Whether only another model than that of the scene has the parameter.
pub(crate) fn is_of_other_model(scene: &Scene, id: &str) -> bool {
    Param::find(id).is_some_and(|param| param.only_in(scene.model()).is_some())
}

/// Whether another model starts a parameter of the scene from its own default.
pub(crate) fn starts_with_model(scene: &Scene, id: &str) -> bool {
    let param = Param::find(id).filter(|param| param.domain(scene.model()).is_some());
    param.is_some_and(|param| param.domains.iter().all(|domain| domain.model.is_some()))
}

/// Replaces all objects, or none.
fn replace_objects(scene: &mut Scene, list: &Untrusted, errors: &mut Vec<ValidationError>) {
    let mut new = scene.clone();
    new.clear();
    match list {
        Untrusted::Null => new = Scene::new(scene.world().clone()),
        Untrusted::List(list) => {
            for object in list {
                let sent = object.fields();
                if let Err(refused) = new.add(&fields(sent)) {
                    return errors.extend(refused.iter().map(|error| of_object(error, sent)));
                }
            }
        }
        _ => return errors.push(ValidationError::new(OBJECTS, list, A_LIST)),
    }
    *scene = new;
}

/// The objects of a scene as data, each with the properties that `are_listed`. Unless `with_ids`, ids are left out if
/// they are 1, 2, 3 and so on.
fn list(
    scene: &Scene,
    with_ids: bool,
    are_listed: &dyn Fn(&Object<'_>, &'static Param, AnyValue<'_>) -> bool,
) -> Untrusted {
    let counted = |(index, object): (usize, Object<'_>)| object.id as usize == index + 1;
    let with_ids = with_ids || !scene.objects().enumerate().all(counted);
    let list = scene.objects().map(|object| {
        let mut fields = Vec::new();
        put_head(&mut fields, &object, with_ids);
        for (name, param, value) in object.properties() {
            if are_listed(&object, param, value) {
                fields.push(Untrusted::field_of(name, Untrusted::of_value(value)));
            }
        }
        Untrusted::Object(fields)
    });
    Untrusted::List(list.collect())
}

/// Appends the kind of an object and, `with_id`, its id.
pub(crate) fn put_head(fields: &mut Vec<(String, Untrusted)>, object: &Object<'_>, with_id: bool) {
    fields.push(Untrusted::field_of(
        "kind",
        Untrusted::Text(object.kind.name.into()),
    ));
    if with_id {
        fields.push(Untrusted::field_of(
            "id",
            Untrusted::Number(object.id.into()),
        ));
    }
}

/// The objects of a scene with all their properties and ids.
pub fn objects(scene: &Scene) -> Untrusted {
    list(scene, true, &|_, _, _| true)
}

/// The objects of a scene with the properties that differ from the defaults.
pub(crate) fn short_objects(scene: &Scene) -> Untrusted {
    list(scene, false, &|object, param, value| {
        value != param.any_domain(object.model()).default
    })
}

/// The fields that are stated.
pub(crate) fn fields<'a>(values: Values<'a>) -> Vec<(&'a str, Input<'a>)> {
    let stated = values.iter().filter(|(_, value)| !value.is_missing());
    stated
        .map(|(name, value)| (name.as_str(), input(value)))
        .collect()
}

/// A value as input. `null` restores the default.
pub(crate) fn input(value: &Untrusted) -> Input<'_> {
    match value {
        Untrusted::Null => Input::Default,
        _ => value.input(),
    }
}

/// The error of an object's field, with the sent value.
pub(crate) fn of_object(error: &ParamError, sent: Values<'_>) -> ValidationError {
    let mut named = sent.iter();
    let value = named.find(|(field, _)| error.id.ends_with(field.as_str()));
    ValidationError::of_parameter(error, value.map_or(&Untrusted::Missing, |(_, value)| value))
}

/// The preset with this name.
///
/// # Errors
/// There is no preset with this name.
pub fn preset(name: &str) -> Result<&'static Preset, ValidationError> {
    Preset::find(name).map_err(|error| ValidationError {
        id: "preset".into(),
        value: Untrusted::Text(name.into()).summary(),
        message: format!("{error}"),
        range: None,
    })
}

/// The smallest id from this one on that is larger than those of a scene. Beyond the largest id, ids of gone objects are
/// given again.
pub(crate) fn free_id(scene: &Scene, from: u32) -> u32 {
    let next = scene.ids().fold(from, |next, id| next.max(id + 1));
    let is_free = |id: &u32| scene.object(*id).is_none();
    match next <= MAX_ID {
        true => next,
        false => (1..MAX_ID).find(is_free).unwrap_or(MAX_ID),
    }
}
