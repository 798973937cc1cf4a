//! The parameter that states the number of particles.

use crate::untrusted::{Untrusted, Values};

/// Id of the number of particles.
pub(crate) const COUNT: &str = "particles";
/// Id of the spacing of particles.
pub(crate) const SPACING: &str = "spacing";
/// Id of the largest number of particles.
pub(crate) const CAP: &str = "max_particles";

/// The parameter that states the resolution of the combustion model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum StatedResolution {
    /// None: the resolution follows the scene or the quality.
    #[default]
    Auto,
    /// The number of particles that would fill the domain.
    Count,
    /// The spacing of particles in open air.
    Spacing,
}

impl StatedResolution {
    /// What states the resolution, and the parameters that state it. Of two, the last one wins.
    pub(crate) const IDS: [(StatedResolution, &str); 2] = [
        (StatedResolution::Count, COUNT),
        (StatedResolution::Spacing, SPACING),
    ];

    /// The resolution after these values.
    pub(crate) fn after(mut self, values: Values<'_>) -> StatedResolution {
        for (own, id) in StatedResolution::IDS {
            for (_, value) in values.iter().filter(|(known, _)| known == id) {
                match value {
                    Untrusted::Missing => {}
                    Untrusted::Null if self != own => {}
                    Untrusted::Null => self = StatedResolution::Auto,
                    _ => self = own,
                }
            }
        }
        self
    }
}
