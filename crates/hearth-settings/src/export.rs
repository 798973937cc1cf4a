//! Settings as a [settings file](crate::file).

use crate::apply::{MODEL, OBJECTS, objects, short_objects};
use crate::children::child::Child;
use crate::file::{CHILDREN, LIST, VERSION};
use crate::settings::Settings;
use crate::untrusted::Untrusted;
use hearth_core::Scene;
use hearth_core::params::PARAMETERS;
use hearth_core::preset::Preset;
use hearth_core::scene::Object;

/// Whether at most properties of the first source differ from the objects of a scene.
fn has_objects_of(now: &Scene, before: &Scene) -> bool {
    let first = now
        .first_source_id()
        .filter(|first| before.first_source_id() == Some(*first));
    let is_first = |object: &Object<'_>| first == Some(object.id);
    now.objects().len() == before.objects().len()
        && now.objects().zip(before.objects()).all(|(now, before)| {
            now == before || now.id == before.id && is_first(&now) && now.name() == before.name()
        })
}

/// Writes settings as a settings file: the differences from the preset, as the fire that burns has them. Of the
/// objects, a file lists all, or none if only properties of the first source differ, which are values then.
pub fn export(settings: &Settings) -> Untrusted {
    let (scene, base) = (settings.scene(), settings.base());
    let lists_objects = !has_objects_of(scene, &base);
    let mut values = Vec::new();
    for param in PARAMETERS {
        if param.only_in(scene.model()).is_some() || lists_objects && param.is_of_objects() {
            continue;
        }
        let value = scene.value(param);
        let before = match param.id {
            MODEL => settings.preset().world().get(MODEL),
            _ => Some(base.value(param)),
        };
        let is_stated = settings.states(param.id);
        let differs = is_stated.unwrap_or(Some(value) != before);
        if differs {
            values.push(Untrusted::field_of(param.id, Untrusted::of_value(value)));
        }
    }
    let mut fields = vec![Untrusted::field_of(
        "hearth",
        Untrusted::Number(VERSION.into()),
    )];
    if settings.preset != Preset::all()[0].name {
        let name = Untrusted::Text(settings.preset.to_owned());
        fields.push(Untrusted::field_of("preset", name));
    }
    fields.push(Untrusted::field_of("values", Untrusted::Object(values)));
    if lists_objects {
        fields.push(Untrusted::field_of(OBJECTS, short_objects(scene)));
    }
    Untrusted::Object(fields)
}

/// The children of the element, as [whole] settings have them.
pub fn children(settings: &Settings) -> Untrusted {
    Untrusted::List(settings.children.iter().map(Child::write).collect())
}

/// Writes settings as a settings file with all values, all objects and the children of the element, which
/// [deltas](crate::delta) keep up to date.
pub fn whole(settings: &Settings) -> Untrusted {
    let world = settings.page.world();
    let values = PARAMETERS.iter().filter_map(|param| {
        let value = world.get(param.id)?;
        let is_listed = param.only_in(world.model()).is_none();
        let is_stated = settings.states(param.id) != Some(false);
        (is_listed && is_stated).then(|| Untrusted::field_of(param.id, Untrusted::of_value(value)))
    });
    Untrusted::Object(vec![
        Untrusted::field_of("hearth", Untrusted::Number(VERSION.into())),
        Untrusted::field_of("preset", Untrusted::Text(settings.preset.to_owned())),
        Untrusted::field_of("values", Untrusted::Object(values.collect())),
        Untrusted::field_of(OBJECTS, objects(&settings.page)),
        Untrusted::field_of(CHILDREN, children(settings)),
        Untrusted::field_of(LIST, Untrusted::Number(settings.list.into())),
    ])
}
