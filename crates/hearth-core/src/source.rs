//! The position of a source, in either model.

use glam::Vec2;

use crate::direction::direction;
use crate::params::Physics;
use crate::scene::SceneSource;

/// The position and width of a source: of a line, clamped to the domain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SourcePlace {
    /// Middle of its lower edge; on a solid, below its centre \[m\].
    pub base: Vec2,
    /// Its width; on a solid, the width of a line whose flame is about as large \[m\].
    pub width: f32,
    /// Whether it is the surface of a solid.
    pub on_solid: bool,
}

crate::state! { SourcePlace: base width on_solid }

/// The argument of the noise of the emission at a place on a solid: how far along its width
/// and height together, so that no side of the solid has the same noise throughout.
pub(crate) fn along(local: Vec2) -> f32 {
    local.dot(Vec2::new(1.0, 0.618))
}

/// Direction of the width of a source; `None` if it is not turned.
pub(crate) fn axis(source: &SceneSource<'_>) -> Option<Vec2> {
    let angle = source.angle;
    (angle != 0.0).then(|| direction(angle))
}

/// `x`, clamped so that a source of this width keeps `margin` \[m\] from the sides; 0 if
/// it does not fit.
pub(crate) fn middle(source: &SceneSource<'_>, width: f32, margin: f32) -> f32 {
    let farthest = (0.5 * (source.world.domain_width - width) - margin).max(0.0);
    source.x.max(-farthest).min(farthest)
}

/// Whether a position is in the domain.
pub(crate) fn contains(values: &Physics, position: Vec2) -> bool {
    let half = 0.5 * values.domain_width;
    position.x.abs() < half && position.y > 0.0 && position.y < values.domain_height
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::{Model, Parameters};
    use crate::scene::Scene;

    /// The place of the source of a scene with these values, those of the combustion model in that model alone.
    fn of(model: Model, values: &[(&str, f64)]) -> (SourcePlace, Parameters) {
        let mut scene = Scene::of_model(model);
        if model == Model::Combustion {
            assert_eq!(scene.set("edges", "periodic"), Ok(()));
        }
        for &(id, value) in values {
            if (model, id) != (Model::Classic, "seam") {
                assert_eq!(scene.set(id, value), Ok(()));
            }
        }
        (SourcePlace::first(&scene, &[]), scene.world().clone())
    }

    #[test]
    fn it_is_at_the_position_of_the_parameters() {
        for model in [Model::Classic, Model::Combustion] {
            for x in [-0.2, 0.0, 0.15] {
                let values = [
                    ("source_x", x),
                    ("source_height", 0.5),
                    ("source_width", 0.3),
                ];
                let source = SourcePlace {
                    base: Vec2::new(x as f32, 0.5),
                    width: 0.3,
                    on_solid: false,
                };
                assert_eq!(of(model, &values).0, source);
            }
        }
    }

    #[test]
    fn a_burner_is_above_the_seam_and_at_least_four_particles_wide() {
        let values = [("source_height", 0.0), ("source_width", 0.01)];
        let (source, parameters) = of(Model::Combustion, &values);
        assert_eq!(source.base.y, parameters.seam * parameters.domain_height);
        assert_eq!(source.width, 4.0 * parameters.spacing());
    }

    #[test]
    fn all_of_it_stays_inside_the_domain() {
        for model in [Model::Classic, Model::Combustion] {
            for x in [-3.0, -0.7, 0.4, 3.0] {
                for (width, domain, seam) in [(0.3, 1.2, 0.07), (0.6, 0.5, 0.2), (0.6, 6.0, 0.0)] {
                    let (source, parameters) = of(
                        model,
                        &[
                            ("source_x", x),
                            ("source_width", width),
                            ("domain_width", domain),
                            ("seam", seam),
                        ],
                    );
                    let side = 0.5 * (parameters.domain_width - source.width);
                    let free = match model {
                        Model::Classic => side,
                        Model::Combustion => side - parameters.seam * parameters.domain_width,
                    };
                    assert!(
                        source.base.x.abs() <= free.max(0.0) + 1e-6,
                        "{source:?} of {x} in {domain}"
                    );
                    let requested = x.abs() as f32;
                    assert!(
                        source.base.x.abs() >= requested.min(free) - 1e-6,
                        "{source:?} of {x} in {domain}"
                    );
                }
            }
        }
    }
}
