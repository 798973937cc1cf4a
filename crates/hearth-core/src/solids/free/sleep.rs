//! Sleep: bodies that touch each other and are still stay where they are, until something moves them.

use glam::Vec2;

use super::hinge::Hinge;
use super::state::FreeBodies;
use crate::extremes::fast_min;

/// Speed below which a body is still [m/s].
const STILL: f32 = 0.01;
/// For how long it is still before it sleeps \[s\].
pub(super) const DROWSY: f32 = 0.5;
/// Push of the gas that keeps a body awake, and that wakes it, as a share of its weight.
const KEEPS: f32 = 0.1;
const WAKES: f32 = 0.2;

impl FreeBodies {
    /// Lets bodies fall asleep and wake.
    pub(super) fn rest(&mut self, dt: f32) {
        for (number, one) in self.all.iter_mut().enumerate() {
            one.root = number;
            one.touches &= one.asleep;
        }
        for index in 0..self.contacts.len() {
            if let Some(contact) = self.contacts.get(index).filter(|one| one.most > 0.0) {
                self.touch(contact.one, contact.other);
            }
        }
        for index in 0..self.hinges.len() {
            if let Some([one, other]) = self.hinges.get(index).and_then(Hinge::bodies) {
                self.touch(one, other);
            }
        }
        for one in self.all.iter_mut().filter(|one| one.is_free) {
            let limit = if one.asleep { WAKES } else { KEEPS };
            if one.speed() > STILL || one.pushed > limit || !one.touches {
                one.still = 0.0;
            } else {
                one.still += dt;
            }
        }
        // The least of those that touch each other, at the first of them.
        for index in 0..self.all.len() {
            let root = self.root_of(index);
            let still = self.all.get(index).filter(|one| one.is_free);
            let still = still.map_or(f32::MAX, |one| one.still);
            if let Some(first) = self.all.get_mut(root) {
                first.still = fast_min(first.still, still);
            }
        }
        for index in 0..self.all.len() {
            let root = self.root_of(index);
            let sleeps = self.all.get(root).is_some_and(|one| one.still >= DROWSY);
            if let Some(one) = self.all.get_mut(index).filter(|one| one.is_free) {
                one.asleep = sleeps;
                if sleeps {
                    (one.velocity, one.spin) = (Vec2::ZERO, 0.0);
                } else {
                    one.still = fast_min(one.still, DROWSY);
                }
            }
        }
    }

    /// Notes that a body touches another, hangs from it, or touches a plane.
    fn touch(&mut self, one: usize, other: usize) {
        let is_free = |index: usize| self.all.get(index).is_some_and(|one| one.is_free);
        if is_free(one) && is_free(other) {
            let (one, other) = (self.root_of(one), self.root_of(other));
            if let Some(body) = self.all.get_mut(one.max(other)) {
                body.root = one.min(other);
            }
        }
        let moves = |index: usize| {
            let body = self.all.get(index);
            body.is_some_and(|body| !body.is_free && body.is_live())
        };
        let is_moved = moves(one) || moves(other);
        for index in [one, other] {
            if let Some(body) = self.all.get_mut(index) {
                body.touches = true;
                if is_moved {
                    body.still = 0.0;
                }
            }
        }
    }

    /// The first body of those that touch each other.
    fn root_of(&self, index: usize) -> usize {
        let mut at = index;
        for _ in 0..self.all.len() {
            match self.all.get(at) {
                Some(one) if one.root != at => at = one.root,
                _ => break,
            }
        }
        at
    }
}
