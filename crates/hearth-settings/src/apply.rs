//! Untrusted values and objects applied to a scene.

use crate::untrusted::{Ids, Untrusted, ValidationError, Values, one_of};
use hearth_core::params::{Input, Model, ParamError, Parameters};
use hearth_core::preset::Preset;
use hearth_core::scene::{Object, Scene};

/// The id of the model.
const MODEL: &str = "model";

/// The name of the list of objects among values.
pub const OBJECTS: &str = "objects";

/// The name of the values in settings.
const VALUES: &str = "values";

/// The required form of a list of objects.
const A_LIST: &str = "an array of objects, each with a kind and its properties";

/// `scene` with these values, all of them or none. The value of `objects` replaces the objects.
/// Of `objects` and a parameter of the first source, the later one wins.
///
/// # Errors
/// Every invalid value.
pub(crate) fn with_values(
    scene: &Scene,
    values: Values<'_>,
) -> Result<Scene, Vec<ValidationError>> {
    changed(scene, values, false)
}

/// `scene` with the defaults of the parameters with these ids, all of them or none. The id
/// `objects` restores one source.
///
/// # Errors
/// Every unknown id.
pub(crate) fn with_defaults(scene: &Scene, ids: Ids<'_>) -> Result<Scene, Vec<ValidationError>> {
    let named = |id: &Untrusted| (id.text().to_owned(), Untrusted::Missing);
    changed(scene, &ids.iter().map(named).collect::<Vec<_>>(), true)
}

fn changed(
    scene: &Scene,
    values: Values<'_>,
    to_defaults: bool,
) -> Result<Scene, Vec<ValidationError>> {
    let mut new = scene.clone();
    let mut errors = Vec::new();
    change(&mut new, values, to_defaults, &mut errors);
    if errors.is_empty() {
        Ok(new)
    } else {
        Err(errors)
    }
}

/// `scene` with the `values` and `objects` of settings, all of them or none. If both set a
/// property of the first source, the later one wins.
///
/// # Errors
/// Every invalid value.
pub(crate) fn with_settings(
    scene: &Scene,
    config: Values<'_>,
) -> Result<Scene, Vec<ValidationError>> {
    let mut new = scene.clone();
    let mut errors = Vec::new();
    let present = scene.settings().model();
    for (field, values) in config {
        let mut models = [Model::Classic, Model::Combustion].into_iter();
        if let Some(model) = models.find(|model| model.name() == field) {
            let mut scene = Scene::new(of_model(new.settings(), model));
            change(&mut scene, values.fields(), false, &mut errors);
            new.set_settings(of_model(scene.settings(), present));
        }
    }
    // Values are applied first, because the model decides the properties of objects. Values
    // after the objects are applied again.
    let is_values = |(field, _): &&(String, Untrusted)| field == VALUES;
    for (field, value) in config.iter().filter(is_values).chain(config) {
        if field == VALUES {
            change(&mut new, value.fields(), false, &mut errors);
        } else if field == OBJECTS {
            replace(&mut new, value, &mut errors);
        }
        if !errors.is_empty() {
            return Err(errors);
        }
    }
    Ok(new)
}

/// Changes the model first, because it decides the domains of the other parameters.
fn change(
    scene: &mut Scene,
    values: Values<'_>,
    to_defaults: bool,
    errors: &mut Vec<ValidationError>,
) {
    let mut settings = scene.settings().clone();
    for of_model in [true, false] {
        for (id, value) in values {
            if (id == MODEL) != of_model {
                continue;
            }
            if id == OBJECTS {
                scene.set_settings(settings);
                if to_defaults {
                    *scene = Scene::new(scene.settings().clone());
                } else {
                    replace(scene, value, errors);
                }
                settings = scene.settings().clone();
                continue;
            }
            let changed = if to_defaults {
                settings.restore(id)
            } else {
                settings.set(id, value.input())
            };
            if let Err(error) = changed {
                errors.push(ValidationError::of_parameter(&error, value));
            }
        }
    }
    scene.set_settings(settings);
}

/// The same parameters, with `model` as the present model.
pub(crate) fn of_model(parameters: &Parameters, model: Model) -> Parameters {
    let mut parameters = parameters.clone();
    let set = parameters.set(MODEL, Input::Text(model.name()));
    debug_assert_eq!(set, Ok(()));
    parameters
}

/// Replaces all objects, or none.
fn replace(scene: &mut Scene, list: &Untrusted, errors: &mut Vec<ValidationError>) {
    let Untrusted::List(list) = list else {
        return errors.push(ValidationError::new(OBJECTS, list, A_LIST));
    };
    let mut new = scene.clone();
    new.clear();
    for object in list {
        let sent = object.fields();
        if let Err(refused) = new.add(&fields(sent)) {
            return errors.extend(refused.iter().map(|error| of_object(error, sent)));
        }
    }
    *scene = new;
}

/// `scene` with changed properties of an object or, without an id, with another object; without
/// fields, the object is removed.
///
/// # Errors
/// There is no object with this id, or every invalid field.
pub(crate) fn with_object(
    scene: &Scene,
    id: Option<u32>,
    sent: Option<Values<'_>>,
) -> Result<Scene, Vec<ValidationError>> {
    let mut new = scene.clone();
    let values = sent.unwrap_or_default();
    let fields = fields(values);
    let done = match (id, sent) {
        (None, _) => new.add(&fields).map(|_| ()),
        (Some(id), Some(_)) => new.change(id, &fields),
        (Some(id), None) => new.remove(id),
    };
    match done {
        Ok(()) => Ok(new),
        Err(refused) => {
            let errors = refused.iter().map(|error| of_object(error, values));
            Err(errors.collect())
        }
    }
}

/// The objects of a scene as data. With `from`, the first source has only the properties that
/// differ from these settings, the other objects those that differ from the defaults, and ids are left
/// out if they are 1, 2, 3 and so on.
pub fn objects(scene: &Scene, from: Option<&Parameters>) -> Untrusted {
    let counted = |(index, object): (usize, Object<'_>)| object.id as usize == index + 1;
    let with_ids = from.is_none() || !scene.objects().enumerate().all(counted);
    let list = scene.objects().map(|object| {
        let kind = Untrusted::Text(object.kind.name.into());
        let mut fields = vec![Untrusted::named("kind", kind)];
        if with_ids {
            fields.push(Untrusted::named("id", Untrusted::Number(object.id.into())));
        }
        let preset = from.filter(|_| object.is_first_source());
        for (name, param, value) in object.properties() {
            let before = match preset {
                Some(preset) => param.get(preset),
                None => param.any_domain(object.model()).default,
            };
            if from.is_none() || value != before {
                fields.push(Untrusted::named(name, Untrusted::of_value(value)));
            }
        }
        Untrusted::Object(fields)
    });
    Untrusted::List(list.collect())
}

fn fields<'a>(values: Values<'a>) -> Vec<(&'a str, Input<'a>)> {
    let fields = values.iter();
    fields
        .map(|(name, value)| (name.as_str(), value.input()))
        .collect()
}

/// The error of an object's field, with the sent value.
fn of_object(error: &ParamError, sent: Values<'_>) -> ValidationError {
    let mut named = sent.iter();
    let value = named.find(|(field, _)| error.id.ends_with(field.as_str()));
    ValidationError::of_parameter(error, value.map_or(&Untrusted::Missing, |(_, value)| value))
}

/// The preset with this name.
///
/// # Errors
/// There is no preset with this name. The message lists all.
pub fn preset(name: &str) -> Result<&'static Preset, ValidationError> {
    Preset::find(name).ok_or_else(|| {
        let mut names = Preset::all().iter().map(|preset| preset.name);
        one_of("preset", &Untrusted::Text(name.into()), &mut names)
    })
}
