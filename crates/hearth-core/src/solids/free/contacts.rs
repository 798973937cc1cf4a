//! Contacts: where a disc of one surface is near another surface, or a plane.

use glam::Vec2;

use super::body::Rigid;
use super::contact::Contact;
use super::state::FreeBodies;
use crate::bounds::Bounds;
use crate::extremes::fast_max;

/// Distance at which a contact is found, beyond the path in a substep \[m\].
const CONTACT_MARGIN: f32 = 1e-3;
/// The most contacts, for each solid.
const CONTACTS_PER_BODY: usize = 48;
/// Bodies and samples have numbers below this in a key.
const KEY_BASE: usize = 256;
/// The number of the first plane, in place of that of a body.
pub(super) const PLANES: usize = 200;

impl FreeBodies {
    /// Makes room for the contacts.
    pub(super) fn make_room(&mut self) {
        let most = self.all.len() * CONTACTS_PER_BODY;
        self.contacts.reserve(most);
        self.old.reserve(most);
    }

    /// Finds the contacts of a substep. Those known before keep their impulses.
    pub(super) fn find_contacts(&mut self, dt: f32) {
        std::mem::swap(&mut self.contacts, &mut self.old);
        self.contacts.clear();
        let most = self.all.len() * CONTACTS_PER_BODY;
        let mut add = |contact| {
            if self.contacts.len() < most {
                self.contacts.push(contact);
            }
        };
        for (first, body) in self.all.iter().enumerate() {
            for (second, other) in self.all.iter().enumerate() {
                let lives = body.is_live() || other.is_live();
                let moves = body.is_free || other.is_free;
                if first == second || !lives || !moves || body.is_hinged_to(second) {
                    continue;
                }
                let shift = shift(self.bounds.as_ref(), body, other);
                let near = CONTACT_MARGIN + (body.speed() + other.speed()) * dt;
                let (a, b) = (&body.surface.frame, &other.surface.frame);
                let reach = a.reach() + b.reach() + near;
                if (a.centre - shift).distance_squared(b.centre) > reach * reach {
                    continue;
                }
                for (index, sample) in body.samples.all().iter().enumerate() {
                    let at = a.centre + a.axis.rotate(sample.at);
                    let (distance, normal) = other.surface.distance(at - shift);
                    let gap = distance - sample.radius;
                    if gap < near && !other.samples.all().is_empty() {
                        let point = at - normal * (sample.radius + 0.5 * gap);
                        add(Contact {
                            key: (first * KEY_BASE + second) * KEY_BASE + index,
                            first,
                            second,
                            normal,
                            arms: [point - body.centre, point - shift - other.centre],
                            gap,
                            ..Contact::default()
                        });
                    }
                }
            }
            if !body.is_awake() {
                continue;
            }
            let frame = &body.surface.frame;
            for (second, plane) in (PLANES..).zip(&self.planes) {
                let Some(plane) = plane else { continue };
                for (index, sample) in body.samples.all().iter().enumerate() {
                    let at = frame.centre + frame.axis.rotate(sample.at);
                    let gap = at.dot(plane.normal) - plane.offset - sample.radius;
                    if gap < CONTACT_MARGIN + body.speed() * dt {
                        let point = at - plane.normal * sample.radius;
                        add(Contact {
                            key: (first * KEY_BASE + second) * KEY_BASE + index,
                            first,
                            second,
                            normal: plane.normal,
                            arms: [point - body.centre, Vec2::ZERO],
                            gap,
                            ..Contact::default()
                        });
                    }
                }
            }
        }
        self.remember(dt);
    }

    /// Gives the contacts that were there before, and the hinges, their impulses: both lists have the
    /// order of the keys.
    fn remember(&mut self, dt: f32) {
        let scale = dt / fast_max(self.length, 1e-9);
        self.length = dt;
        for hinge in &mut self.hinges {
            hinge.continue_from(scale);
        }
        let mut old = self.old.iter().peekable();
        for contact in &mut self.contacts {
            while old.next_if(|old| old.key < contact.key).is_some() {}
            if let Some(old) = old.next_if(|old| old.key == contact.key)
                && old.normal.dot(contact.normal) > 0.9
            {
                (contact.impulse, contact.along) = (old.impulse * scale, old.along * scale);
            }
        }
    }
}

/// The path from the image of `first` that is nearest to `second` to itself, beyond periodic edges.
pub(super) fn shift(bounds: Option<&Bounds>, first: &Rigid, second: &Rigid) -> Vec2 {
    let Some(bounds) = bounds else {
        return Vec2::ZERO;
    };
    let path = first.surface.frame.centre - second.surface.frame.centre;
    let whole = |is_periodic: bool, path: f32, period: f32| match is_periodic {
        true => period * (path / period + 0.5).floor(),
        false => 0.0,
    };
    Vec2::new(
        whole(bounds.periodic_x, path.x, bounds.width),
        whole(bounds.periodic_y, path.y, bounds.height),
    )
}
