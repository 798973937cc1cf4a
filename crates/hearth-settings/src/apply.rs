//! Untrusted values and objects applied to a scene.

use crate::untrusted::{Untrusted, ValidationError, Values, one_of};
use hearth_core::params::{AnyValue, Input, Model, Param, ParamError, Parameters};
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
/// Of `objects` and a parameter of the first source, the later one wins. `null` restores a default; that of
/// `objects` is one source.
///
/// # Errors
/// Every invalid value and every unknown id.
pub(crate) fn with_values(
    scene: &Scene,
    values: Values<'_>,
) -> Result<Scene, Vec<ValidationError>> {
    let mut new = scene.clone();
    let mut errors = Vec::new();
    change(&mut new, values, &mut errors);
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
            change(&mut scene, values.fields(), &mut errors);
            new.set_settings(of_model(scene.settings(), present));
        }
    }
    // Values are applied first, because the model decides the properties of objects. Values
    // after the objects are applied again.
    let is_values = |(field, _): &&(String, Untrusted)| field == VALUES;
    for (field, value) in config.iter().filter(is_values).chain(config) {
        if field == VALUES {
            change(&mut new, value.fields(), &mut errors);
        } else if field == OBJECTS && !value.is_missing() {
            replace::<true>(&mut new, value, &mut errors);
        }
        if !errors.is_empty() {
            return Err(errors);
        }
    }
    Ok(new)
}

/// Changes the model first, because it decides the domains of the other parameters.
fn change(scene: &mut Scene, values: Values<'_>, errors: &mut Vec<ValidationError>) {
    let mut settings = scene.settings().clone();
    for of_model in [true, false] {
        for (id, value) in values {
            if (id == MODEL) != of_model || value.is_missing() {
                continue;
            }
            if id == OBJECTS {
                scene.set_settings(settings);
                if matches!(value, Untrusted::Null) {
                    *scene = Scene::new(scene.settings().clone());
                } else {
                    replace::<false>(scene, value, errors);
                }
                settings = scene.settings().clone();
                continue;
            }
            if let Err(error) = settings.set(id, input(value)) {
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

/// The other one of the two models.
pub(crate) fn other_model(model: Model) -> Model {
    match model {
        Model::Classic => Model::Combustion,
        Model::Combustion => Model::Classic,
    }
}

/// Replaces all objects, or none. Those of a file may have fields with the names of the models: the properties that they
/// have for each.
fn replace<const OF_FILE: bool>(
    scene: &mut Scene,
    list: &Untrusted,
    errors: &mut Vec<ValidationError>,
) {
    let Untrusted::List(list) = list else {
        return errors.push(ValidationError::new(OBJECTS, list, A_LIST));
    };
    let model = scene.settings().model();
    let models = [Model::Classic, Model::Combustion];
    let mut new = scene.clone();
    new.clear();
    for object in list {
        let sent = object.fields();
        let mut own = fields(sent);
        if OF_FILE {
            own.retain(|(name, _)| models.iter().all(|model| model.name() != *name));
        }
        let mut added = new.add(&own);
        for own in models.into_iter().filter(|_| OF_FILE) {
            let of_own = fields(object.field(own.name()).fields());
            if let (false, &Ok(id)) = (of_own.is_empty(), &added) {
                new.set_settings(of_model(new.settings(), own));
                added = new.change(id, &of_own).map(|()| id);
                new.set_settings(of_model(new.settings(), model));
            }
        }
        if let Err(refused) = added {
            return errors.extend(refused.iter().map(|error| of_object(error, sent)));
        }
    }
    *scene = new;
}

/// `scene` with changed properties of an object or, without an id, with another object, whose id is `next` unless it
/// states one; without fields, the object is removed.
///
/// # Errors
/// There is no object with this id, or every invalid field.
pub(crate) fn with_object(
    scene: &Scene,
    id: Option<u32>,
    sent: Option<Values<'_>>,
    next: u32,
) -> Result<Scene, Vec<ValidationError>> {
    let mut new = scene.clone();
    let values = sent.unwrap_or_default();
    let mut fields = fields(values);
    if id.is_none() && fields.iter().all(|(name, _)| *name != "id") {
        fields.push(("id", Input::Number(next.into())));
    }
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
/// differ from these settings, the other objects those that differ from the defaults, in a field with the name of
/// the other model those that a source has for it. Unless `with_ids`, ids are left out if they are 1, 2, 3 and so on.
/// With both, properties of the present model alone are in a field with its name, so that they mean the same in the
/// other one; those of the first source are among the settings.
pub fn objects(scene: &Scene, from: Option<&Parameters>, with_ids: bool) -> Untrusted {
    let is_apart = with_ids && from.is_some();
    let counted = |(index, object): (usize, Object<'_>)| object.id as usize == index + 1;
    let with_ids = with_ids || !scene.objects().enumerate().all(counted);
    let model = scene.settings().model();
    let other = other_model(model);
    let in_other = from.map(|_| {
        let mut scene = scene.clone();
        scene.set_settings(of_model(scene.settings(), other));
        scene
    });
    let list = scene.objects().enumerate().map(|(index, object)| {
        let kind = Untrusted::Text(object.kind.name.into());
        let mut fields = vec![Untrusted::named("kind", kind)];
        if with_ids {
            fields.push(Untrusted::named("id", Untrusted::Number(object.id.into())));
        }
        let first = from.filter(|_| object.is_first_source());
        let of_model = |param: &Param, model| {
            let domain = param.domain(model);
            domain.filter(|domain| domain.model.is_some())
        };
        let differs = |param: &'static Param, value: AnyValue<'_>| {
            let domain = param.any_domain(object.model());
            let before = first.map_or(domain.default, |first| param.get(first));
            from.is_none() || value != before
        };
        put_properties(&mut fields, &object, &|param, value| {
            differs(param, value) && !(is_apart && of_model(param, model).is_some())
        });
        let mut of_own = Vec::new();
        put_properties(&mut of_own, &object, &|param, value| {
            is_apart && first.is_none() && differs(param, value) && of_model(param, model).is_some()
        });
        let twin = in_other
            .as_ref()
            .and_then(|scene| scene.objects().nth(index));
        let mut of_other = Vec::new();
        if let Some(twin) = twin.filter(|_| first.is_none()) {
            put_properties(&mut of_other, &twin, &|param, value| {
                of_model(param, other).is_some_and(|domain| value != domain.default)
            });
        }
        for (model, of_model) in [(model, of_own), (other, of_other)] {
            if !of_model.is_empty() {
                fields.push(Untrusted::named(model.name(), Untrusted::Object(of_model)));
            }
        }
        Untrusted::Object(fields)
    });
    Untrusted::List(list.collect())
}

/// Appends the properties of an object that `are_listed`.
#[inline(never)]
fn put_properties(
    fields: &mut Vec<(String, Untrusted)>,
    object: &Object<'_>,
    are_listed: &dyn Fn(&'static Param, AnyValue<'_>) -> bool,
) {
    for (name, param, value) in object.properties() {
        if are_listed(param, value) {
            fields.push(Untrusted::named(name, Untrusted::of_value(value)));
        }
    }
}

/// The fields that are stated.
pub(crate) fn fields<'a>(values: Values<'a>) -> Vec<(&'a str, Input<'a>)> {
    let mut stated = Vec::with_capacity(values.len());
    for (name, value) in values {
        if !value.is_missing() {
            stated.push((name.as_str(), input(value)));
        }
    }
    stated
}

/// A value as input. `null` restores the default.
fn input(value: &Untrusted) -> Input<'_> {
    match value {
        Untrusted::Null => Input::Default,
        _ => value.input(),
    }
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
