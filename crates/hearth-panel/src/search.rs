//! The search for parameters, with a rank for each match.
//!
//! The parameters of a known phrase come first. Of others, every word of the query must match. The rank of
//! a word is best at the start of the label, then at the start of a word of the label or the id, then as
//! a synonym, then as a word of unit, group or description. The search ignores case and accepts British
//! and American spelling.

use hearth_core::params::{Model, Param, Property};
use hearth_core::scene::Kind;

use crate::state::objects::has_row;

/// Synonyms of the words in labels and ids.
const SYNONYMS: &[(&str, &[&str])] = &[
    ("air", &["edges"]),
    ("airflow", &["wind"]),
    ("amount", &["strength", "particles"]),
    ("backdrop", &["background"]),
    ("big", &["size", "width", "height"]),
    ("black", &["palette", "colour", "background"]),
    ("bloom", &["glow"]),
    ("blue", &["palette", "colour", "background"]),
    ("box", &["edges", "domain"]),
    ("bricks", &["backdrop"]),
    ("brightness", &["exposure"]),
    ("ceiling", &["edges"]),
    ("chaos", &["turbulence"]),
    ("coarse", &["spacing"]),
    ("color", &["colour", "palette", "background"]),
    ("colour", &["palette", "background"]),
    ("contrast", &["luminance"]),
    ("count", &["particles"]),
    ("curl", &["vorticity"]),
    ("density", &["particles", "strength"]),
    ("ember", &["spark", "sparks"]),
    ("embers", &["spark", "sparks"]),
    ("flicker", &["turbulence", "noise"]),
    ("frame", &["domain"]),
    ("gamma", &["luminance"]),
    ("green", &["palette", "colour", "background"]),
    ("ground", &["floor"]),
    ("heat", &["temperature", "strength", "haze"]),
    ("height", &["strength", "life", "longest"]),
    ("hue", &["palette", "colour"]),
    ("intensity", &["strength", "brightness"]),
    ("light", &["brightness", "glow"]),
    ("liveliness", &["turbulence", "noise"]),
    ("luminosity", &["brightness"]),
    ("neighbors", &["smoothing"]),
    ("neighbours", &["smoothing"]),
    ("open", &["edges"]),
    ("orange", &["palette", "colour", "background"]),
    ("pace", &["speed"]),
    ("pink", &["palette", "colour", "background"]),
    ("position", &["height", "source", "place"]),
    ("power", &["strength"]),
    ("purple", &["palette", "colour", "background"]),
    ("quality", &["particles", "detail", "spacing"]),
    ("random", &["seed", "noise"]),
    ("red", &["palette", "colour", "background"]),
    ("resolution", &["particles", "smoothing", "spacing"]),
    ("saturation", &["palette", "luminance"]),
    ("scale", &["size"]),
    ("shimmer", &["haze"]),
    ("size", &["width", "height", "scale"]),
    ("slow", &["speed"]),
    ("smoke", &["soot", "layers"]),
    ("spark", &["ember", "sparks"]),
    ("sparks", &["ember"]),
    ("speed", &["time", "wind"]),
    ("strength", &["power"]),
    ("temperature", &["ignition", "heat", "cooling"]),
    ("theme", &["palette"]),
    ("tint", &["palette", "colour"]),
    ("transparency", &["background"]),
    ("transparent", &["background"]),
    ("view", &["display", "layers"]),
    ("violet", &["palette", "colour", "background"]),
    ("wall", &["backdrop", "walls"]),
    ("white", &["palette", "colour", "background"]),
    ("world", &["domain", "edges"]),
    ("yellow", &["palette", "colour", "background"]),
    ("zoom", &["domain"]),
];

/// Quantities by the words that people use, and the ids of the parameters that change them, the best
/// first. A fire counts as a flame.
const PHRASES: &[(&str, &[&str])] = &[
    ("air speed", &["wind"]),
    ("amount smoke", &["smoke_opacity", "smoke_life"]),
    ("flame brightness", &["exposure", "flame_rise", "bloom"]),
    ("flame colour", &["palette", "hot_colour", "cool_colour"]),
    ("flame height", &["fuel_power", "lifetime_max"]),
    ("flame position", &["source_x", "source_height"]),
    (
        "flame size",
        &["source_width", "fuel_power", "emission_rate"],
    ),
    ("flame speed", &["buoyancy", "terminal_speed", "time_scale"]),
    ("flame temperature", &["flame_rise", "maximum_temperature"]),
    ("flame width", &["source_width"]),
    ("frame rate", &["particles", "max_particles", "detail"]),
    ("heat release", &["fuel_power", "emission_rate"]),
    ("number sparks", &["ember_rate"]),
    ("room temperature", &["ambient_temperature"]),
    ("slow motion", &["time_scale"]),
    ("spark life", &["ember_life_max", "ember_life_min"]),
];

/// Rank of what matches by its words, after what matches by a phrase.
const AFTER_PHRASES: u32 = 8;

/// Least letters of a part of a word in a description.
const LEAST_PART: usize = 5;

/// American spellings, and the British ones of the table.
const SPELLINGS: &[(&str, &str)] = &[
    ("color", "colour"),
    ("neighbor", "neighbour"),
    ("center", "centre"),
    ("meter", "metre"),
    ("gray", "grey"),
    ("vapor", "vapour"),
];

/// The rank of `param` for `query`, the lowest the best; `None` if it does not match. An empty
/// query matches every parameter with the same rank.
pub fn rank(query: &str, param: &Param) -> Option<u32> {
    rank_in_phrase(query, param.id)
        .or_else(|| Some(AFTER_PHRASES + Words::of(param).rank_all(query)?))
}

/// The place of a parameter in the phrase with all words of the query, the last ones maybe incomplete.
fn rank_in_phrase(query: &str, id: &str) -> Option<u32> {
    let query = query.to_lowercase();
    let words = query.split_whitespace().map(|word| match word {
        "fire" => "flame".to_owned(),
        word => in_british(word),
    });
    let words = words.filter(|word| !matches!(&**word, "of" | "the" | "a"));
    let words: Vec<String> = words.collect();
    let is_meant = |(phrase, _): &&(&str, _)| {
        let is_in = |word: &String| phrase.split(' ').any(|part| part.starts_with(&**word));
        words.len() > 1 && words.iter().all(is_in)
    };
    let mut ids = PHRASES.iter().filter(is_meant).flat_map(|(_, ids)| *ids);
    Some(ids.position(|known| *known == id)? as u32)
}

fn in_british(typed: &str) -> String {
    let mut word = typed.to_owned();
    for (american, british) in SPELLINGS {
        // A replaced word stays the same: "colour" does not contain "color".
        word = word.replace(american, british);
    }
    word
}

/// Whether `param` matches `query`.
pub fn matches(query: &str, param: &Param) -> bool {
    rank(query, param).is_some()
}

/// The properties of a kind that match `query` and that `model` uses, the best match first. The
/// name of the kind matches as well.
pub fn properties(query: &str, kind: &Kind, model: Model) -> Vec<Property> {
    let rank = |property: Property| {
        let mut about = Words::of(property.param(model)?);
        about.id = format!("{} {}", kind.name, property.name.replace('_', " "));
        Some((about.rank_all(query)?, property))
    };
    let all = kind.properties();
    let shown = all.filter(|property| has_row(*property, model));
    let mut found: Vec<_> = shown.filter_map(rank).collect();
    found.sort_by_key(|(rank, _)| *rank);
    found.into_iter().map(|(_, property)| property).collect()
}

/// Whether the name of an object has every word of `query`.
pub fn names(query: &str, name: &str) -> bool {
    let name = name.to_lowercase();
    let query = query.to_lowercase();
    query.split_whitespace().all(|word| name.contains(word))
}

/// The searched texts of a parameter in lower case.
struct Words {
    label: String,
    id: String,
    details: String,
}

impl Words {
    fn of(param: &Param) -> Words {
        let about = param.description();
        Words {
            label: about.label.to_lowercase(),
            id: param.id.replace('_', " "),
            details: format!(
                "{} {} {} {} {}",
                param.id,
                param.id.replace('_', "-"),
                about.group,
                param.unit,
                about.doc
            )
            .to_lowercase(),
        }
    }

    fn rank_all(&self, query: &str) -> Option<u32> {
        let query = query.to_lowercase();
        query.split_whitespace().map(|word| self.rank(word)).sum()
    }

    fn rank(&self, typed: &str) -> Option<u32> {
        let word = &*in_british(typed);
        let starts = |text: &str, with: &str| text.split(' ').any(|part| part.starts_with(with));
        if self.label.starts_with(word) {
            Some(0)
        } else if starts(&self.label, word) {
            Some(1)
        } else if starts(&self.id, word) {
            Some(2)
        } else if self.is_synonym(typed) || self.is_synonym(word) {
            Some(3)
        } else {
            // A part of another word is rarely meant: "red" is not in "powered".
            let mut all = self.details.split_whitespace();
            let is_part = |text: &str| word.len() >= LEAST_PART && text.starts_with(word);
            let found = all.any(|text| {
                let text = text.trim_matches(|c: char| c.is_ascii_punctuation());
                text == word || is_part(text)
            });
            found.then_some(4)
        }
    }

    /// Whether a word is a synonym of the parameter's.
    fn is_synonym(&self, typed: &str) -> bool {
        let named = |name: &&str| {
            let mut parts = self.label.split(' ').chain(self.id.split(' '));
            parts.any(|part| part == *name)
        };
        // An incomplete word matches as well.
        let matches =
            |&&(word, _): &&(&str, _)| word == typed || typed.len() > 3 && word.starts_with(typed);
        let mut found = SYNONYMS.iter().filter(matches);
        found.any(|(_, names)| names.iter().any(&named))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use hearth_core::params::PARAMETERS;

    /// The ids of the matches, the best first.
    fn found(query: &str) -> Vec<&'static str> {
        let ranked = PARAMETERS
            .iter()
            .filter_map(|param| Some((rank(query, param)?, param.id)));
        let mut ranked: Vec<_> = ranked.collect();
        ranked.sort_by_key(|(rank, _)| *rank);
        ranked.into_iter().map(|(_, id)| id).collect()
    }

    #[test]
    fn an_empty_query_matches_every_parameter() {
        assert_eq!(found("  ").len(), PARAMETERS.len());
    }

    #[test]
    fn an_id_matches_its_parameter_in_every_spelling() {
        for param in PARAMETERS {
            assert!(found(param.id).contains(&param.id));
            assert!(found(&param.id.replace('_', "-")).contains(&param.id));
            assert!(found(&param.description().label.to_uppercase()).contains(&param.id));
        }
    }

    #[test]
    fn every_word_of_a_query_must_match() {
        assert!(found("source width").contains(&"source_width"));
        assert!(!found("source width").contains(&"viscosity"));
        assert!(found("no parameter has this text").is_empty());
    }

    #[test]
    fn labels_rank_before_descriptions() {
        assert_eq!(found("wind")[0], "wind");
        assert_eq!(found("smoke")[..2], ["smoke_opacity", "smoke_life"]);
        assert_eq!(found("visc")[..2], ["viscosity", "kinematic_viscosity"]);
    }

    #[test]
    fn a_quantity_or_a_colour_finds_what_changes_it_first() {
        for (query, ids) in [
            ("flame height", &["fuel_power", "lifetime_max"][..]),
            ("Height of the fire", &["fuel_power", "lifetime_max"]),
            ("fire color", &["palette", "hot_colour"]),
            ("flame temp", &["flame_rise", "maximum_temperature"]),
            ("wind speed", &["wind"]),
            ("red", &["palette"]),
            ("blue", &["palette"]),
            ("slow motion", &["time_scale"]),
            ("wind", &["wind"]),
        ] {
            let found = found(query);
            assert!(found.starts_with(ids), "{query} finds {found:?}");
        }
        for (query, id) in [("red", "radiative_cooling"), ("red", "diffusion")] {
            assert!(!found(query)[..3].contains(&id), "{query} finds {id}");
        }
        let solid = hearth_core::scene::KINDS.iter().find(|kind| kind.is_body);
        let solid = solid.expect("there are solids");
        let windy = properties("wind", solid, Model::Combustion);
        assert!(windy.is_empty(), "{windy:?}");
        for (_, ids) in PHRASES {
            assert!(ids.iter().all(|id| Param::find(id).is_some()), "{ids:?}");
        }
    }

    #[test]
    fn synonyms_match() {
        for (query, id) in [
            ("color", "palette"),
            ("color", "background"),
            ("colour", "hot_colour"),
            ("size", "source_width"),
            ("speed", "time_scale"),
            ("zoom", "domain_width"),
            ("zoom", "domain_height"),
            ("resolution", "spacing"),
            ("ground", "floor"),
            ("box", "edges"),
            ("domain", "domain_width"),
            ("brightness", "exposure"),
            ("brightn", "exposure"),
            ("height", "fuel_power"),
            ("height", "lifetime_max"),
            ("smoke", "smoke_opacity"),
            ("spark", "ember_rate"),
            ("ember", "ember_rate"),
            ("neighbors", "smoothing_ratio"),
            ("random", "seed"),
        ] {
            assert!(
                found(query).contains(&id),
                "{query} finds {:?}",
                found(query)
            );
        }
    }
}
