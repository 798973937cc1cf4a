//! What a panel keeps from one visit to the next: which groups are folded, and
//! whether the times are shown. Where it is kept is the page's affair.

use std::collections::BTreeSet;

use hearth_core::params::PARAMETERS;

/// The group that is folded until somebody unfolds it.
const FOLDED: &str = "Physics";

/// What is folded and what is not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Memory {
    /// The groups that are folded.
    pub folded: BTreeSet<&'static str>,
    /// Whether it is shown what takes how long.
    pub times: bool,
}

impl Default for Memory {
    fn default() -> Memory {
        Memory {
            folded: BTreeSet::from([FOLDED]),
            times: false,
        }
    }
}

impl Memory {
    /// Folds the groups of these names and unfolds all others; a name that is none is
    /// left out.
    pub fn fold<'a>(&mut self, names: impl IntoIterator<Item = &'a str>) {
        let group = |name: &str| {
            let mut groups = PARAMETERS.iter().map(|param| param.group);
            groups.find(|&group| group == name)
        };
        self.folded = names.into_iter().filter_map(group).collect();
    }
}
