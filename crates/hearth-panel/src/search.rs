//! Which parameters a search shows.
//!
//! Every word must occur somewhere in what the panel says about a parameter:
//! its label, id, group, unit or doc. Case does not matter.

use hearth_core::params::Param;

/// Whether `param` answers `query`; an empty query shows everything.
pub fn matches(query: &str, param: &Param) -> bool {
    let about = param.description();
    let text = format!(
        "{} {} {} {} {} {}",
        about.label,
        param.id,
        param.id.replace('_', "-"),
        param.group,
        param.unit,
        about.doc
    )
    .to_lowercase();
    query
        .to_lowercase()
        .split_whitespace()
        .all(|word| text.contains(word))
}

#[cfg(test)]
mod tests {
    use super::*;
    use hearth_core::params::PARAMETERS;

    fn found(query: &str) -> Vec<&'static str> {
        PARAMETERS
            .iter()
            .filter(|param| matches(query, param))
            .map(|param| param.id)
            .collect()
    }

    #[test]
    fn nothing_typed_shows_everything() {
        assert_eq!(found("  ").len(), PARAMETERS.len());
    }

    #[test]
    fn an_id_finds_its_parameter_however_it_is_spelt() {
        for param in PARAMETERS {
            assert!(found(param.id).contains(&param.id));
            assert!(found(&param.id.replace('_', "-")).contains(&param.id));
            assert!(found(&param.description().label.to_uppercase()).contains(&param.id));
        }
    }

    #[test]
    fn every_word_counts() {
        assert!(found("source width").contains(&"source_width"));
        assert!(!found("source width").contains(&"viscosity"));
        assert!(found("no parameter says this").is_empty());
    }
}
