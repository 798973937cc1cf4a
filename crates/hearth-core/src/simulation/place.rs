//! The position of a source in each model.

use glam::Vec2;

use crate::classic;
use crate::combustion::Burner;
use crate::extremes::fast_min;
use crate::params::{Model, Parameters};
use crate::scene::Scene;
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

    /// The first source of a scene on its solid at a time of the fire \[s\]; `None` if it is a line.
    pub fn on_solid(scene: &Scene, time: f64) -> Option<Source> {
        let settings = scene.settings();
        let (solid, surface) = scene.solid_of(settings)?;
        let frame = solid.frame_at(surface, time);
        let size = 2.0 * (frame.half + frame.radius);
        Some(Source {
            base: frame.centre - Vec2::new(0.0, frame.extent().y),
            width: fast_min((size.x * size.y).sqrt(), WIDEST * settings.domain_height),
            on_solid: true,
        })
    }
}
