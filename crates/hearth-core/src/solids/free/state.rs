//! The state of the free bodies.

use std::mem::ManuallyDrop;
use std::ops::{Deref, DerefMut};

use super::body::Rigid;
use super::contact::{Contact, Plane};
use crate::bounds::Bounds;

/// The free solids of a scene and the solids that they meet.
#[derive(Clone, Debug, Default)]
pub(crate) struct FreeBodies {
    /// All solids, in the order of the scene.
    pub(super) all: Vec<Rigid>,
    /// The present contacts, and those before, in the order of their keys.
    pub(super) contacts: Vec<Contact>,
    pub(super) old: Vec<Contact>,
    pub(super) planes: [Option<Plane>; 3],
    pub(super) bounds: Option<Bounds>,
    /// Gravity [m/s²].
    pub(super) gravity: f32,
    /// Length of the substep before \[s\].
    pub(super) length: f32,
    /// Time of the bodies \[s\].
    pub(super) time: f64,
}

/// The free bodies of a scene, if there is any. The code that frees them is where the rest of theirs
/// is.
#[derive(Clone, Debug, Default)]
pub(crate) struct Held(ManuallyDrop<Option<Box<FreeBodies>>>);

impl Deref for Held {
    type Target = Option<Box<FreeBodies>>;

    #[inline(always)]
    fn deref(&self) -> &Option<Box<FreeBodies>> {
        &self.0
    }
}

impl DerefMut for Held {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut Option<Box<FreeBodies>> {
        &mut self.0
    }
}

impl Drop for Held {
    #[inline(always)]
    fn drop(&mut self) {
        if self.is_some() {
            free(self);
        }
    }
}

#[inline(never)]
fn free(held: &mut Held) {
    drop(ManuallyDrop::into_inner(std::mem::take(&mut held.0)));
}
