//! The scenes: a file of `scenes/` each, checked before anything is written.
//!
//! `{"hearth": 1, "label": "Candle", "description": "One sentence.", "values": {…}}`,
//! and the file's name is the scene's. Such a file is also one of settings, as the
//! element's `src` takes them.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result, bail, ensure};
use hearth_core::params::{Input, Model, PARAMETERS, Parameters};

use super::json::Json;

/// The scene that a new fire is.
const DEFAULT: &str = "default";

/// The fields that there are.
const FIELDS: [&str; 4] = ["hearth", "label", "description", "values"];

/// Longest name and label; they stand on buttons.
const LONGEST_NAME: usize = 24;
/// Longest description: two lines at most.
const LONGEST_DESCRIPTION: usize = 140;

/// A named fire.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Scene {
    /// Its name in attributes and URLs.
    pub(super) name: String,
    /// What a person reads.
    pub(super) label: String,
    /// What there is to see, in a sentence.
    pub(super) description: String,
    /// Its model.
    pub(super) model: Model,
    /// What differs from the defaults, the model first.
    pub(super) values: Vec<(String, Json)>,
}

impl Scene {
    /// All values of its fire.
    ///
    /// # Errors
    /// A value that the table does not take.
    pub(super) fn parameters(&self) -> Result<Parameters> {
        let mut parameters = Parameters::default();
        for (id, value) in &self.values {
            parameters.set(id, input(value))?;
        }
        Ok(parameters)
    }
}

/// Every scene under `folder`: the default one first, then those of each model by
/// their names, the default model's first.
///
/// # Errors
/// A file that is no scene, named with what is wrong in it.
pub(super) fn read_all(folder: &Path) -> Result<Vec<Scene>> {
    let shown = || format!("cannot read {}", crate::paths::shown(folder));
    let mut scenes = Vec::new();
    for entry in fs::read_dir(folder).with_context(shown)? {
        let path = entry?.path();
        let file = path.file_name().unwrap_or_default().to_string_lossy();
        let text = fs::read_to_string(&path).with_context(shown)?;
        let scene = parse(&file, &text).with_context(|| format!("scenes/{file}"))?;
        scenes.push(scene);
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
        let twin = scenes[..at].iter().find(|other| other.label == scene.label);
        if let Some(twin) = twin {
            bail!(
                "scenes/{}.json: \"{}\" is the label of {}",
                scene.name,
                scene.label,
                twin.name
            );
        }
    }
    Ok(scenes)
}

/// The scene in a file of that name with that text.
///
/// # Errors
/// The first thing that is wrong with it.
pub(super) fn parse(file: &str, text: &str) -> Result<Scene> {
    let name = file
        .strip_suffix(".json")
        .filter(|name| is_name(name))
        .with_context(|| {
            format!(
                "a scene's file is called as the scene, in at most {LONGEST_NAME} small letters, \
                 digits and hyphens, and .json"
            )
        })?;
    let Json::Object(fields) = serde_json::from_str(text)? else {
        bail!("it must be an object with the fields {}", FIELDS.join(", "));
    };
    for (field, _) in &fields {
        ensure!(
            FIELDS.contains(&field.as_str()),
            "\"{field}\" is refused: it must be one of {} (parameters stand in values)",
            FIELDS.join(", ")
        );
    }
    let field = |name: &str| {
        let found = fields.iter().find(|(field, _)| field == name);
        found.map(|(_, value)| value)
    };
    ensure!(
        field("hearth") == Some(&Json::Number(1.0)),
        "\"hearth\" must be 1, the version of the form"
    );
    let words = |name: &str, longest: usize| match field(name) {
        Some(Json::Text(words)) if is_line(words, longest) => Ok(words.clone()),
        _ => bail!("\"{name}\" must be one line of at most {longest} characters"),
    };
    let label = words("label", LONGEST_NAME)?;
    let description = words("description", LONGEST_DESCRIPTION)?;
    ensure!(
        description.ends_with('.'),
        "\"description\" must be a sentence, with its full stop"
    );
    let Some(Json::Object(values)) = field("values") else {
        bail!("\"values\" must be an object of parameters");
    };
    let mut values = values.clone();
    // Other models have other ranges.
    values.sort_by_key(|(id, _)| id != "model");
    let model = accepted(&values)?;
    ensure!(
        name != DEFAULT || values.is_empty(),
        "the default scene has no values: change the defaults in the table"
    );
    Ok(Scene {
        name: name.to_owned(),
        label,
        description,
        model,
        values,
    })
}

/// The model of these values, where the table takes each of them and that model uses it.
fn accepted(values: &[(String, Json)]) -> Result<Model> {
    let mut parameters = Parameters::default();
    for (id, value) in values {
        parameters.set(id, input(value))?;
    }
    let model = parameters.model();
    for param in PARAMETERS {
        if param.domain(model).is_none() && values.iter().any(|(id, _)| id == param.id) {
            bail!("{} is of no use in the model {}", param.id, model.name());
        }
    }
    Ok(model)
}

/// A value as the table takes it; an object becomes words that no parameter takes.
pub(super) fn input(value: &Json) -> Input<'_> {
    match value {
        Json::Number(x) => Input::Number(*x),
        Json::Text(text) => Input::Text(text),
        Json::Flag(on) => Input::Flag(*on),
        Json::Object(_) => Input::Text("an object"),
    }
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

    fn said(file: &str, text: &str) -> String {
        match parse(file, text) {
            Ok(scene) => format!("taken: {scene:?}"),
            Err(error) => format!("{error:#}"),
        }
    }

    /// A scene with these values.
    fn with(values: &str) -> String {
        format!(
            "{{\"hearth\": 1, \"label\": \"A\", \"description\": \"A fire.\", \"values\": {values}}}"
        )
    }

    #[test]
    fn a_scene_is_what_its_file_says() {
        let text = with(r#"{"wind": 1.5, "palette": "gas", "model": "combustion"}"#);
        let scene = parse("a-2.json", &text);
        let expected = Scene {
            name: "a-2".to_owned(),
            label: "A".to_owned(),
            description: "A fire.".to_owned(),
            model: Model::Combustion,
            values: vec![
                ("model".to_owned(), Json::Text("combustion".to_owned())),
                ("wind".to_owned(), Json::Number(1.5)),
                ("palette".to_owned(), Json::Text("gas".to_owned())),
            ],
        };
        assert_eq!(scene.ok(), Some(expected));
    }

    #[test]
    fn a_wrong_scene_is_refused_and_what_is_wrong_is_named() {
        for (values, named) in [
            (r#"{"wimd": 1}"#, "did you mean \"wind\"?"),
            (
                r#"{"wind": 9}"#,
                "wind = 9 is refused: it must be a number from -3 to 3",
            ),
            (r#"{"wind": {}}"#, "wind = \"an object\""),
            (r#"{"wind": [1]}"#, "invalid type: sequence"),
            (r#"{"wind": null}"#, "invalid type: null"),
            (
                r#"{"wind": 1, "wind": 1}"#,
                "\"wind\" stands there twice at line 1",
            ),
            (r#"{"palette": "soot"}"#, "one of blackbody"),
            (
                r#"{"lifetime_min": 1}"#,
                "lifetime_min is of no use in the model combustion",
            ),
            // In the range of the other model.
            (r#"{"max_particles": 100}"#, "from 200 to 100000"),
            (r#"{"max_particles": 100, "model": "classic"}"#, "taken"),
            ("3", "\"values\" must be"),
        ] {
            let said = said("a.json", &with(values));
            assert!(said.contains(named), "{values}: {said}");
        }
        for (text, named) in [
            ("", "EOF"),
            ("3", "it must be an object"),
            (
                r#"{"label": "A", "label": "B"}"#,
                "\"label\" stands there twice",
            ),
            (r#"{"wind": 1}"#, "\"wind\" is refused"),
            (r#"{"preset": "default"}"#, "\"preset\" is refused"),
            (r#"{"hearth": 2}"#, "\"hearth\" must be 1"),
            (
                r#"{"hearth": 1, "label": " "}"#,
                "\"label\" must be one line",
            ),
            (
                r#"{"hearth": 1, "label": "A"}"#,
                "\"description\" must be one line",
            ),
            (
                r#"{"hearth": 1, "label": "A", "description": "B", "values": {}}"#,
                "with its full stop",
            ),
        ] {
            let said = said("a.json", text);
            assert!(said.contains(named), "{text}: {said}");
        }
        for file in [
            "a",
            "A.json",
            "a b.json",
            "-a.json",
            "a--b.json",
            ".json",
            "é.json",
        ] {
            assert!(
                said(file, &with("{}")).contains("called as the scene"),
                "{file}"
            );
        }
        assert!(said("default.json", &with(r#"{"wind": 1}"#)).contains("no values"));
    }

    #[test]
    fn of_many_files_the_wrong_one_is_named() -> Result<()> {
        let folder = std::env::temp_dir().join(format!("hearth-scenes-{}", std::process::id()));
        fs::create_dir_all(&folder)?;
        let missing = read_all(&folder).map_err(|error| format!("{error:#}"));
        assert_eq!(missing, Err("scenes/default.json is missing".to_owned()));
        fs::write(folder.join("default.json"), with("{}"))?;
        assert_eq!(read_all(&folder)?.len(), 1);
        fs::write(folder.join("b.json"), with(r#"{"wind": 4}"#))?;
        let wrong = read_all(&folder).map_err(|error| format!("{error:#}"));
        let wrong = wrong.err().unwrap_or_default();
        assert!(wrong.contains("scenes/b.json: wind = 4"), "{wrong}");
        fs::write(folder.join("b.json"), with(r#"{"wind": 1}"#))?;
        let twins = read_all(&folder).map_err(|error| format!("{error:#}"));
        let twins = twins.err().unwrap_or_default();
        assert!(
            twins.contains("scenes/b.json: \"A\" is the label of default"),
            "{twins}"
        );
        Ok(fs::remove_dir_all(folder)?)
    }
}
