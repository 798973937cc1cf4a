//! What a contact is between: a body, and another or a plane.

use glam::Vec2;

/// A half space that is solid below it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane {
    pub normal: Vec2,
    pub offset: f32,
}

/// A contact of the body `first` with the body or plane `second`.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Contact {
    /// The bodies and the sample.
    pub key: usize,
    pub first: usize,
    pub second: usize,
    /// From the second to the first.
    pub normal: Vec2,
    /// From the centres of mass to the contact \[m\].
    pub arms: [Vec2; 2],
    /// Distance of the surfaces \[m\].
    pub gap: f32,
    /// Impulses along the normal and along the surface [N·s/m], and the largest one along the normal.
    pub impulse: f32,
    pub along: f32,
    pub most: f32,
    /// Masses that the impulses move [kg/m].
    pub normal_mass: f32,
    pub along_mass: f32,
    pub friction: f32,
    pub restitution: f32,
    /// Velocity along the normal before the impulses [m/s].
    pub approach: f32,
}

/// Two bodies, or a body and a plane, that an impulse acts on.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Pair {
    pub bodies: [usize; 2],
    /// From the centres of mass to where it acts \[m\].
    pub arms: [Vec2; 2],
}

crate::state! {
    Plane: normal offset,
    Contact: key first second normal arms gap impulse along most normal_mass along_mass friction restitution
        approach,
    Pair: bodies arms
}

impl Contact {
    /// The bodies, and where the impulse acts.
    pub fn pair(&self) -> Pair {
        Pair {
            bodies: [self.first, self.second],
            arms: self.arms,
        }
    }
}
