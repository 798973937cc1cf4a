//! What persists between visits. The page stores it.

use std::collections::BTreeSet;

use hearth_core::params::PARAMETERS;

use crate::state::objects::OBJECTS;

/// The group that is folded at the first visit.
const FOLDED_GROUP: &str = "Physics";

/// The folded parts of the panel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Memory {
    /// The folded groups.
    pub folded: BTreeSet<&'static str>,
    /// Whether the times of a frame are shown.
    pub times: bool,
}

impl Default for Memory {
    fn default() -> Memory {
        Memory {
            folded: BTreeSet::from([FOLDED_GROUP]),
            times: false,
        }
    }
}

impl Memory {
    /// Folds the groups of these names and unfolds all others. Unknown names are ignored.
    pub fn fold<'a>(&mut self, names: impl IntoIterator<Item = &'a str>) {
        let group = |name: &str| {
            let groups = PARAMETERS.iter().map(|param| param.group());
            let mut groups = groups.chain([OBJECTS]);
            groups.find(|&group| group == name)
        };
        self.folded = names.into_iter().filter_map(group).collect();
    }
}
