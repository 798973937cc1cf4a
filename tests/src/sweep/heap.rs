//! Heaps of burning bodies: they stay finite, and no gas is inside.
//!
//! A heap is coarse open air on a floor with free solids of every shape, which burn: random in
//! material, size, place and angle, so that some begin in one another. A part of it is lit. Into some
//! a chain of burning links hangs, and in some bodies hang from others at random.

use std::fmt::Write as _;

use hearth_core::params::{Input, Motion, Solid};
use hearth_core::random::Random;
use hearth_core::scene::Surface;
use hearth_core::{Charred, IgnitionTarget, Scene, Simulation, Vec2};

use super::crowd::{MASKS, POLYGONS, SHAPES, STROKES, scaled};
use super::{Outcome, described, watched};
use crate::fires::{combustion, in_the_open, on_floor};

/// Fewest bodies of a heap, and most.
const BODIES: (u32, u32) = (3, 20);
/// Width of a heap \[m\], and its height for each body.
const WIDTH: f32 = 0.7;
const HEIGHT_OF_EACH: f32 = 0.06;
/// Sizes of bodies \[m\].
const SIZES: (f32, f32) = (0.02, 0.25);
/// Distance of the particles \[m\], and the most of them.
const SPACING: f64 = 0.1;
const PARTICLES: u32 = 700;
/// Radius of what is lit \[m\], and when it is lit \[s\].
const LIT: (f32, f32) = (0.05, 0.4);
const LIGHTING: f64 = 0.5;
/// One heap in this number lies on a solid that stirs it.
const STIRRED: u32 = 4;
/// One heap in this number has a chain, and one has bodies that hang from others; most links of a
/// chain, their sizes and the height of its hook \[m\].
const HUNG: u32 = 2;
const LINKS: u32 = 12;
const LINK: (f32, f32) = (0.04, 0.12);
const HOOK: (f32, f32) = (0.4, 1.0);
/// Largest distance of a body from the middle of the frame \[m\], and how deep one is in the floor
/// at most, which is where the solver puts back a body that others press down, and the corners of its discs.
const FARTHEST: f32 = 41.0;
const DEEPEST: f32 = 0.03;
/// Steps from one look at that to the next, and places along a side of a body.
const LOOKED_AT: u32 = 16;
const GRID: usize = 40;

/// Free bodies that burn.
#[derive(Clone, Debug)]
pub struct Heap {
    scene: Scene,
    bodies: u32,
    /// What is lit: the middle and the radius \[m\].
    lit: (Vec2, f32),
}

impl Heap {
    /// A random heap.
    ///
    /// # Panics
    /// If an object is refused, because the test is wrong.
    pub fn random(random: &mut Random) -> Heap {
        let bodies = BODIES.0 + random.bits() % (BODIES.1 - BODIES.0 + 1);
        // Every second heap lies on a burner.
        let power = f64::from(random.between(-60.0, 60.0).max(0.0));
        let mut scene = on_floor(in_the_open(
            combustion(&[
                ("fuel_power", power),
                ("ember_rate", 20.0),
                ("wind", f64::from(random.between(-1.0, 1.0))),
                ("seed", f64::from(random.bits())),
            ]),
            PARTICLES,
        ));
        assert_eq!(scene.set("spacing", SPACING), Ok(()));
        if random.bits().is_multiple_of(STIRRED) {
            let motion = ["sway", "spin"][random.bits() as usize % 2];
            let added = scene.add(&[
                ("kind", Input::Text("solid")),
                ("shape", Input::Text("box")),
                ("motion", Input::Text(motion)),
                ("y", Input::Number(0.1)),
                ("width", Input::Number(0.3)),
                ("height", Input::Number(0.04)),
                ("spin", Input::Number(random.between(-180.0, 180.0).into())),
                ("period", Input::Number(random.between(1.0, 4.0).into())),
            ]);
            assert!(added.is_ok(), "{added:?}");
        }
        for _ in 0..bodies {
            add(&mut scene, bodies, random);
        }
        let half = 0.5 * WIDTH;
        let middle = Vec2::new(random.between(-half, half), random.between(0.0, 0.3));
        let lit = (middle, random.between(LIT.0, LIT.1));
        if random.bits().is_multiple_of(HUNG) {
            add_chain(&mut scene, random);
        }
        if random.bits().is_multiple_of(HUNG) {
            hang_some(&mut scene, random);
        }
        Heap { scene, bodies, lit }
    }

    /// The settings and the bodies, as one line.
    pub fn described(&self) -> String {
        let mut text = described(&self.scene);
        let _ = write!(text, "; {} bodies, lit at {:?}", self.bodies, self.lit);
        text
    }

    /// Burns for a time, and checks every step.
    pub fn burn(self, seconds: f64) -> Outcome {
        let mut fire = Simulation::new(self.scene);
        let (middle, radius) = self.lit;
        let (mut is_lit, mut steps) = (false, 0_u32);
        watched(&mut fire, seconds, &mut |fire| {
            if !is_lit && fire.time() >= LIGHTING {
                // Where there is none, nothing is lit, as on a page.
                let _ = fire.ignite(IgnitionTarget::Place(middle, radius));
                is_lit = true;
            }
            let mut wrong = gas_in_what_is_left(fire).or_else(|| wrong(fire));
            steps += 1;
            if steps.is_multiple_of(LOOKED_AT) {
                wrong = wrong.or_else(|| sunk(fire));
            }
            wrong.map(|text| format!("step at {} s: {text}", fire.time()))
        })
    }
}

/// Adds a body to a heap of so many.
fn add(scene: &mut Scene, bodies: u32, random: &mut Random) {
    let bits = random.bits() as usize;
    let shape = SHAPES[bits % SHAPES.len()];
    let fuel = ["wood", "paper", "coal", "wax", "cloth"][bits / 8 % 5];
    let extent = random.between(SIZES.0, SIZES.1);
    let outline = match shape {
        "polygon" => POLYGONS[bits / 64 % POLYGONS.len()],
        _ => STROKES[bits / 64 % STROKES.len()],
    };
    let points = scaled(outline, extent);
    // Each order of magnitude is as frequent.
    let mut decades = |low: f64, high: f64| low * (high / low).powf(random.unit().into());
    let (load, density) = (decades(0.05, 20.0), decades(2.0, 2000.0));
    let mut between = |low: f32, high: f32| f64::from(random.between(low, high));
    let added = scene.add(&[
        ("kind", Input::Text("solid")),
        ("shape", Input::Text(shape)),
        ("motion", Input::Text("free")),
        ("fuel", Input::Text(fuel)),
        ("load", Input::Number(load)),
        ("density", Input::Number(density)),
        ("moisture", Input::Number(between(0.0, 30.0))),
        ("friction", Input::Number(between(0.0, 1.0))),
        ("restitution", Input::Number(between(0.0, 0.8))),
        ("x", Input::Number(between(-0.5 * WIDTH, 0.5 * WIDTH))),
        (
            "y",
            Input::Number(between(0.05, 0.2 + HEIGHT_OF_EACH * bodies as f32)),
        ),
        ("angle", Input::Number(between(-180.0, 180.0))),
        ("width", Input::Number(extent.into())),
        ("height", Input::Number(between(0.01, extent))),
        ("corner", Input::Number(between(0.0, 0.3 * extent))),
        ("points", Input::Text(&points)),
        ("mask", Input::Text(MASKS[bits / 64 % MASKS.len()])),
    ]);
    assert!(added.is_ok(), "{added:?}");
}

/// Lets some bodies hang from others, wherever these are, some of them in a circle.
fn hang_some(scene: &mut Scene, random: &mut Random) {
    let ids: Vec<u32> = scene.surfaces().map(|surface| surface.0).collect();
    for &id in &ids {
        let from = ids[random.bits() as usize % ids.len()];
        if random.bits().is_multiple_of(HUNG) {
            let hung = scene.change(id, &[("hangs_from", Input::Number(from.into()))]);
            assert_eq!(hung, Ok(()));
        }
    }
}

/// Adds a chain that hangs from a hook into a heap.
fn add_chain(scene: &mut Scene, random: &mut Random) {
    let mut between = |(low, high): (f32, f32)| random.between(low, high);
    let half = 0.5 * WIDTH;
    let mut end = Vec2::new(between((-half, half)), between(HOOK));
    let solid = ("kind", Input::Text("solid"));
    let place = |at: Vec2| [at.x, at.y].map(|n| Input::Number(n.into()));
    let [x, y] = place(end);
    let hook = scene.add(&[solid, ("x", x), ("y", y), ("width", Input::Number(0.03))]);
    let mut from = hook.unwrap_or_default();
    for _ in 0..1 + between((0.0, LINKS as f32)) as u32 {
        let length = between(LINK);
        let angle = between((30.0, 150.0));
        let path = Vec2::from_angle(angle.to_radians()) * length;
        let [x, y] = place(end - 0.5 * path);
        end -= path;
        let number = |n: f32| Input::Number(n.into());
        let added = scene.add(&[
            solid,
            ("shape", Input::Text("line")),
            ("motion", Input::Text("free")),
            ("fuel", Input::Text("cloth")),
            ("hangs_from", number(from as f32)),
            ("load", number(between((0.1, 2.0)))),
            ("density", number(between((10.0, 500.0)))),
            ("x", x),
            ("y", y),
            ("angle", number(angle)),
            ("width", number(length)),
            ("height", number(between((0.01, 0.04)))),
        ]);
        assert!(added.is_ok(), "{added:?}");
        from = added.unwrap_or_default();
    }
}

/// What is left of each solid and of its parts, where it is now.
fn left(fire: &Simulation) -> impl Iterator<Item = (u32, &Solid, Surface)> {
    let mut charred = Charred::default();
    fire.write_charred(&mut charred);
    let burning = charred.solids;
    let parts = burning.iter().filter_map(|part| {
        let (frame, field) = (part.part?, part.left.clone());
        let mut all = fire.scene().surfaces();
        let (id, solid, _) = all.find(|surface| surface.0 == part.id)?;
        Some((id, solid, Surface { frame, field }))
    });
    let parts: Vec<_> = parts.collect();
    let surfaces = fire.scene().surfaces().zip(fire.poses());
    let whole = surfaces.map(move |((id, solid, surface), pose)| {
        let mut surface = Surface {
            frame: pose.frame,
            field: surface.field.clone(),
        };
        let found = burning.iter().find(|solid| solid.id == id);
        if let Some(left) = found.and_then(|found| found.left.as_ref()) {
            (surface.frame.half, surface.frame.radius) = (left.half, 0.0);
            surface.field = Some(left.clone());
        }
        (id, solid, surface)
    });
    whole.chain(parts)
}

/// Gas in what is left of a solid, if there is any.
pub fn gas_in_what_is_left(fire: &Simulation) -> Option<String> {
    let positions = fire.positions();
    for (id, solid, surface) in left(fire) {
        let (centre, reach) = (surface.frame.centre, surface.frame.reach());
        let near = |at: &&Vec2| at.distance_squared(centre) <= reach * reach;
        let mut near = positions.iter().filter(near);
        if let Some(&at) = near.find(|at| surface.distance(**at).0 <= 0.0) {
            let (depth, shape) = (-surface.distance(at).0, solid.shape);
            return Some(format!(
                "gas is {depth} m inside of solid {id}, a {shape:?}, at {at}"
            ));
        }
    }
    None
}

/// A body in the floor, if there is one.
fn sunk(fire: &mut Simulation) -> Option<String> {
    for (id, solid, surface) in left(fire).filter(|entry| entry.1.motion == Motion::Free) {
        let frame = surface.frame;
        let (half, axis) = (frame.half + frame.radius, frame.axis);
        for index in 0..GRID * GRID {
            let (column, row) = (index % GRID, index / GRID);
            let share = Vec2::new(column as f32, row as f32) / (GRID as f32 - 1.0);
            let at = frame.centre + axis.rotate((2.0 * share - 1.0) * half);
            if at.y < -DEEPEST && surface.distance(at).0 < 0.0 {
                let (depth, shape) = (-at.y, solid.shape);
                return Some(format!(
                    "solid {id}, a {shape:?}, is {depth} m in the floor"
                ));
            }
        }
    }
    None
}

/// What is wrong with the bodies, if anything is.
fn wrong(fire: &Simulation) -> Option<String> {
    for body in fire.free_solids() {
        let (place, motion) = (body.place, [body.spin, body.angle, body.mass, body.inertia]);
        let finite = body.velocity.is_finite() && motion.iter().all(|n| n.is_finite());
        let inside = place.is_finite() && place.length() < FARTHEST;
        if !finite || !inside || body.mass < 0.0 {
            return Some(format!("there is {body:?}"));
        }
    }
    for solid in fire.burning_solids() {
        let masses = [solid.fuel, solid.water, solid.char, solid.stored, solid.gas];
        let valid =
            (0.0..6000.0).contains(&solid.hottest) && solid.power.is_finite() && solid.first > 0.0;
        if !valid || !masses.iter().all(|n| n.is_finite()) || solid.fuel < 0.0 {
            return Some(format!("there is {solid:?}"));
        }
    }
    None
}
