//! What surrounds the gas of a fire, and how far it has moved: slices of another scene are not seen.

use hearth_core::params::{Fuel, Material, Motion};
use hearth_core::scene::Pose;
use hearth_core::{Scene, SourcePlace};

/// Change of the wind that counts as a width of the source [m/s].
const WIND_PER_WIDTH: f32 = 2.0;
/// Path when an object appears or disappears, in widths of the source.
const CHANGED: f32 = 1.0;
/// Distance from the source within which a solid may be in the flame, and minimum height of its middle, in widths of
/// the source.
const FLAME_WIDTHS: f32 = 2.0;
const FLAME_FOOT_WIDTHS: f32 = 0.05;
/// Maximum distance between places that are the same \[m\].
const SAME_PLACE: f32 = 1e-3;

/// Sources, solids and wind of a moment.
#[derive(Clone, Default)]
pub struct Surroundings {
    sources: Vec<[f32; 2]>,
    poses: Vec<Pose>,
    wind: f32,
    width: f32,
    symmetric: bool,
    free: bool,
}

hearth_core::state! { Surroundings: sources poses wind width symmetric free }

impl Surroundings {
    /// Those of a scene whose solids are at `poses`, with its first source.
    pub fn of(scene: &Scene, poses: &[Pose], first: &SourcePlace) -> Surroundings {
        let values = scene.world();
        let sources: Vec<_> = scene.sources().map(|source| [source.x, source.y]).collect();
        let free = !first.on_solid
            && !scene.obstacles().any(|(id, solid, _)| {
                let pose = poses.iter().find(|pose| pose.id == id);
                solid.material != Material::None
                    && pose.is_some_and(|pose| is_in_flame(pose, first))
            });
        let is_free_fuel = |pose: &&Pose| {
            scene.surfaces().any(|(id, solid, _)| {
                id == pose.id && solid.fuel != Fuel::None && solid.motion == Motion::Free
            })
        };
        let mut angles = scene.sources().map(|source| source.angle);
        Surroundings {
            symmetric: free
                && values.wind == 0.0
                && angles.all(|angle| angle == 0.0)
                && is_symmetric(&sources),
            free,
            sources,
            poses: poses
                .iter()
                .filter(|pose| !is_free_fuel(pose))
                .copied()
                .collect(),
            wind: values.wind,
            width: first.width,
        }
    }

    /// The path of what has moved farthest since an earlier moment, in widths of the source. A slice follows a
    /// single source, which does not count.
    pub fn path_since(&self, before: &Surroundings) -> f64 {
        let mut path = 0.0_f32;
        let same_solids = self.poses.len() == before.poses.len();
        let same_sources = self.sources.len() == before.sources.len();
        for (now, then) in self.poses.iter().zip(&before.poses) {
            let (now, then) = (&now.frame, &then.frame);
            let turned = now.half.max_element() + now.radius;
            let moved = now.centre.distance(then.centre) + turned * now.axis.distance(then.axis);
            path = path.max(moved);
        }
        if !self.is_single() {
            for (now, then) in self.sources.iter().zip(&before.sources) {
                path = path.max((now[0] - then[0]).abs() + (now[1] - then[1]).abs());
            }
        }
        let changed = if same_solids && same_sources {
            0.0
        } else {
            CHANGED
        };
        let grown = (self.width - before.width).abs();
        let widths = (path + grown) / self.width + changed;
        f64::from(widths + (self.wind - before.wind).abs() / WIND_PER_WIDTH)
    }

    /// Whether there is one source.
    pub fn is_single(&self) -> bool {
        self.sources.len() <= 1
    }

    /// Whether the scene is the same when it is mirrored at its first source.
    pub fn is_symmetric(&self) -> bool {
        self.symmetric
    }

    /// Whether no solid is in the flame and the first source is on none.
    pub fn is_free(&self) -> bool {
        self.free
    }
}

/// Whether places are symmetric about the first one.
fn is_symmetric(places: &[[f32; 2]]) -> bool {
    let near = |a: f32, b: f32| (a - b).abs() < SAME_PLACE;
    let middle = places.first().map_or(0.0, |first| first[0]);
    places.iter().all(|[x, y]| {
        let mut others = places.iter();
        others.any(|other| near(x + other[0], 2.0 * middle) && near(*y, other[1]))
    })
}

/// Whether a solid is in the flame of a source.
fn is_in_flame(pose: &Pose, source: &SourcePlace) -> bool {
    let from = (pose.frame.centre - source.base) / source.width;
    from.x.abs() < FLAME_WIDTHS && from.y > FLAME_FOOT_WIDTHS
}
