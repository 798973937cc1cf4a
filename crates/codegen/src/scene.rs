//! The scenes: a file of `scenes/` each, checked before anything is generated.
//!
//! `{"hearth": 3, "label": "Candle", "description": "One sentence.", "values": {…},
//! "objects": [{"kind": "source", …}]}`, and the file's name is the scene's. Such a file is
//! also a settings file, as the element's `src` takes it. Without `objects`, a scene has one source.
//!
//! A file of `scenes/community/` names its `author` and its `licence` too. No preset follows from it: the gallery shows it.

use std::fmt;
use std::path::Path;

use anyhow::{Context, Result, bail, ensure};
use hearth_core::params::{AnyValue, Input, Model, PARAMETERS, Parameters};
use hearth_core::scene::Kind;
use serde::de::{Deserialize, Deserializer, Error, MapAccess, Visitor};
use serde_json::Value;

use xshell::Shell;

/// The scene of a new fire.
const DEFAULT: &str = "default";

/// Longest name and label; they stand on buttons.
const LONGEST_NAME: usize = 24;
/// Longest description: two lines at most.
const LONGEST_DESCRIPTION: usize = 140;
/// Longest author and licence.
const LONGEST_CREDIT: usize = 40;
/// Largest file of `scenes/community/` \[bytes\].
const LARGEST: usize = 64_000;

/// A named fire.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Its name in attributes and URLs.
    pub name: String,
    /// Its name for people.
    pub label: String,
    /// What there is to see, in a sentence.
    pub description: String,
    /// Author and licence; the project's own presets name neither.
    pub credit: Option<[String; 2]>,
    pub(super) model: Model,
    /// The parameters of the world that differ from the defaults, in the order of the table.
    pub(super) values: Vec<(String, Value)>,
    /// The fields of the objects.
    pub(super) objects: Vec<Vec<(String, Value)>>,
}

/// A scene's file.
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    hearth: u32,
    label: String,
    description: String,
    author: Option<String>,
    licence: Option<String>,
    values: Fields,
    #[serde(default)]
    objects: Vec<Fields>,
}

/// The fields of an object in the order of the file. A map would keep the last of two
/// fields of one name and report nothing.
struct Fields(Vec<(String, Value)>);

impl<'de> Deserialize<'de> for Fields {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Fields, D::Error> {
        struct Object;
        impl<'de> Visitor<'de> for Object {
            type Value = Fields;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object of parameters")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Fields, A::Error> {
                let mut fields: Vec<(String, Value)> = Vec::new();
                while let Some((name, value)) = map.next_entry::<String, Value>()? {
                    if fields.iter().any(|(known, _)| *known == name) {
                        return Err(A::Error::custom(format!("duplicate field `{name}`")));
                    }
                    let value = value.as_f64().map_or(value, super::number);
                    fields.push((name, value));
                }
                Ok(Fields(fields))
            }
        }
        deserializer.deserialize_map(Object)
    }
}

impl Scene {
    /// Its fire.
    ///
    /// # Errors
    /// The tables refuse a value, or the model does not use it.
    pub fn scene(&self) -> Result<hearth_core::Scene> {
        let mut parameters = Parameters::default();
        for (id, value) in &self.values {
            parameters.set(id, input(value))?;
        }
        let mut scene = hearth_core::Scene::new(parameters);
        scene.clear();
        for object in &self.objects {
            let fields = object
                .iter()
                .map(|(name, value)| (name.as_str(), input(value)));
            if let Err(errors) = scene.add(&fields.collect::<Vec<_>>()) {
                bail!(errors[0].clone());
            }
            // A fire reports the canonical text, which pages compare with that of the file.
            let added = scene.objects().last();
            for (name, _, value) in added.into_iter().flat_map(|object| object.properties()) {
                if let AnyValue::Text(text) = value {
                    let given = object.iter().find(|(field, _)| field == name);
                    let given = given.and_then(|(_, value)| value.as_str());
                    ensure!(
                        given.is_none_or(|given| given == text),
                        "{name} is not written as {text}"
                    );
                }
            }
        }
        Ok(scene)
    }

    /// Its values, and those of the first source by the ids of their parameters, in the order of the table.
    pub(super) fn all_values(&self) -> Vec<(&'static str, Value)> {
        let source = |(_, kind): &&(String, Value)| kind == Kind::SOURCE.name;
        let mut objects = self.objects.iter();
        let first = objects.find(|object| object.first().as_ref().is_some_and(source));
        let all = PARAMETERS.iter().filter_map(|param| {
            let named = |(name, _): &&(String, Value)| *name == param.id;
            let property = |(name, _): &&(String, Value)| name == param.property;
            let of_source = || first?.iter().find(property);
            let (_, value) = self.values.iter().find(named).or_else(of_source)?;
            Some((param.id, value.clone()))
        });
        all.collect()
    }
}

fn input(value: &Value) -> Input<'_> {
    match value {
        Value::Number(number) => Input::Number(number.as_f64().unwrap_or(f64::NAN)),
        Value::String(text) => Input::Text(text),
        Value::Bool(on) => Input::Flag(*on),
        // Which no parameter accepts.
        Value::Object(_) => Input::Text("an object"),
        Value::Array(_) => Input::Text("a list"),
        Value::Null => Input::Text("null"),
    }
}

/// Every scene under `folder`: the default one first, then those of each model by their
/// names, the default model's first. Fails at the first wrong file, with its name.
pub(super) fn read_all(folder: &Path) -> Result<Vec<Scene>> {
    let sh = Shell::new()?;
    let mut scenes = Vec::new();
    for path in sh.read_dir(folder)?.iter().filter(|path| path.is_file()) {
        let file = path.file_name().unwrap_or_default().to_string_lossy();
        let scene = parse(&file, &sh.read_file(path)?).and_then(|scene| {
            ensure!(
                scene.credit.is_none(),
                "only a scene of community/ has an author"
            );
            Ok(scene)
        });
        scenes.push(scene.with_context(|| format!("scenes/{file}"))?);
    }
    scenes.sort_by_key(|scene| {
        let place = (scene.name != DEFAULT, scene.model != Model::DEFAULT);
        (place, scene.name.clone())
    });
    ensure!(
        scenes.first().is_some_and(|scene| scene.name == DEFAULT),
        "scenes/{DEFAULT}.json is missing"
    );
    for (at, scene) in scenes.iter().enumerate() {
        let (name, label) = (&scene.name, &scene.label);
        if let Some(twin) = scenes[..at].iter().find(|other| other.label == *label) {
            let twin = &twin.name;
            bail!("scenes/{name}.json: {twin} has the label \"{label}\" too");
        }
    }
    Ok(scenes)
}

/// Every scene under `folder`/community, by their names. Their texts are shown to people, and their files are fetched.
pub(super) fn read_community(folder: &Path) -> Result<Vec<Scene>> {
    let sh = Shell::new()?;
    let mut known = read_all(folder)?;
    let presets = known.len();
    let paths = sh.read_dir(folder.join("community"))?;
    let end = Some("json".as_ref());
    for path in paths.iter().filter(|path| path.extension() == end) {
        let file = path.file_name().unwrap_or_default().to_string_lossy();
        let text = sh.read_file(path)?;
        let scene = given(&file, &text).and_then(|scene| {
            let twin = known
                .iter()
                .find(|it| it.name == scene.name || it.label == scene.label);
            ensure!(twin.is_none(), "another scene has its name or its label");
            Ok(scene)
        });
        known.push(scene.with_context(|| format!("scenes/community/{file}"))?);
    }
    Ok(known.split_off(presets))
}

/// A scene that somebody gives.
fn given(file: &str, text: &str) -> Result<Scene> {
    let size = text.len();
    ensure!(
        size <= LARGEST,
        "it has {size} bytes; at most {LARGEST} are allowed"
    );
    let scene = parse(file, text)?;
    ensure!(
        scene.credit.is_some(),
        "it needs an \"author\" and a \"licence\""
    );
    let objects = scene.objects.iter().flatten();
    let names = objects
        .filter(|(field, _)| field == "name")
        .filter_map(|(_, name)| name.as_str());
    let texts = [&scene.label, &scene.description]
        .into_iter()
        .chain(scene.credit.iter().flatten());
    for text in texts.map(String::as_str).chain(names) {
        let address = ["//", "www.", "<", ">"]
            .iter()
            .find(|part| text.contains(**part));
        ensure!(
            address.is_none(),
            "\"{text}\" must be words, without an address or a tag"
        );
    }
    Ok(scene)
}

/// The scene in a file of that name with that text.
fn parse(file: &str, text: &str) -> Result<Scene> {
    let name = file.strip_suffix(".json").filter(|name| is_name(name));
    let name = name.with_context(|| {
        format!(
            "the name of the file must be the scene's, of at most {LONGEST_NAME} lower-case \
             letters, digits and hyphens, and .json"
        )
    })?;
    let file: File = serde_json::from_str(text)?;
    ensure!(file.hearth == 3, "\"hearth\", the version, must be 3");
    for (field, text, longest) in [
        ("label", &file.label, LONGEST_NAME),
        ("description", &file.description, LONGEST_DESCRIPTION),
    ] {
        ensure!(
            is_line(text, longest),
            "\"{field}\" must be one line of at most {longest} characters"
        );
    }
    let credit = match (file.author, file.licence) {
        (None, None) => None,
        (author, licence) => Some([author.unwrap_or_default(), licence.unwrap_or_default()]),
    };
    for (field, text) in ["author", "licence"].iter().zip(credit.iter().flatten()) {
        ensure!(
            is_line(text, LONGEST_CREDIT),
            "\"{field}\" must be one line of at most {LONGEST_CREDIT} characters"
        );
    }
    let end = file.description.ends_with('.');
    ensure!(end, "\"description\" must end with its full stop");
    let Fields(mut values) = file.values;
    // The model comes first in the table, because it decides the ranges of the others.
    values.sort_by_key(|(id, _)| PARAMETERS.iter().position(|param| param.id == *id));
    ensure!(
        name != DEFAULT || values.is_empty() && file.objects.is_empty(),
        "the default scene has neither values nor objects: change the defaults in the table"
    );
    let mut objects: Vec<_> = file
        .objects
        .into_iter()
        .map(|Fields(object)| object)
        .collect();
    if objects.is_empty() {
        objects.push(vec![("kind".to_owned(), Kind::SOURCE.name.into())]);
    }
    for object in &mut objects {
        // The table of presets begins an object with its kind.
        object.sort_by_key(|(name, _)| name != "kind");
    }
    let mut scene = Scene {
        name: name.to_owned(),
        label: file.label,
        description: file.description,
        credit,
        model: Model::DEFAULT,
        values,
        objects,
    };
    scene.model = scene.scene()?.model();
    Ok(scene)
}

fn is_name(name: &str) -> bool {
    let mut words = name.split('-');
    let is_word = |word: &str| {
        let mut letters = word.bytes();
        !word.is_empty() && letters.all(|b| b.is_ascii_lowercase() || b.is_ascii_digit())
    };
    name.len() <= LONGEST_NAME && words.all(is_word)
}

fn is_line(text: &str, longest: usize) -> bool {
    let length = text.chars().count();
    (1..=longest).contains(&length) && text.trim() == text && !text.chars().any(char::is_control)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Why the file is refused; else the scene.
    fn outcome(file: &str, text: &str) -> String {
        match parse(file, text) {
            Ok(scene) => format!("accepted: {scene:?}"),
            Err(error) => format!("{error:#}"),
        }
    }

    /// A scene with these values.
    fn with(values: &str) -> String {
        format!(
            "{{\"hearth\": 3, \"label\": \"A\", \"description\": \"A fire.\", \"values\": {values}}}"
        )
    }

    /// The field `objects` with one source of these properties.
    fn source(properties: &str) -> String {
        format!("\"objects\": [{{\"kind\": \"source\"{properties}}}]")
    }

    #[test]
    fn a_scene_has_the_values_of_its_file_in_the_order_of_the_table() {
        let values = r#"{"palette": "gas", "wind": 1.0, "model": "combustion"}"#;
        let properties = r#", "power": 60}, {"kind": "solid", "x": 1"#;
        let text = with(&format!("{values}, {}", source(properties)));
        let values = [
            ("model".to_owned(), "combustion".into()),
            ("wind".to_owned(), 1.into()),
            ("palette".to_owned(), "gas".into()),
        ];
        let expected = Scene {
            name: "a-2".to_owned(),
            label: "A".to_owned(),
            description: "A fire.".to_owned(),
            credit: None,
            model: Model::Combustion,
            values: values.to_vec(),
            objects: vec![
                vec![
                    ("kind".to_owned(), "source".into()),
                    ("power".to_owned(), 60.into()),
                ],
                vec![
                    ("kind".to_owned(), "solid".into()),
                    ("x".to_owned(), 1.into()),
                ],
            ],
        };
        let ids = expected.all_values().into_iter().map(|(id, _)| id);
        assert!(ids.eq(["model", "fuel_power", "wind", "palette"]));
        assert_eq!(parse("a-2.json", &text).ok(), Some(expected));
    }

    #[test]
    fn a_wrong_scene_is_refused_with_the_reason() {
        for (values, named) in [
            (r#"{"wimd": 1}"#, "did you mean \"wind\"?"),
            (r#"{"wind": 9}"#, "it must be a number from -3 to 3"),
            (r#"{"wind": {}}"#, "wind = \"an object\""),
            (r#"{"wind": [1]}"#, "wind = \"a list\""),
            (r#"{"wind": null}"#, "wind = \"null\""),
            (r#"{"wind": 1, "wind": 1}"#, "duplicate field `wind`"),
            (r#"{"palette": "soot"}"#, "one of blackbody"),
            (r#"{"cooling_rate": 1}"#, "only the classic model has it"),
            (r#"{"fuel_power": 60}"#, "a property of the first source"),
            // In the range of the other model.
            (r#"{"max_particles": 100}"#, "from 200 to 100000"),
            (r#"{"max_particles": 100, "model": "classic"}"#, "accepted"),
            ("3", "expected an object of parameters"),
        ] {
            let outcome = outcome("a.json", &with(values));
            assert!(outcome.contains(named), "{values}: {outcome}");
        }
        for (objects, named) in [
            (source(r#", "x": 9"#), "objects[0].x = 9 is refused"),
            (source(r#", "pwer": 9"#), "objects[0].property = \"pwer\""),
            (source(r#", "x": 0, "x": 0"#), "duplicate field `x`"),
            (
                source(r#"}, {"kind": "solid", "x": 11"#),
                "objects[1].x = 11",
            ),
            (r#""objects": [{}, {}]"#.to_owned(), "objects[0].kind"),
        ] {
            let text = with(&format!("{{}}, {objects}"));
            let outcome = outcome("a.json", &text);
            assert!(outcome.contains(named), "{objects}: {outcome}");
        }
        let whole = with("{}");
        for (text, named) in [
            (String::new(), "EOF"),
            ("3".to_owned(), "invalid type: integer"),
            (
                r#"{"label": "A", "label": "B"}"#.to_owned(),
                "duplicate field",
            ),
            (whole.replace("label", "wind"), "unknown field `wind`"),
            (whole.replace("hearth", "preset"), "unknown field `preset`"),
            (whole.replace(": 3", ": 1"), "must be 3"),
            (whole.replace("\"A\"", "\" \""), "\"label\" must be"),
            (whole.replace("A fire.", ""), "\"description\" must"),
            (whole.replace("fire.", "fire"), "with its full stop"),
            (whole.replace("\"A\"", "1"), "expected a string"),
            (whole.replace(", \"values\": {}", ""), "missing field"),
        ] {
            let outcome = outcome("a.json", &text);
            assert!(outcome.contains(named), "{text}: {outcome}");
        }
        for file in [
            "a", "A.json", "a b.json", "-a.json", "a--.json", ".json", "é.json",
        ] {
            let outcome = outcome(file, &whole);
            assert!(outcome.contains("name of the file"), "{file}: {outcome}");
        }
        assert!(outcome("default.json", &with(r#"{"wind": 1}"#)).contains("neither values"));
    }

    #[test]
    fn a_scene_of_somebody_names_its_author_and_no_address() {
        let by = |author: &str| {
            let credit = format!("\"author\": \"{author}\", \"licence\": \"CC0\", \"values\"");
            with("{}").replace("\"values\"", &credit)
        };
        let named = format!("{{}}, {}", source(r#", "name": "www.a.example""#));
        let named = with(&named).replace(
            "\"values\"",
            "\"author\": \"A\", \"licence\": \"B\", \"values\"",
        );
        for (text, reason) in [
            (with("{}"), "needs an \"author\""),
            (
                by("A").replace("\"licence\": \"CC0\", ", ""),
                "\"licence\" must be",
            ),
            (by(" "), "\"author\" must be"),
            (by(&"a".repeat(41)), "\"author\" must be"),
            (by("https://a.example"), "without an address"),
            (by("<b>A</b>"), "without an address"),
            (
                by("A").replace("A fire.", "See //a.example."),
                "without an address",
            ),
            (named, "without an address"),
            (by("A") + &" ".repeat(64_000), "bytes"),
            (
                by("A").replace("\"values\"", "\"script\": \"\", \"values\""),
                "unknown field",
            ),
        ] {
            let refused = given("a.json", &text).err().map(|why| format!("{why:#}"));
            assert!(refused.is_some_and(|why| why.contains(reason)), "{reason}");
        }
        let scene = given("a.json", &by("Ada")).ok();
        assert_eq!(
            scene.and_then(|it| it.credit),
            Some(["Ada".to_owned(), "CC0".to_owned()])
        );
    }

    #[test]
    fn the_wrong_file_of_a_folder_is_named() -> Result<()> {
        let sh = Shell::new()?;
        let folder = sh.create_temp_dir()?;
        let folder = folder.path();
        let read = || read_all(folder).map(|all| all.len().to_string());
        let outcome = || read().unwrap_or_else(|error| format!("{error:#}"));
        assert_eq!(outcome(), "scenes/default.json is missing");
        sh.write_file(folder.join("default.json"), with("{}"))?;
        assert_eq!(outcome(), "1");
        sh.write_file(folder.join("b.json"), with(r#"{"wind": 4}"#))?;
        assert!(outcome().contains("scenes/b.json: wind = 4"));
        sh.write_file(folder.join("b.json"), with(r#"{"wind": 1}"#))?;
        assert_eq!(outcome(), "scenes/b.json: default has the label \"A\" too");
        sh.remove_path(folder.join("b.json"))?;
        let credit = with("{}").replace(
            "\"values\"",
            "\"author\": \"A\", \"licence\": \"B\", \"values\"",
        );
        sh.write_file(folder.join("community/c.json"), &credit)?;
        assert_eq!(outcome(), "1");
        let given = read_community(folder).err().map(|why| format!("{why:#}"));
        assert!(given.is_some_and(|why| why.contains("community/c.json: another scene has")));
        sh.write_file(folder.join("default.json"), credit)?;
        assert!(outcome().contains("only a scene of community/"));
        Ok(())
    }
}
