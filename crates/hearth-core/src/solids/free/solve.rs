//! Sequential impulses: each contact in turn gets the impulse that stops its approach and, up to
//! the friction, its sliding. [Hinges](super::hinges) get theirs before.
//!
//! A soft bias removes an overlap over several substeps; impulses without the bias follow the
//! motion, so that it adds no energy (the soft step of Catto 2024).

use std::f32::consts::PI;

use glam::Vec2;

use super::body::{MAX_HINGED_SPEED, Rigid};
use super::contact::{Contact, Pair};
use super::contacts::PLANES;
use super::state::FreeBodies;
use crate::extremes::{fast_max, fast_min};

/// Rounds with a bias, and rounds without it.
const ROUNDS: u32 = 8;
const RELAXATIONS: u32 = 4;
/// Damping ratio of the bias, and its frequency, in substeps.
const DAMPING_RATIO: f32 = 10.0;
const FREQUENCY: f32 = 0.25;
/// Overlap that stays \[m\], and the greatest velocity at which an overlap ends [m/s].
const SLOP: f32 = 2e-5;
const MAX_RECOVERY_SPEED: f32 = 1.0;
/// How deep a body may be in a plane \[m\].
const MAX_OVERLAP: f32 = 0.02;
/// Slowest impact that bounces [m/s].
const MIN_BOUNCE_SPEED: f32 = 0.2;

/// How soft a contact or a hinge is.
#[derive(Clone, Copy)]
pub(super) struct Soft {
    pub rate: f32,
    pub mass: f32,
    pub impulse: f32,
}

/// The velocity, the inverse mass and the inverse inertia of a body; a plane has none.
fn motion(all: &[Rigid], index: usize) -> (Vec2, f32, f32, f32) {
    match all.get(index) {
        Some(body) => (
            body.velocity,
            body.spin,
            body.inverse_mass,
            body.inverse_inertia,
        ),
        None => {
            assert!(index >= PLANES, "there is no body {index}");
            (Vec2::ZERO, 0.0, 0.0, 0.0)
        }
    }
}

/// The velocity of the first relative to the second where an impulse acts.
pub(super) fn relative(all: &[Rigid], pair: &Pair) -> Vec2 {
    let [first, second] = pair.bodies.map(|index| motion(all, index));
    let [arm, far] = pair.arms;
    first.0 + arm.perp() * first.1 - second.0 - far.perp() * second.1
}

/// Applies an impulse to the first body, and its opposite to the second.
pub(super) fn apply(all: &mut [Rigid], pair: &Pair, impulse: Vec2) {
    let signs = [1.0, -1.0];
    for ((index, sign), arm) in pair.bodies.into_iter().zip(signs).zip(pair.arms) {
        if let Some(body) = all.get_mut(index) {
            body.velocity += impulse * (sign * body.inverse_mass);
            body.spin += arm.perp_dot(impulse) * (sign * body.inverse_inertia);
        } else {
            assert!(index >= PLANES, "there is no body {index}");
        }
    }
}

/// The mass that an impulse in a direction moves [kg/m].
fn mass_at(all: &[Rigid], pair: &Pair, direction: Vec2) -> f32 {
    let mut inverse = 0.0;
    for (index, arm) in pair.bodies.into_iter().zip(pair.arms) {
        let (_, _, mass, inertia) = motion(all, index);
        let lever = arm.perp_dot(direction);
        inverse += mass + lever * lever * inertia;
    }
    1.0 / fast_max(inverse, 1e-12)
}

/// What an impulse changes, as a symmetric matrix: xx, yy and xy [m/kg].
pub(super) fn inverse_masses(all: &[Rigid], pair: &Pair) -> [f32; 3] {
    let [mut xx, mut yy, mut xy] = [0.0; 3];
    for (index, arm) in pair.bodies.into_iter().zip(pair.arms) {
        let (_, _, mass, inertia) = motion(all, index);
        xx += mass + inertia * arm.y * arm.y;
        yy += mass + inertia * arm.x * arm.x;
        xy -= inertia * arm.x * arm.y;
    }
    [xx, yy, xy]
}

impl FreeBodies {
    /// Finds the impulses of a substep, with the bias.
    pub(super) fn solve(&mut self, dt: f32) {
        self.prepare_hinges();
        for contact in &mut self.contacts {
            contact.prepare(&self.all);
        }
        for contact in &self.contacts {
            let impulse = contact.normal * contact.impulse + contact.normal.perp() * contact.along;
            apply(&mut self.all, &contact.pair(), impulse);
        }
        let frequency = 2.0 * PI * FREQUENCY;
        let damped = 2.0 * DAMPING_RATIO + frequency;
        let scale = 1.0 / (1.0 + frequency * damped);
        let soft = Soft {
            rate: frequency / (damped * dt),
            mass: frequency * damped * scale,
            impulse: scale,
        };
        for round in 0..ROUNDS {
            self.solve_hinges(round, Some(soft));
            for contact in &mut self.contacts {
                contact.solve(&mut self.all, dt, Some(soft));
            }
        }
        for contact in &mut self.contacts {
            contact.gap += relative(&self.all, &contact.pair()).dot(contact.normal) * dt;
        }
    }

    /// Puts bodies back that others have pressed deep into a plane: no rounds of impulses hold a light
    /// body under others a thousand times as dense. Gas yields to no faster motion.
    pub(super) fn lift(&mut self, dt: f32) {
        let same = |a: &Contact, b: &Contact| (a.first, a.second) == (b.first, b.second);
        for contacts in self.contacts.chunk_by(same) {
            let [contact, ..] = contacts else { continue };
            let gaps = contacts.iter().map(|contact| contact.gap);
            let beyond = -MAX_OVERLAP - gaps.fold(0.0, fast_min);
            if beyond > 0.0 && contact.is_at_plane() {
                let body = &mut self.all[contact.first];
                body.shift(contact.normal * fast_min(beyond, MAX_HINGED_SPEED * dt));
            }
        }
    }

    /// Takes the velocity of the bias away, and lets impacts bounce.
    pub(super) fn relax(&mut self, dt: f32) {
        for round in 0..RELAXATIONS {
            self.solve_hinges(round, None);
            for contact in &mut self.contacts {
                contact.solve(&mut self.all, dt, None);
            }
        }
        for contact in &mut self.contacts {
            if contact.approach > -MIN_BOUNCE_SPEED
                || contact.most <= 0.0
                || contact.restitution <= 0.0
            {
                continue;
            }
            let leaving = relative(&self.all, &contact.pair()).dot(contact.normal);
            let wanted = leaving + contact.restitution * contact.approach;
            let impulse = fast_max(contact.impulse - contact.normal_mass * wanted, 0.0);
            let change = impulse - contact.impulse;
            contact.impulse = impulse;
            apply(&mut self.all, &contact.pair(), contact.normal * change);
        }
    }
}

impl Contact {
    /// Finds its masses, its friction and its approach.
    fn prepare(&mut self, all: &[Rigid]) {
        let pair = self.pair();
        self.normal_mass = mass_at(all, &pair, self.normal);
        self.along_mass = mass_at(all, &pair, self.normal.perp());
        self.approach = relative(all, &pair).dot(self.normal);
        let free = |index: usize| {
            let body = (index < PLANES).then(|| &all[index]);
            let body = body.filter(|body| body.is_free);
            body.map(|body| (body.friction, body.restitution))
        };
        (self.friction, self.restitution) = match (free(self.first), free(self.second)) {
            (Some(first), Some(second)) => {
                ((first.0 * second.0).sqrt(), fast_max(first.1, second.1))
            }
            (Some(own), None) | (None, Some(own)) => own,
            (None, None) => (0.0, 0.0),
        };
    }

    /// Changes its impulses, and the velocities by them.
    fn solve(&mut self, all: &mut [Rigid], dt: f32, soft: Option<Soft>) {
        let pair = self.pair();
        let (bias, mass, share) = match soft {
            _ if self.gap > 0.0 => (self.gap / dt, 1.0, 0.0),
            Some(soft) => {
                let bias = soft.rate * fast_min(self.gap + SLOP, 0.0);
                (fast_max(bias, -MAX_RECOVERY_SPEED), soft.mass, soft.impulse)
            }
            None => (0.0, 1.0, 0.0),
        };
        let approach = relative(all, &pair).dot(self.normal) + bias;
        let wanted = self.impulse * (1.0 - share) - self.normal_mass * mass * approach;
        let impulse = fast_max(wanted, 0.0);
        let change = impulse - self.impulse;
        self.impulse = impulse;
        self.most = fast_max(self.most, impulse);
        apply(all, &pair, self.normal * change);
        let side = self.normal.perp();
        let sliding = relative(all, &pair).dot(side);
        let most = self.friction * self.impulse;
        let along = fast_min(
            fast_max(self.along - self.along_mass * sliding, -most),
            most,
        );
        let change = along - self.along;
        self.along = along;
        apply(all, &pair, side * change);
    }

    /// Whether its other side is a plane.
    pub(super) fn is_at_plane(&self) -> bool {
        self.second >= PLANES
    }
}
