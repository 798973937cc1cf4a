//! Hinges: a place of a body stays at a place of the solid that it hangs from.
//!
//! A hinge lets go where either has burnt through. Where a solid breaks, a hinge stays with the part
//! that has its place.

use glam::Vec2;

use super::body::Rigid;
use super::contacts::shift;
use super::hinge::Hinge;
use super::solve::{Soft, apply, inverse_masses, relative};
use super::state::FreeBodies;
use crate::bounds::Bounds;
use crate::extremes::fast_max;

/// Distance of the two places at which a hinge of a saved fire has let go \[m\].
const BROKEN_DISTANCE: f32 = 0.02;
/// The greatest velocity at which a hinge pulls its two places together [m/s].
const MAX_RECOVERY_SPEED: f32 = 1.0;

impl Hinge {
    /// Finds its arms and how far its places are apart, `ahead` of the end of the step \[s\].
    fn measure(&mut self, all: &[Rigid], bounds: Option<&Bounds>, ahead: f32) {
        let Some(pair) = &mut self.pair else { return };
        let mut places = [Vec2::ZERO; 2];
        for number in 0..2 {
            let body = &all[pair.bodies[number]];
            let (place, axis) = body.place();
            let at = place + axis.rotate(self.ends[number].at);
            let arm = at - body.centre;
            // One that no force moves is where it is at the end of the step.
            let path = match body.is_free {
                true => Vec2::ZERO,
                false => (body.velocity + arm.perp() * body.spin) * ahead,
            };
            (places[number], pair.arms[number]) = (at - path, arm);
        }
        let [place, far] = places;
        self.error = place - far;
        let [first, second] = pair.bodies.map(|index| &all[index]);
        self.error -= shift(bounds, first, second);
        self.is_live = first.is_live() || second.is_live();
    }

    /// Changes its impulse, and the velocities by it.
    fn solve(&mut self, all: &mut [Rigid], soft: Option<Soft>) {
        let Some(pair) = self.pair.filter(|_| self.is_live) else {
            return;
        };
        let (bias, mass, share) = match soft {
            Some(soft) => {
                let bias = (self.error * soft.rate).clamp_length_max(MAX_RECOVERY_SPEED);
                (bias, soft.mass, soft.impulse)
            }
            None => (Vec2::ZERO, 1.0, 0.0),
        };
        let Vec2 { x, y } = relative(all, &pair) + bias;
        let [xx, yy, xy] = self.inverse;
        let moved = Vec2::new(yy * x - xy * y, xx * y - xy * x);
        let moved = moved / fast_max(xx * yy - xy * xy, 1e-24);
        let change = -moved * mass - self.impulse * share;
        self.impulse += change;
        apply(all, &pair, change);
    }
}

impl FreeBodies {
    /// Hangs the bodies that hang from others. A hinge that is there stays as it is.
    pub(super) fn hang(&mut self, bodies: &[Rigid]) {
        let before = std::mem::take(&mut self.hinges);
        let hanging = self
            .all
            .iter()
            .filter(|body| body.is_free && !body.is_part());
        for body in hanging.filter(|body| body.hangs_from != body.id) {
            let mut supports = self.all.iter();
            let Some(support) = supports.find(|support| support.id == body.hangs_from) else {
                continue;
            };
            let same = |old: &Rigid| old.id == body.id && old.first == body.first;
            let ends = [body.id, support.id];
            let mut known = before.iter();
            let known = known.find(|known| known.ends.map(|end| end.object) == ends);
            let known = known.filter(|_| bodies.iter().any(same)).cloned();
            let hinge = known.unwrap_or_else(|| Hinge::of(body, support));
            self.hinges.push(hinge);
        }
    }

    /// Finds the bodies of the hinges. Two that a hinge joins do not collide.
    pub(super) fn find_hinged(&mut self) {
        for body in &mut self.all {
            body.hinged = 0;
        }
        for hinge in &mut self.hinges {
            let before = hinge.bodies();
            hinge.find(&self.all);
            if hinge.pair.is_none() {
                for index in before.into_iter().flatten() {
                    // The index may be that of a body before the scene changed.
                    if let Some(body) = self.all.get_mut(index) {
                        body.wake();
                    }
                }
            }
            if let Some([first, second]) = hinge.bodies() {
                self.all[first].hinged |= bit(second);
                self.all[second].hinged |= bit(first);
            }
        }
    }

    /// Finds their arms, and applies the impulses of the substep before.
    pub(super) fn prepare_hinges(&mut self) {
        for hinge in &mut self.hinges {
            hinge.measure(&self.all, self.bounds.as_ref(), self.ahead);
            if let Some(pair) = hinge.pair.filter(|_| hinge.is_live) {
                if pair.bodies.iter().any(|&index| self.all[index].is_torn) {
                    hinge.impulse = Vec2::ZERO;
                }
                hinge.inverse = inverse_masses(&self.all, &pair);
                apply(&mut self.all, &pair, hinge.impulse);
            }
        }
    }

    /// Changes the impulses of a round. Each second round goes through a chain from its other end.
    pub(super) fn solve_hinges(&mut self, round: u32, soft: Option<Soft>) {
        let all = &mut self.all;
        if round.is_multiple_of(2) {
            for hinge in &mut self.hinges {
                hinge.solve(all, soft);
            }
        } else {
            for hinge in self.hinges.iter_mut().rev() {
                hinge.solve(all, soft);
            }
        }
    }

    /// Lets the hinges go whose solids have burnt through there, and moves the others to the parts that
    /// have their places. `part_at` finds the part of a solid at a place in its frame, from the middle
    /// of it at first; `None` where nothing is left.
    pub fn burn_hinges(&mut self, part_at: &dyn Fn(u32, Vec2) -> Option<u32>) {
        for hinge in self.hinges.iter_mut().filter(|hinge| !hinge.is_broken) {
            for end in &mut hinge.ends {
                let mut all = self.all.iter();
                let whole = all.find(|body| body.id == end.object);
                let middle = whole.map_or(Vec2::ZERO, |body| body.middle);
                match part_at(end.object, end.at - middle) {
                    Some(part) => end.part = part,
                    None => hinge.is_broken = true,
                }
            }
        }
    }

    /// Lets the hinges go that a saved fire does not have any more: their places are apart.
    pub(super) fn let_go_apart(&mut self) {
        self.find_hinged();
        for hinge in &mut self.hinges {
            hinge.measure(&self.all, self.bounds.as_ref(), 0.0);
            hinge.is_broken |= hinge.pair.is_some() && hinge.error.length() > BROKEN_DISTANCE;
        }
    }
}

impl Rigid {
    /// Whether a hinge joins it and another.
    pub fn is_hinged_to(&self, other: usize) -> bool {
        self.hinged & bit(other) != 0
    }
}

/// The bit of a body; there are no more than there may be solids.
fn bit(index: usize) -> u64 {
    1 << (index % 64)
}
