//! Fires among solids that move and turn: no gas is ever inside.
//!
//! A crowd is a corner of the parameter ranges with solids of every shape, outlines included.
//! They move as a page moves them, sixty times a second, and turn back at the edges of the frame.

use std::f32::consts::PI;
use std::fmt::Write as _;

use hearth_core::params::{Edges, Input, Model, Walls};
use hearth_core::random::Random;
use hearth_core::scene::Surface;
use hearth_core::{Scene, Simulation, Vec2};

use super::{MAX_CLAMPED, Outcome, PARTICLES, corner, described, open_corner, set, watched};

/// Fewest solids of a crowd, and most.
const SOLIDS: (u32, u32) = (8, 16);
/// Most solids, and most sources, of a scene.
pub const MOST: u32 = 64;
/// One crowd in this number has the most solids and the most sources.
const FULL: u32 = 16;
/// Largest speed of a surface [m/s].
const FASTEST: f32 = 3.0;
/// Time between two motions \[s\].
const FRAME: f64 = 1.0 / 60.0;
/// Sizes of solids, as shares of the shorter side of the frame. Larger ones are pistons that
/// squeeze the gas of a closed domain beyond the speed of sound.
const SIZES: (f32, f32) = (0.03, 0.25);
/// Share of all steps of all particles that a guard may hold without a seam: nothing but friction
/// then stops the gas of a closed domain that solids stir.
const STIRRED: f64 = 2.0 * MAX_CLAMPED;
/// The names of the shapes.
pub(super) const SHAPES: [&str; 6] = ["circle", "box", "line", "polygon", "stroke", "mask"];
/// A star, a concave hook, and one that crosses itself; a ring with a gap, and a zigzag.
pub(super) const POLYGONS: [&[[f32; 2]]; 3] = [
    &[
        [0.0, 0.5],
        [-0.3, -0.4],
        [0.5, 0.15],
        [-0.5, 0.15],
        [0.3, -0.4],
    ],
    &[
        [-0.5, -0.15],
        [0.5, -0.25],
        [0.5, 0.25],
        [0.25, 0.0],
        [0.0, 0.3],
    ],
    &[[-0.4, -0.4], [0.4, 0.4], [0.4, -0.4], [-0.4, 0.4]],
];
pub(super) const STROKES: [&[[f32; 2]]; 2] = [
    &[
        [0.3, 0.4],
        [-0.4, 0.4],
        [-0.4, -0.4],
        [0.4, -0.4],
        [0.4, 0.15],
        [0.05, 0.0],
    ],
    &[[-0.5, 0.0], [-0.2, 0.3], [0.1, -0.3], [0.5, 0.2]],
];
/// A ring, and a bar with a hole.
pub(super) const MASKS: [&str; 2] = ["8x8:XsQsQoQoQoQoQsVPX", "8x4:3PSqSo"];

/// An outline of that extent \[m\], as the points of a solid.
pub(super) fn scaled(outline: &[[f32; 2]], extent: f32) -> String {
    let point = |[x, y]: &[f32; 2]| format!("{:.5},{:.5}", x * extent, y * extent);
    let points: Vec<String> = outline.iter().map(point).collect();
    points.join(" ")
}

/// How a solid moves: its velocity [m/s] and its angular velocity [1/s].
#[derive(Clone, Copy, Debug)]
struct Motion {
    id: u32,
    velocity: Vec2,
    spin: f32,
}

/// A scene whose solids move.
#[derive(Clone, Debug)]
pub struct Crowd {
    scene: Scene,
    motions: Vec<Motion>,
}

impl Crowd {
    /// A corner of the combustion model in a closed domain, with solids. It has the larger number
    /// of particles: with fewer, the narrowest domain is narrower than a kernel.
    pub fn closed(random: &mut Random) -> Crowd {
        let mut scene = corner(Model::Combustion, random);
        set(&mut scene, "particles", Input::Number(PARTICLES.1));
        Crowd::in_fire(scene, random)
    }

    /// A corner of the combustion model in the open, with solids.
    pub fn open(random: &mut Random) -> Crowd {
        let scene = open_corner(random);
        Crowd::in_fire(scene, random)
    }

    /// A corner of the classic model, with solids.
    pub fn classic(random: &mut Random) -> Crowd {
        let scene = corner(Model::Classic, random);
        Crowd::in_fire(scene, random)
    }

    fn in_fire(scene: Scene, random: &mut Random) -> Crowd {
        let is_full = random.bits().is_multiple_of(FULL);
        let solids = SOLIDS.0 + random.bits() % (SOLIDS.1 - SOLIDS.0);
        let (solids, sources) = if is_full {
            (MOST, MOST)
        } else {
            (solids, 1 + random.bits() % 3)
        };
        Crowd::of(scene, solids, sources, random)
    }

    /// So many solids and sources in a fire.
    ///
    /// # Panics
    /// If an object is refused, because the test is wrong.
    pub fn of(scene: Scene, solids: u32, sources: u32, random: &mut Random) -> Crowd {
        let mut crowd = Crowd {
            scene,
            motions: Vec::new(),
        };
        for _ in 1..sources {
            let half = 0.5 * crowd.scene.world().domain_width;
            let x = random.between(-half, half);
            let added = crowd.scene.add(&[
                ("kind", Input::Text("source")),
                ("x", Input::Number(x.into())),
                ("y", Input::Number(random.unit().into())),
                ("angle", Input::Number(random.between(-180.0, 180.0).into())),
            ]);
            assert!(added.is_ok(), "{added:?}");
        }
        for number in 0..solids {
            crowd.add(number, solids, random);
        }
        crowd
    }

    fn add(&mut self, number: u32, solids: u32, random: &mut Random) {
        let settings = self.scene.world();
        let frame = Vec2::new(settings.domain_width, settings.domain_height);
        let unit = frame.min_element() * (8.0 / solids as f32).sqrt();
        let mut size = || {
            let size = unit * random.between(SIZES.0, SIZES.1);
            size.clamp(0.002, 10.0)
        };
        let (width, height, extent) = (size(), size(), size());
        let shape = SHAPES[number as usize % SHAPES.len()];
        let outline = match shape {
            "polygon" => POLYGONS[random.bits() as usize % POLYGONS.len()],
            _ => STROKES[random.bits() as usize % STROKES.len()],
        };
        let points = scaled(outline, extent);
        let mask = MASKS[random.bits() as usize % MASKS.len()];
        let motion = ["still", "still", "sway", "spin"][random.bits() as usize % 4];
        let thermal = ["adiabatic", "fixed", "conducting"][random.bits() as usize % 3];
        let mut between = |low: f32, high: f32| f64::from(random.between(low, high));
        let thickness = if number.is_multiple_of(2) { 0.2 } else { 1.0 };
        let added = self.scene.add(&[
            ("kind", Input::Text("solid")),
            ("shape", Input::Text(shape)),
            (
                "x",
                Input::Number(between(-0.55, 0.55) * f64::from(frame.x)),
            ),
            (
                "y",
                Input::Number(between(-0.05, 1.05) * f64::from(frame.y)),
            ),
            ("angle", Input::Number(between(-180.0, 180.0))),
            ("width", Input::Number(width.into())),
            (
                "height",
                Input::Number(f64::from(height * thickness).max(0.002)),
            ),
            (
                "corner",
                Input::Number(between(0.0, 0.5) * f64::from(height)),
            ),
            ("points", Input::Text(&points)),
            ("mask", Input::Text(mask)),
            ("thermal", Input::Text(thermal)),
            ("temperature", Input::Number(between(250.0, 2500.0))),
            ("heat_capacity", Input::Number(between(10.0, 1000.0))),
            ("motion", Input::Text(motion)),
            ("sway", Input::Number(between(0.0, 1.0))),
            ("heading", Input::Number(between(-180.0, 180.0))),
            ("period", Input::Number(between(0.5, 4.0))),
            ("spin", Input::Number(between(-720.0, 720.0))),
        ]);
        let id = match added {
            Ok(id) => id,
            Err(refused) => panic!("{refused:?}"),
        };
        // The fastest point of the surface is at most as fast as gas follows.
        let (speed, turning) = (random.between(0.0, FASTEST), random.unit());
        let direction = Vec2::from_angle(random.between(-PI, PI));
        let reach = 0.7 * (width + height).max(extent);
        self.motions.push(Motion {
            id,
            velocity: direction * speed * (1.0 - turning),
            spin: speed * turning / reach,
        });
    }

    /// Moves the solids on by a time \[s\].
    fn advance(&mut self, seconds: f32) {
        let settings = self.scene.world();
        let frame = Vec2::new(settings.domain_width, settings.domain_height);
        for motion in &mut self.motions {
            let found = self.scene.objects().find(|object| object.id == motion.id);
            let Some(solid) = found.and_then(|object| object.solid().cloned()) else {
                continue;
            };
            let at = Vec2::new(solid.x, solid.y) + motion.velocity * seconds;
            let middle = Vec2::new(0.0, 0.5 * frame.y);
            let beyond = (at - middle).abs().cmpgt(0.55 * frame);
            let outward = (at - middle) * motion.velocity;
            if beyond.x && outward.x > 0.0 {
                motion.velocity.x *= -1.0;
            }
            if beyond.y && outward.y > 0.0 {
                motion.velocity.y *= -1.0;
            }
            let turned = solid.angle + (motion.spin * seconds).to_degrees();
            let turned = if turned > 180.0 {
                turned - 360.0
            } else {
                turned
            };
            let at = at.clamp(Vec2::splat(-10.0), Vec2::splat(10.0));
            let changed = self.scene.change(
                motion.id,
                &[
                    ("x", Input::Number(at.x.into())),
                    ("y", Input::Number(at.y.into())),
                    ("angle", Input::Number(turned.into())),
                ],
            );
            debug_assert_eq!(changed, Ok(()));
        }
    }

    /// The settings and the shapes of the solids, as one line.
    pub fn described(&self) -> String {
        let mut text = described(&self.scene);
        let _ = write!(text, "; {} sources", self.scene.sources().count());
        let _ = write!(text, ", {} solids", self.motions.len());
        text
    }

    /// Burns for a time while the solids move, and checks every step.
    pub fn burn(mut self, seconds: f64) -> Outcome {
        let mut fire = Simulation::new(self.scene.clone());
        let (mut next, mut moved) = (FRAME, 0.0);
        if let Some(inside) = gas_inside(&fire) {
            return Outcome {
                broken: Some(inside),
                ..Outcome::default()
            };
        }
        let outcome = watched(&mut fire, seconds, &mut |fire| {
            let mut inside = gas_inside(fire).map(|t| format!("step at {} s: {t}", fire.time()));
            if fire.time() >= next {
                // As a page does: late by a part of a step, and by the true time.
                self.advance((fire.time() - moved) as f32);
                (moved, next) = (fire.time(), next + FRAME);
                fire.set_scene(self.scene.clone());
                inside = inside.or_else(|| gas_inside(fire));
            }
            inside
        });
        let values = fire.parameters();
        let is_closed = values.model() == Model::Combustion && values.edges == Edges::Periodic;
        if is_closed && values.seam == 0.0 {
            return Outcome {
                allowed: STIRRED,
                ..outcome
            };
        }
        outcome
    }
}

/// Gas in a solid or in its image beyond a periodic edge, if there is any.
pub fn gas_inside(fire: &Simulation) -> Option<String> {
    let settings = fire.parameters();
    let period = Vec2::new(settings.domain_width, settings.domain_height);
    let (columns, rows) = match (settings.model(), settings.edges) {
        (Model::Combustion, Edges::Open) => (0, 0),
        (Model::Combustion, Edges::Periodic) => (1, 1),
        (Model::Classic, _) => (i32::from(settings.walls == Walls::Periodic), 0),
    };
    let positions = fire.positions();
    let poses = fire.poses();
    for ((id, solid, surface), pose) in fire.scene().surfaces().zip(&poses) {
        let surface = Surface {
            frame: pose.frame,
            field: surface.field.clone(),
        };
        let (centre, reach) = (surface.frame.centre, surface.frame.reach());
        for row in -rows..=rows {
            for column in -columns..=columns {
                let shift = Vec2::new(column as f32, row as f32) * period;
                if shift != Vec2::ZERO && !has_images(&surface, period) {
                    continue;
                }
                let mut near = positions.iter().map(|&at| at - shift);
                let inside = near.find(|at| {
                    at.distance_squared(centre) <= reach * reach && surface.distance(*at).0 <= 0.0
                });
                if let Some(at) = inside {
                    let depth = -surface.distance(at).0;
                    let shape = solid.shape;
                    return Some(format!(
                        "gas is {depth} m inside of solid {id}, a {shape:?}, at {at} + {shift}"
                    ));
                }
            }
        }
    }
    None
}

/// Whether a solid at a periodic edge is in the gas beyond it too: one that reaches around the
/// domain or lies outside has no image.
fn has_images(surface: &Surface, period: Vec2) -> bool {
    let centre = surface.frame.centre - Vec2::new(0.0, 0.5 * period.y);
    let outside = centre.abs() - 0.5 * period;
    2.0 * surface.frame.reach() < period.min_element() && outside.max_element() < 0.0
}
