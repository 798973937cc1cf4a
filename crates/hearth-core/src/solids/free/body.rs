//! A rigid body: its mass and its motion.

use std::sync::Arc;

use glam::Vec2;

use super::samples::Samples;
use crate::bounds::Bounds;
use crate::extremes::{fast_max, fast_min};
use crate::params::{Motion, Physics, Solid};
use crate::scene::{MAX_SPEED, RoundedBox, Surface};
use crate::solids::Body;

/// Places along a side at which a surface is weighed.
const MEASURED_PLACES: usize = 32;
/// Greatest speed of a body that hinges move [m/s]: at [`MAX_SPEED`], a chain stretches where it swings
/// fastest.
pub(super) const MAX_HINGED_SPEED: f32 = 1.1 * MAX_SPEED;
/// Distance from the middle of the domain at which a body stops \[m\].
const MAX_DISTANCE: f32 = 40.0;
/// Layer of gas around a body that it weighs at least as much as, in spacings.
const GAS_LAYER: f32 = 0.5;
/// Time over which the push of the gas is averaged \[s\].
const PUSH_AVERAGING_TIME: f32 = 0.1;

/// An amount, its centre, and the square of its radius of gyration \[m²\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Moments {
    pub amount: f32,
    pub centre: Vec2,
    pub gyration: f32,
}

impl Moments {
    /// Those of amounts at places, each of which is spread over a rectangle of this size.
    pub fn of(all: impl Iterator<Item = (f32, Vec2)>, size: Vec2) -> Moments {
        let (mut amount, mut first, mut second) = (0.0, Vec2::ZERO, 0.0);
        for (part, at) in all {
            amount += part;
            first += at * part;
            second += at.length_squared() * part;
        }
        let divisor = fast_max(amount, 1e-12);
        let centre = first / divisor;
        let around = second / divisor - centre.length_squared() + size.length_squared() / 12.0;
        Moments {
            amount,
            centre,
            gyration: fast_max(around, 1e-8),
        }
    }

    /// Those of the area of a surface, in its frame.
    fn of_surface(surface: &Surface) -> Moments {
        let half = surface.frame.half + surface.frame.radius;
        let shape = Surface {
            frame: RoundedBox {
                centre: Vec2::ZERO,
                axis: Vec2::X,
                ..surface.frame
            },
            field: surface.field.clone(),
        };
        let size = 2.0 * half / MEASURED_PLACES as f32;
        let (cell, smaller) = (size.x * size.y, fast_min(size.x, size.y));
        let places = (0..MEASURED_PLACES * MEASURED_PLACES).map(|index| {
            let (column, row) = (index % MEASURED_PLACES, index / MEASURED_PLACES);
            let at = Vec2::new(column as f32 + 0.5, row as f32 + 0.5) * size - half;
            let (distance, _) = shape.distance(at);
            let share = fast_min(fast_max(0.5 - distance / smaller, 0.0), 1.0);
            (share * cell, at)
        });
        Moments::of(places, size)
    }
}

/// A solid that forces move, as it is now.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FreeSolid {
    /// Its id: that of the object or, of a part that has broken off, one above 1,000,000.
    pub id: u32,
    /// The id of the object that it is, or that it was a part of.
    pub object: u32,
    /// Its place \[m\] and its angle \[°\], as those of a solid in a scene.
    pub place: Vec2,
    /// Angle from -180 to 180 \[°\].
    pub angle: f32,
    /// Its centre of mass \[m\].
    pub centre: Vec2,
    /// Velocity of its centre of mass [m/s].
    pub velocity: Vec2,
    /// Angular velocity, counterclockwise [1/s].
    pub spin: f32,
    /// Mass for each metre of depth [kg/m]; 0 of one of which nothing is left.
    pub mass: f32,
    /// Moment of inertia about the centre of mass [kg·m].
    pub inertia: f32,
    /// Whether it rests, and stays where it is until something moves it.
    pub asleep: bool,
}

/// The inverse of a positive number, and 0 of 0.
fn whole(inverse: f32) -> f32 {
    if inverse > 0.0 { 1.0 / inverse } else { 0.0 }
}

/// A solid that forces move, or another that it may touch.
#[derive(Clone, Debug)]
pub(super) struct Rigid {
    pub id: u32,
    /// The id of the object that it is, or that it was a part of.
    pub object: u32,
    pub is_free: bool,
    /// Its place and angle in the scene, and its frame there.
    start: [f32; 3],
    pub(super) first: RoundedBox,
    /// The id of the solid that it hangs from, and those that it is hinged to, as bits.
    pub(super) hangs_from: u32,
    pub(super) hinged: u64,
    /// Whether its hinges tear it.
    pub(super) is_torn: bool,
    /// Its surface where it is now.
    pub surface: Surface,
    pub samples: Samples,
    /// Centre of mass, and the same in the frame of the surface.
    pub centre: Vec2,
    pub(super) offset: Vec2,
    /// From the place of the solid to the middle of its frame, in that.
    pub(super) middle: Vec2,
    pub velocity: Vec2,
    pub spin: f32,
    /// Mass of all of it and the least mass [kg/m]; the area in which there is no air \[m²\] times the
    /// density of air.
    full: f32,
    least: f32,
    air: f32,
    /// Its share of the least mass of the whole.
    share: f32,
    pub inverse_mass: f32,
    pub inverse_inertia: f32,
    /// Share of the weight that air does not carry.
    pub weight: f32,
    pub friction: f32,
    pub restitution: f32,
    /// For how long it has been still \[s\], and whether it is asleep.
    pub still: f32,
    pub asleep: bool,
    /// Whether it touches a solid, and the push of the gas as a share of its weight.
    pub touches: bool,
    pub pushed: f32,
    /// The first body of those that it touches.
    pub root: usize,
}

crate::state! {
    Rigid: id object is_free start first hangs_from hinged is_torn surface samples centre offset middle velocity
        spin full least air share inverse_mass inverse_inertia weight friction restitution still asleep touches
        pushed root
}

impl Rigid {
    /// A solid of a scene at its place.
    pub fn of(id: u32, solid: &Solid, surface: &Surface, values: &Physics) -> Rigid {
        let is_free = solid.motion == Motion::Free;
        let surface = solid.surface_with(surface.field.clone());
        let (area, round) = surface.measures();
        let mut body = Rigid {
            id,
            object: id,
            is_free,
            start: [solid.x, solid.y, solid.angle],
            first: surface.frame,
            hangs_from: solid.hangs_from,
            hinged: 0,
            is_torn: false,
            samples: Samples::of(&surface),
            centre: surface.frame.centre,
            offset: Vec2::ZERO,
            middle: surface
                .field
                .as_ref()
                .map_or(Vec2::ZERO, |field| field.middle),
            velocity: Vec2::ZERO,
            spin: 0.0,
            full: solid.density * area,
            least: GAS_LAYER * values.spacing() * values.ambient_density * round,
            air: values.ambient_density * area,
            share: 1.0,
            inverse_mass: 0.0,
            inverse_inertia: 0.0,
            weight: 1.0,
            friction: solid.friction,
            restitution: solid.restitution,
            still: 0.0,
            asleep: false,
            touches: false,
            pushed: 0.0,
            root: 0,
            surface,
        };
        if is_free {
            let shape = Moments::of_surface(&body.surface);
            body.weigh(&Moments {
                amount: 1.0,
                ..shape
            });
        }
        body
    }

    /// Continues the motion of the same body before a change of the scene.
    pub fn continue_from(&mut self, known: &Rigid) {
        if !(self.is_free && known.is_free && self.start == known.start) {
            return;
        }
        let frame = &mut self.surface.frame;
        (frame.centre, frame.axis) = (known.surface.frame.centre, known.surface.frame.axis);
        self.centre = frame.centre + frame.axis.rotate(self.offset);
        let path = self.centre - known.centre;
        (self.velocity, self.spin) = (known.velocity + path.perp() * known.spin, known.spin);
        self.share = known.share;
    }

    /// This part of a body that has changed.
    pub fn of_changed(&self, whole: &Rigid) -> Rigid {
        Rigid {
            full: whole.full,
            least: whole.least,
            air: whole.air,
            friction: whole.friction,
            restitution: whole.restitution,
            ..self.clone()
        }
    }

    /// Leaves it what is left, of that amount of all before it broke.
    pub fn leave(&mut self, left: &Moments, amount: f32) {
        self.share *= left.amount / fast_max(amount, 1e-12);
        self.weigh(left);
    }

    /// Gives it a share of its mass around another centre.
    pub fn weigh(&mut self, left: &Moments) {
        let frame = &self.surface.frame;
        let before = self.centre;
        self.offset = left.centre;
        self.centre = frame.centre + frame.axis.rotate(left.centre);
        // The material keeps its velocity.
        self.velocity += (self.centre - before).perp() * self.spin;
        let mass = fast_max(self.full * left.amount, self.least * self.share);
        if self.is_free && mass > 0.0 && !self.is_gone() {
            self.inverse_mass = 1.0 / mass;
            self.inverse_inertia = 1.0 / (mass * fast_max(left.gyration, 1e-8));
            self.weight = 1.0 - fast_min(self.air * left.amount / mass, 2.0);
        }
    }

    /// Takes over a surface that has changed and, if no force moves it, where the solid is.
    pub fn follow(&mut self, body: &Body) {
        let same = match (&self.surface.field, &body.surface.field) {
            (Some(first), Some(second)) => Arc::ptr_eq(first, second),
            (None, None) => true,
            _ => false,
        };
        if !same {
            self.surface.field.clone_from(&body.surface.field);
            let (frame, new) = (&mut self.surface.frame, &body.surface.frame);
            (frame.half, frame.radius) = (new.half, new.radius);
            self.samples = Samples::of(&self.surface);
            self.wake();
            if self.is_gone() {
                (self.inverse_mass, self.inverse_inertia) = (0.0, 0.0);
                (self.velocity, self.spin) = (Vec2::ZERO, 0.0);
            }
        }
        if !self.is_free {
            self.surface.frame = body.surface.frame;
            self.centre = body.surface.frame.centre;
            let (velocity, spin) = body.driven;
            (self.velocity, self.spin) = (body.velocity + velocity, body.spin + spin);
        }
    }

    /// Whether nothing is left of it.
    pub fn is_gone(&self) -> bool {
        self.samples.all().is_empty()
    }

    /// Whether forces move it now.
    pub fn is_awake(&self) -> bool {
        self.is_free && !self.asleep && !self.is_gone()
    }

    /// Whether it may move.
    pub fn is_live(&self) -> bool {
        self.is_awake() || !self.is_free && self.speed() > 0.0
    }

    /// The greatest speed of a part of it [m/s].
    pub fn speed(&self) -> f32 {
        self.velocity.length() + self.spin.abs() * self.surface.frame.reach()
    }

    /// Accelerates it by a force [N/m] and a torque about the middle of its frame \[N\] of the gas.
    pub fn apply_gas_force(&mut self, force: Vec2, torque: f32, gravity: f32, dt: f32) {
        let push = force.length() * self.inverse_mass / gravity;
        self.pushed += (push - self.pushed) * fast_min(dt / PUSH_AVERAGING_TIME, 1.0);
        if self.is_awake() && push.is_finite() && torque.is_finite() {
            let arm = self.surface.frame.axis.rotate(self.offset);
            self.velocity += force * (self.inverse_mass * dt);
            self.spin += (torque - arm.perp_dot(force)) * self.inverse_inertia * dt;
        }
    }

    /// What a reader sees of it.
    pub fn seen(&self) -> FreeSolid {
        let (place, axis) = self.place();
        FreeSolid {
            id: self.id,
            object: self.object,
            place,
            angle: libm::atan2f(axis.y, axis.x).to_degrees(),
            centre: self.centre,
            velocity: self.velocity,
            spin: self.spin,
            mass: whole(self.inverse_mass),
            inertia: whole(self.inverse_inertia),
            asleep: self.asleep,
        }
    }

    /// Its place \[m\] as that of a solid in a scene, and the direction of its angle.
    pub fn place(&self) -> (Vec2, Vec2) {
        let frame = &self.surface.frame;
        (frame.centre - frame.axis.rotate(self.middle), frame.axis)
    }

    /// Its mass [kg/m]; 0 if nothing is left of it.
    pub fn mass(&self) -> f32 {
        whole(self.inverse_mass)
    }

    /// Wakes it.
    pub fn wake(&mut self) {
        self.still = 0.0;
        self.asleep = false;
    }

    /// Limits its speed: gas follows no faster surface.
    pub fn limit_to(&mut self, speed: f32) {
        self.velocity = self.velocity.clamp_length_max(speed);
        let fastest = speed / fast_max(self.surface.frame.reach(), 1e-3);
        self.spin = fast_min(fast_max(self.spin, -fastest), fastest);
    }

    /// Puts it elsewhere.
    pub fn shift(&mut self, path: Vec2) {
        self.centre += path;
        self.surface.frame.centre += path;
    }

    /// Moves it.
    pub fn advance(&mut self, dt: f32, bounds: Option<&Bounds>) {
        let turn = self.spin * dt;
        let frame = &mut self.surface.frame;
        let axis = frame.axis.rotate(Vec2::new(1.0 - 0.5 * turn * turn, turn));
        frame.axis = axis / fast_max(axis.length(), 0.5);
        self.centre += self.velocity * dt;
        if let Some(bounds) = bounds {
            self.centre = bounds.wrap(self.centre);
        }
        if self.centre.abs().max_element() > MAX_DISTANCE {
            self.centre = self.centre.clamp_length_max(MAX_DISTANCE);
            (self.velocity, self.spin) = (Vec2::ZERO, 0.0);
        }
        frame.centre = self.centre - frame.axis.rotate(self.offset);
    }
}
