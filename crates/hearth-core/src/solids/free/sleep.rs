//! Sleep: bodies that touch each other and are still stay where they are, until something moves them.

use glam::Vec2;

use super::body::Rigid;
use super::contacts::PLANES;
use super::state::FreeBodies;
use crate::extremes::fast_min;

/// Speed below which a body is still [m/s].
const SLEEP_SPEED: f32 = 0.01;
/// For how long it is still before it sleeps \[s\].
pub(super) const TIME_TO_SLEEP: f32 = 0.5;
/// Push of the gas that keeps a body awake, and that wakes it, as a share of its weight.
const AWAKE_PUSH: f32 = 0.1;
const WAKING_PUSH: f32 = 0.2;

impl FreeBodies {
    /// Lets bodies fall asleep and wake.
    pub(super) fn update_sleep(&mut self, dt: f32) {
        for (number, body) in self.all.iter_mut().enumerate() {
            body.root = number;
            body.touches &= body.asleep;
        }
        for index in 0..self.contacts.len() {
            let contact = &self.contacts[index];
            if contact.most > 0.0 {
                self.touch(contact.first, contact.second);
            }
        }
        for index in 0..self.hinges.len() {
            if let Some([first, second]) = self.hinges[index].bodies() {
                self.touch(first, second);
            }
        }
        for body in self.all.iter_mut().filter(|body| body.is_free) {
            let limit = if body.asleep { WAKING_PUSH } else { AWAKE_PUSH };
            if body.speed() > SLEEP_SPEED || body.pushed > limit || !body.touches {
                body.still = 0.0;
            } else {
                body.still += dt;
            }
        }
        // The least of those that touch each other, at the first of them.
        for index in 0..self.all.len() {
            let body = &self.all[index];
            let still = if body.is_free { body.still } else { f32::MAX };
            let first = self.root_of(index);
            let first = &mut self.all[first];
            first.still = fast_min(first.still, still);
        }
        for index in 0..self.all.len() {
            let sleeps = self.all[self.root_of(index)].still >= TIME_TO_SLEEP;
            let body = &mut self.all[index];
            if body.is_free {
                body.asleep = sleeps;
                if sleeps {
                    (body.velocity, body.spin) = (Vec2::ZERO, 0.0);
                } else {
                    body.still = fast_min(body.still, TIME_TO_SLEEP);
                }
            }
        }
    }

    /// Notes that a body touches another, hangs from it, or touches a plane.
    fn touch(&mut self, first: usize, second: usize) {
        let is_plane = second >= PLANES;
        if !is_plane && self.all[first].is_free && self.all[second].is_free {
            let (first, second) = (self.root_of(first), self.root_of(second));
            self.all[first.max(second)].root = first.min(second);
        }
        let moves = |body: &Rigid| !body.is_free && body.is_live();
        let is_moved = moves(&self.all[first]) || !is_plane && moves(&self.all[second]);
        let bodies = [Some(first), (!is_plane).then_some(second)];
        for index in bodies.into_iter().flatten() {
            let body = &mut self.all[index];
            body.touches = true;
            if is_moved {
                body.still = 0.0;
            }
        }
    }

    /// The first body of those that touch each other.
    fn root_of(&self, mut index: usize) -> usize {
        while self.all[index].root != index {
            index = self.all[index].root;
        }
        index
    }
}
