//! Parts that break off a body.

use std::sync::Arc;

use glam::Vec2;

use super::body::{Moments, Rigid};
use super::samples::Samples;
use super::state::FreeBodies;
use crate::scene::{Field, MAX_ID, MAX_OBJECTS, RoundedBox, Surface};
use crate::solids::{Body, LONGEST_MOTION, Solids};

/// What breaks off a body.
pub(crate) struct Piece {
    /// Its middle in the frame of the body \[m\], and its outline around that.
    pub middle: Vec2,
    pub field: Arc<Field>,
    /// Its share of the mass of the whole solid, around its middle.
    pub left: Moments,
}

impl FreeBodies {
    /// How many parts may break off a solid; `None` of one that no force moves.
    pub fn room_for_parts_of(&self, id: u32) -> Option<usize> {
        let moves = self.all.iter().any(|body| body.id == id && body.is_free);
        moves.then(|| MAX_OBJECTS.saturating_sub(self.all.len()))
    }

    /// Whether a body may have that outline.
    pub fn is_body(field: &Field) -> bool {
        !Samples::of_field(field).all().is_empty()
    }

    /// Lets a piece of a body go on as a body of its own, with the velocity that its material has; the
    /// rest keeps the id. Returns that of the piece. Mass and momenta stay the same.
    pub fn break_off(solids: &mut Solids, id: u32, rest: &Moments, piece: Piece) -> u32 {
        let Some(free) = &mut solids.free else {
            return 0;
        };
        free.parts += 1;
        let new = MAX_ID + free.parts;
        if let Some(body) = free.all.iter_mut().find(|body| body.id == id) {
            let amount = rest.amount + piece.left.amount;
            let part = body.part(new, piece, amount);
            body.leave(rest, amount);
            solids.bodies.extend(part.body_of(&solids.bodies));
            free.all.push(part);
        }
        free.make_room();
        new
    }

    /// Takes over the parts of the bodies of a scene.
    pub(super) fn keep_parts(&mut self, solids: &mut Solids, before: &[Rigid]) {
        for known in before.iter().filter(|part| part.is_part()) {
            let object = self.all.iter().find(|body| body.id == known.object);
            let part = object.map(|object| known.of_changed(object));
            if let Some((body, part)) =
                part.and_then(|part| Some((part.body_of(&solids.bodies)?, part)))
            {
                solids.bodies.push(body);
                self.all.push(part);
            }
        }
    }

    /// Removes the parts that are no longer there.
    pub fn remove_parts(solids: &mut Solids, is_there: &dyn Fn(u32) -> bool) {
        let Some(free) = &mut solids.free else {
            return;
        };
        let count = free.all.len();
        free.all.retain(|body| !body.is_part() || is_there(body.id));
        if free.all.len() < count {
            free.contacts.clear();
            free.old.clear();
            let bodies = &mut solids.bodies;
            bodies.retain(|body| body.id <= MAX_ID || is_there(body.id));
        }
    }
}

impl Rigid {
    /// Whether it has broken off.
    pub fn is_part(&self) -> bool {
        self.id != self.object
    }

    /// A piece of this body.
    fn part(&self, id: u32, piece: Piece, amount: f32) -> Rigid {
        let mut part = self.clone();
        part.id = id;
        part.asleep = false;
        part.still = 0.0;
        let frame = self.surface.frame;
        part.samples = Samples::of_field(&piece.field);
        part.surface = Surface {
            frame: RoundedBox {
                centre: frame.centre + frame.axis.rotate(piece.middle),
                half: piece.field.half,
                radius: 0.0,
                ..frame
            },
            field: Some(piece.field),
        };
        part.middle += piece.middle;
        part.leave(&piece.left, amount);
        part
    }

    /// The solid that the gas touches; `None` without that of its object.
    fn body_of(&self, bodies: &[Body]) -> Option<Body> {
        let object = bodies.iter().find(|body| body.id == self.object)?;
        let frame = self.surface.frame;
        let arm = frame.centre - self.centre;
        Some(Body {
            id: self.id,
            rest: frame,
            image: Vec2::ZERO,
            drive: None,
            driven: (self.velocity + arm.perp() * self.spin, self.spin),
            surface: self.surface.clone(),
            reach: frame.reach(),
            is_free: true,
            force: Vec2::ZERO,
            torque: 0.0,
            velocity: Vec2::ZERO,
            spin: 0.0,
            left: 0.0,
            since: LONGEST_MOTION,
            ..object.clone()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bounds::Bounds;
    use crate::params::Input;
    use crate::scene::Scene;
    use crate::solids::free::body::FreeSolid;

    const BOX: Bounds = Bounds {
        bottom: 0.0,
        width: 4.0,
        height: 4.0,
        periodic_x: false,
        periodic_y: false,
    };
    /// The size of a cell, and the pieces as their columns of it.
    const CELL: Vec2 = Vec2::new(0.05, 0.04);
    const PARTS: [std::ops::Range<i32>; 3] = [-6..-2, -1..3, 4..6];

    fn place(column: i32) -> Vec2 {
        Vec2::new(column as f32 + 0.5, 0.0) * CELL
    }

    /// The moments of pieces around a place: each column is heavier than that before it.
    fn moments(pieces: &[std::ops::Range<i32>], around: Vec2) -> Moments {
        let columns = pieces.iter().cloned().flatten();
        let columns =
            columns.map(|column| (0.02 + 0.003 * (column + 6) as f32, place(column) - around));
        Moments::of(columns, CELL)
    }

    /// Mass, momentum and angular momentum of all.
    fn totals(all: &[FreeSolid]) -> [f64; 4] {
        let mut sums = [0.0; 4];
        for body in all {
            let (mass, spin) = (f64::from(body.mass), f64::from(body.spin));
            let [x, y] = body.centre.to_array().map(f64::from);
            let [u, v] = body.velocity.to_array().map(f64::from);
            let turning = f64::from(body.inertia) * spin + mass * (x * v - y * u);
            for (sum, part) in sums.iter_mut().zip([mass, mass * u, mass * v, turning]) {
                *sum += part;
            }
        }
        sums
    }

    #[test]
    fn mass_and_both_momenta_stay_the_same_to_rounding() {
        // One is as heavy as its material, the other as the gas around it.
        for density in [500.0, 1.0] {
            let mut scene = Scene::default();
            let added = scene.add(&[
                ("kind", Input::Text("solid")),
                ("shape", Input::Text("box")),
                ("motion", Input::Text("free")),
                ("angle", Input::Number(33.0)),
                ("x", Input::Number(0.7)),
                ("y", Input::Number(1.3)),
                ("width", Input::Number(0.6)),
                ("height", Input::Number(0.04)),
                ("density", Input::Number(density)),
            ]);
            assert_eq!(added, Ok(2));
            let mut solids = Solids::of(&scene, &BOX, 0.1);
            let all = moments(&PARTS, Vec2::ZERO);
            if let Some(free) = &mut solids.free {
                free.weigh(2, &all);
                let body = &mut free.all[0];
                (body.velocity, body.spin) = (Vec2::new(0.8, -1.1), 5.0);
            }
            let seen = |solids: &Solids| solids.free.as_ref().map(|free| free.seen());
            let before = seen(&solids).unwrap_or_default();
            for (number, columns) in PARTS.iter().enumerate().skip(1) {
                let middle = 0.5 * (place(columns.start) + place(columns.end - 1));
                let half = Vec2::new(0.5 * columns.len() as f32, 0.5) * CELL;
                let inside = |at: Vec2| f32::from(u8::from(at.abs().cmplt(half).all()));
                let piece = Piece {
                    middle,
                    field: Arc::new(Field::of_opacity(half, 0.005, &inside)),
                    left: moments(std::slice::from_ref(columns), middle),
                };
                let others = [&PARTS[..1], &PARTS[number + 1..]].concat();
                let rest = moments(&others, Vec2::ZERO);
                let id = FreeBodies::break_off(&mut solids, 2, &rest, piece);
                assert_eq!(id, 1_000_000 + number as u32);
            }
            let after = seen(&solids).unwrap_or_default();
            assert_eq!(after.len(), 3);
            for (now, then) in totals(&after).into_iter().zip(totals(&before)) {
                assert!((now / then - 1.0).abs() < 1e-6, "{now}, not {then}");
            }
            // The gas touches each of them.
            let bodies: Vec<u32> = solids.bodies.iter().map(|body| body.id).collect();
            assert_eq!(bodies, [2, 1_000_001, 1_000_002]);
        }
    }
}
