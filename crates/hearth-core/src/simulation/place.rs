//! The position of a source in each model.

use glam::Vec2;

use crate::classic;
use crate::combustion::Burner;
use crate::extremes::fast_min;
use crate::params::Model;
use crate::scene::{Pose, Scene, SceneSource};
use crate::source::SourcePlace;

/// Largest width of a source on a solid, in heights of the domain: a large solid burns with many
/// flames, not with a large one.
const WIDEST: f32 = 0.25;

impl SourcePlace {
    /// A source as a line.
    pub fn of(source: &SceneSource<'_>) -> SourcePlace {
        match source.world.model() {
            Model::Classic => classic::source(source),
            Model::Combustion => {
                let burner = Burner::of(source);
                SourcePlace {
                    base: Vec2::new(burner.middle, burner.bottom),
                    width: 2.0 * burner.half_width,
                    on_solid: false,
                }
            }
        }
    }

    /// The first source of a scene with solids at these poses; without one, the place of one with the defaults.
    pub fn first(scene: &Scene, poses: &[Pose]) -> SourcePlace {
        scene.read_first_source(|source| {
            SourcePlace::on_solid(source, poses).unwrap_or_else(|| SourcePlace::of(source))
        })
    }

    /// A source on its solid; `None` if it is a line.
    pub fn on_solid(source: &SceneSource<'_>, poses: &[Pose]) -> Option<SourcePlace> {
        let id = source.solid_id()?;
        let frame = &poses.iter().find(|pose| pose.id == id)?.frame;
        let size = 2.0 * (frame.half + frame.radius);
        Some(SourcePlace {
            base: frame.centre - Vec2::new(0.0, frame.extent().y),
            width: fast_min(
                (size.x * size.y).sqrt(),
                WIDEST * source.world.domain_height,
            ),
            on_solid: true,
        })
    }
}
