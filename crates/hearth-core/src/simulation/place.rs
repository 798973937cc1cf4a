//! The position of a source in each model.

use glam::Vec2;

use crate::classic;
use crate::combustion::Burner;
use crate::extremes::fast_min;
use crate::params::{Model, Parameters};
use crate::scene::Pose;
use crate::source::Source;

/// Largest width of a source on a solid, in heights of the domain: a large solid burns with many
/// flames, not with a large one.
const WIDEST: f32 = 0.25;

impl Source {
    /// The first source of these parameters as a line.
    pub fn of(parameters: &Parameters) -> Source {
        match parameters.model() {
            Model::Classic => classic::source(parameters),
            Model::Combustion => {
                let burner = Burner::of(parameters);
                Source {
                    base: Vec2::new(burner.middle, burner.bottom),
                    width: 2.0 * burner.half_width,
                    on_solid: false,
                }
            }
        }
    }

    /// The first source of these settings on its solid; `None` if it is a line.
    pub fn on_solid(settings: &Parameters, poses: &[Pose]) -> Option<Source> {
        let id = settings.solid_of_source()?;
        let frame = &poses.iter().find(|pose| pose.id == id)?.frame;
        let size = 2.0 * (frame.half + frame.radius);
        Some(Source {
            base: frame.centre - Vec2::new(0.0, frame.extent().y),
            width: fast_min((size.x * size.y).sqrt(), WIDEST * settings.domain_height),
            on_solid: true,
        })
    }
}
