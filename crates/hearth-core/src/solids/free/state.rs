//! The state of the free bodies.

use super::body::Rigid;
use super::contact::{Contact, Plane};
use super::hinge::Hinge;
use crate::bounds::Bounds;

/// The free solids of a scene and the solids that they may touch.
#[derive(Clone, Debug, Default)]
pub(crate) struct FreeBodies {
    /// All solids, in the order of the scene.
    pub(super) all: Vec<Rigid>,
    /// The present contacts, and those before, in the order of their keys.
    pub(super) contacts: Vec<Contact>,
    pub(super) old: Vec<Contact>,
    pub(super) hinges: Vec<Hinge>,
    pub(super) planes: [Option<Plane>; 3],
    pub(super) bounds: Option<Bounds>,
    /// Gravity [m/s²].
    pub(super) gravity: f32,
    /// Length of the substep before, and time from the present one to the end of the step \[s\].
    pub(super) length: f32,
    pub(super) ahead: f32,
    /// Time of the bodies \[s\].
    pub(super) time: f64,
    /// How many parts have broken off.
    pub(super) parts: u32,
}

crate::state! { FreeBodies: all contacts old hinges planes bounds gravity length ahead time parts }
