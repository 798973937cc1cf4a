//! Scenes from what somebody sent: values by id and objects by their fields.

use hearth_core::params::{Input, ParamError};
use hearth_core::{Parameters, Scene};

use crate::message::{Refused, SentValues, model_first};
use crate::raw::Raw;

/// The name of the list of objects among values.
pub const OBJECTS: &str = "objects";

/// What an object must be.
const AN_OBJECT: &str = "an object with a kind and its properties";
/// What a list of objects must be.
const A_LIST: &str = "an array of objects, each with a kind and its properties";

/// Sets these values of a scene, all of them or none. The model comes first, wherever it
/// stands. `objects` among them replaces the objects; of it and a parameter of the first
/// source the later one counts.
///
/// # Errors
/// Every value that is refused.
pub fn set(scene: &mut Scene, values: &[(String, Raw)]) -> Result<(), Vec<Refused>> {
    set_parameters(scene, values)?;
    let Some(at) = values.iter().position(|(id, _)| id == OBJECTS) else {
        return Ok(());
    };
    let (list, later) = (values.get(at), values.get(at..).unwrap_or_default());
    replace(scene, list.map_or(&Raw::Missing, |(_, list)| list))?;
    set_parameters(scene, later)
}

/// Puts parameters of a scene back to their defaults, all of them or none. The model
/// comes first, here too; `objects` stands for the objects.
///
/// # Errors
/// Every id that is not known.
pub fn restore(scene: &mut Scene, ids: &[String]) -> Result<(), Vec<Refused>> {
    let mut settings = scene.settings().clone();
    let mut refused = Vec::new();
    for id in model_first(ids, |id| id) {
        if id == OBJECTS {
            *scene = Scene::new(settings.clone());
        } else if let Err(error) = settings.restore(id) {
            refused.push(of_error(&error, Raw::Missing));
        }
    }
    scene.set_settings(settings);
    nothing(refused)
}

/// Changes the object of that id or, without an id, adds one; without fields, removes it.
///
/// # Errors
/// There is no such object, or every field that is refused.
pub fn edit(
    scene: &mut Scene,
    id: Option<u32>,
    sent: Option<&SentValues>,
) -> Result<(), Vec<Refused>> {
    let nothing = Vec::new();
    let sent_fields = sent.unwrap_or(&nothing);
    let fields = fields(sent_fields);
    let done = match (id, sent) {
        (None, _) => scene.add(&fields).map(|_| ()),
        (Some(id), Some(_)) => scene.change(id, &fields),
        (Some(id), None) => scene.remove(id),
    };
    done.map_err(|errors| of_objects(&errors, sent_fields))
}

/// The objects of a scene as data. `from`, where it is given, is the settings that the
/// first one starts from: then only what differs from these or, of others, from the
/// defaults is there, and ids only where they would be other ones without.
pub fn objects(scene: &Scene, from: Option<&Parameters>) -> Raw {
    let counted = |(index, (id, ..)): (usize, (u32, _, _))| id as usize == index + 1;
    let with_ids = from.is_none() || !scene.objects().enumerate().all(counted);
    let mut defaults = None;
    let list = scene
        .objects()
        .enumerate()
        .map(|(index, (id, kind, values))| {
            let mut fields = vec![("kind".to_owned(), Raw::Text(kind.name.to_owned()))];
            if with_ids {
                fields.push(("id".to_owned(), Raw::Number(id.into())));
            }
            let model = values.model();
            let from = match index {
                0 => from,
                _ => from.map(|_| &*defaults.get_or_insert_with(|| Parameters::new(model))),
            };
            for property in kind.properties {
                if let Some(param) = property.param(model) {
                    let value = param.get(values);
                    if from.is_none_or(|from| param.get(from) != value) {
                        fields.push(Raw::named(property.name, Raw::of_value(value)));
                    }
                }
            }
            Raw::Object(fields)
        });
    Raw::List(list.collect())
}

fn nothing(refused: Vec<Refused>) -> Result<(), Vec<Refused>> {
    if refused.is_empty() {
        Ok(())
    } else {
        Err(refused)
    }
}

/// Sets the parameters among `values`.
#[inline(never)]
fn set_parameters(scene: &mut Scene, values: &[(String, Raw)]) -> Result<(), Vec<Refused>> {
    let mut settings = scene.settings().clone();
    let parameters = values.iter().filter(|(id, _)| id != OBJECTS);
    let set = settings.set_all(parameters.map(|(id, raw)| (id.as_str(), raw.input())));
    scene.set_settings(settings);
    set.map_err(|errors| {
        let refused = errors.iter().map(|error| {
            // An unknown id may be cut in the error.
            let sent = values.iter().find(|(id, _)| *id == error.id);
            of_error(error, sent.map_or(Raw::Missing, |(_, raw)| raw.clone()))
        });
        refused.collect()
    })
}

/// Replaces all objects.
fn replace(scene: &mut Scene, list: &Raw) -> Result<(), Vec<Refused>> {
    let Raw::List(list) = list else {
        return Err(vec![Refused::field(OBJECTS, list, A_LIST)]);
    };
    let mut objects = Vec::new();
    let mut sent = Vec::new();
    for one in list {
        let Raw::Object(object) = one else {
            return Err(vec![Refused::field(OBJECTS, one, AN_OBJECT)]);
        };
        objects.push(fields(object));
        sent.extend_from_slice(object);
    }
    let replaced = scene.replace(&objects.iter().map(Vec::as_slice).collect::<Vec<_>>());
    replaced.map_err(|errors| of_objects(&errors, &sent))
}

#[inline(never)]
fn fields(object: &SentValues) -> Vec<(&str, Input<'_>)> {
    let fields = object
        .iter()
        .map(|(name, raw)| (name.as_str(), raw.input()));
    fields.collect()
}

/// Refusals of fields of objects, with the values that were sent for them.
#[inline(never)]
fn of_objects(errors: &[ParamError], sent: &SentValues) -> Vec<Refused> {
    let refused = errors.iter().map(|error| {
        let mut named = sent
            .iter()
            .filter(|(field, _)| error.id.ends_with(field.as_str()));
        let sent = named.find(|(_, raw)| raw.input().to_string() == error.value);
        of_error(error, sent.map_or(Raw::Missing, |(_, raw)| raw.clone()))
    });
    refused.collect()
}

#[inline(never)]
fn of_error(error: &ParamError, value: Raw) -> Refused {
    Refused {
        id: error.id.clone(),
        value,
        message: error.to_string(),
        range: error.range(),
    }
}
