//! Solids that forces move: rigid bodies with gravity, contacts and the push of the gas.
//!
//! A step divides its time into [substeps](FreeBodies::substep). Each finds the
//! [contacts](contacts) from points of one surface in the distance of another, and
//! [solves](solve) them and the [hinges](hinges) by sequential impulses with a soft bias (Macklin et
//! al. 2019; Catto 2024).
//! A contact acts before its surfaces meet, so a fast body stops at a thin one. The gas pushes a
//! body by the force that the body has on the gas (Akinci et al. 2012). The code is a part of the
//! wasm that a page loads for a scene with such a solid: nothing outside of it calls a function of it
//! without one, or inlines it.

mod body;
mod contact;
mod contacts;
mod hinge;
mod hinges;
mod parts;
mod resume;
mod samples;
mod sleep;
mod solve;
mod state;

use glam::Vec2;

use super::{Body, Solids};
use crate::bounds::Bounds;
use crate::extremes::{fast_max, fast_min};
use crate::params::{Edges, Floor, Model, Physics, Walls};
use crate::scene::{MAX_SPEED, Pose, Scene};
use body::MAX_HINGED_SPEED;
use contact::Plane;

pub use body::FreeSolid;
pub(crate) use body::Moments;
pub(crate) use parts::Piece;
pub(crate) use state::FreeBodies;

/// Longest substep \[s\].
const MAX_SUBSTEP: f32 = 1e-3;
/// How much faster a body is that hinges tear in several directions: their impulses are then reset.
const TORN_SPEED_RATIO: f32 = 4.0;
/// Longest step that the bodies follow \[s\].
const MAX_STEP: f32 = 0.05;

impl Body {
    /// Adds the force of a particle of gas at a position, whose mass \[kg/m\] it gave the opposite of this
    /// acceleration [m/s²].
    pub fn push(&mut self, from: Vec2, mass: f32, acceleration: Vec2) {
        let force = acceleration * mass;
        self.force += force;
        self.torque += (from - self.surface.frame.centre).perp_dot(force);
    }
}

impl FreeBodies {
    /// The free solids of a scene, and the others that they may touch. Those that the scene has not moved
    /// stay where they are.
    // An entry of the part `bodies` of the wasm.
    #[inline(never)]
    pub fn set(solids: &mut Solids, scene: &Scene, time: f64, bounds: &Bounds) {
        let values = scene.world();
        let mut free = solids.free.take().unwrap_or_default();
        let before = std::mem::take(&mut free.all);
        let ids = before.iter().filter(|body| !body.is_part());
        let ids = ids.map(|body| body.id);
        if !ids.eq(scene.obstacles().map(|(id, ..)| id)) {
            free.contacts.clear();
            free.old.clear();
        }
        for (id, solid, surface) in scene.obstacles() {
            let mut body = body::Rigid::of(id, solid, surface, values);
            if let Some(known) = before.iter().find(|body| body.id == id) {
                body.continue_from(known);
            }
            free.all.push(body);
        }
        free.keep_parts(solids, &before);
        free.hang(&before);
        free.gravity = values.gravity;
        free.bounds = Some(*bounds);
        free.planes = planes(values);
        free.time = time;
        free.make_room();
        free.follow(solids);
        free.place(solids);
        for body in solids.bodies.iter_mut().filter(|body| body.is_free) {
            // The new place in the scene is no motion.
            (body.velocity, body.spin) = (Vec2::ZERO, 0.0);
        }
        solids.free = free.all.iter().any(|body| body.is_free).then_some(free);
    }

    /// Moves the free bodies to a time \[s\].
    // An entry of the part `bodies` of the wasm.
    #[inline(never)]
    pub fn advance(solids: &mut Solids, time: f64) {
        let Some(mut free) = solids.free.take() else {
            return;
        };
        let dt = fast_min((time - free.time) as f32, MAX_STEP);
        free.time = time;
        if dt > 0.0 {
            free.follow(solids);
            free.find_hinged();
            let count = (dt / MAX_SUBSTEP).ceil();
            for number in 0..count as u32 {
                free.ahead = dt - dt / count * number as f32;
                free.substep(dt / count);
            }
            free.update_sleep(dt);
            free.place(solids);
        }
        solids.free = Some(free);
    }

    /// Accelerates the bodies by the forces of the gas in a step.
    // An entry of the part `bodies` of the wasm.
    #[inline(never)]
    pub fn apply_gas_forces(solids: &mut Solids, dt: f32) {
        let Some(free) = &mut solids.free else {
            return;
        };
        let gravity = fast_max(free.gravity, 1e-3);
        for body in solids.bodies.iter_mut().filter(|body| body.is_free) {
            let (force, torque) = (body.force, body.torque);
            (body.force, body.torque) = (Vec2::ZERO, 0.0);
            let mut rigid = free.all.iter_mut();
            if let Some(rigid) = rigid.find(|rigid| rigid.id == body.id) {
                rigid.apply_gas_force(force, torque, gravity, dt);
            }
        }
    }

    /// Sets what a solid that burns weighs: a share of its mass, and where that is.
    pub fn weigh(&mut self, id: u32, left: &Moments) {
        if let Some(body) = self.all.iter_mut().find(|body| body.id == id) {
            body.weigh(left);
        }
    }

    /// Moves poses of free solids to where the bodies are.
    pub fn move_poses(&self, poses: &mut [Pose]) {
        for body in self.all.iter().filter(|body| body.is_free) {
            let frame = &body.surface.frame;
            for pose in poses.iter_mut().filter(|pose| pose.id == body.id) {
                (pose.frame.centre, pose.frame.axis) = (frame.centre, frame.axis);
            }
        }
    }

    /// The free solids, in the order of the objects, then what has broken off them.
    // An entry of the part `bodies` of the wasm.
    #[inline(never)]
    pub fn seen(&self) -> Vec<FreeSolid> {
        let free = self.all.iter().filter(|body| body.is_free);
        free.map(body::Rigid::seen).collect()
    }

    /// [Numbers](crate::Simulation::free_solid_numbers) of the free solids.
    // An entry of the part `bodies` of the wasm.
    #[inline(never)]
    pub fn numbers(&self) -> Vec<f32> {
        let mut numbers = Vec::new();
        for body in self.all.iter().filter(|body| body.is_free) {
            let (place, axis) = body.place();
            numbers.extend([body.id as f32, place.x, place.y, axis.x, axis.y]);
            numbers.extend([body.velocity.x, body.velocity.y, body.spin, body.mass()]);
            numbers.extend([f32::from(u8::from(body.asleep)), body.object as f32]);
        }
        numbers
    }

    /// Takes over the surfaces that have changed, and where the solids are that no force moves.
    fn follow(&mut self, solids: &Solids) {
        for rigid in &mut self.all {
            if let Some(body) = solids.first(rigid.id) {
                rigid.follow(body);
            }
        }
    }

    /// Moves the solids and their images to where the bodies are.
    fn place(&self, solids: &mut Solids) {
        for body in solids.bodies.iter_mut().filter(|body| body.is_free) {
            if let Some(rigid) = self.all.iter().find(|rigid| rigid.id == body.id) {
                let frame = &rigid.surface.frame;
                body.surface.frame.centre = frame.centre + body.image;
                body.surface.frame.axis = frame.axis;
                let arm = frame.centre - rigid.centre;
                body.driven = (rigid.velocity + arm.perp() * rigid.spin, rigid.spin);
            }
        }
    }

    fn substep(&mut self, dt: f32) {
        for body in self.all.iter_mut().filter(|body| body.is_awake()) {
            body.velocity.y -= self.gravity * body.weight * dt;
            body.limit_to(MAX_SPEED);
        }
        self.find_contacts(dt);
        self.solve(dt);
        for body in self.all.iter_mut().filter(|body| body.is_free) {
            if body.hinged != 0 {
                body.is_torn = body.speed() > TORN_SPEED_RATIO * MAX_SPEED;
                body.limit_to(MAX_HINGED_SPEED);
            }
            body.advance(dt, self.bounds.as_ref());
        }
        self.lift(dt);
        self.relax(dt);
    }
}

/// The floor, and the walls of the classic model.
fn planes(values: &Physics) -> [Option<Plane>; 3] {
    let plane = |normal: Vec2, offset: f32| Some(Plane { normal, offset });
    let floor = plane(Vec2::Y, 0.0);
    let side = -0.5 * values.domain_width;
    match (values.model, values.walls) {
        (Model::Classic, Walls::Open) => [None; 3],
        (Model::Classic, Walls::Periodic) => [floor, None, None],
        (Model::Classic, Walls::Solid) => [floor, plane(Vec2::X, side), plane(-Vec2::X, side)],
        (Model::Combustion, _) => {
            let stands = values.edges == Edges::Open && values.floor == Floor::Solid;
            [floor.filter(|_| stands), None, None]
        }
    }
}
