//! What a part of the wasm makes, and frees.

use std::mem::ManuallyDrop;
use std::ops::{Deref, DerefMut};

/// A value of a part of the wasm.
pub(crate) trait OfPart: Sized {
    /// Frees the value. Its code is in the part if it is not inlined.
    fn free(value: &mut Option<Box<Self>>);
}

/// A value of a part of the wasm, if the fire has one. Without one no code of the part runs.
#[derive(Clone, Debug)]
pub(crate) struct Held<T: OfPart>(ManuallyDrop<Option<Box<T>>>);

impl<T: OfPart> Default for Held<T> {
    #[inline(always)]
    fn default() -> Held<T> {
        Held(ManuallyDrop::new(None))
    }
}

impl<T: OfPart> Deref for Held<T> {
    type Target = Option<Box<T>>;

    #[inline(always)]
    fn deref(&self) -> &Option<Box<T>> {
        &self.0
    }
}

impl<T: OfPart> DerefMut for Held<T> {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut Option<Box<T>> {
        &mut self.0
    }
}

impl<T: OfPart> Drop for Held<T> {
    #[inline(always)]
    fn drop(&mut self) {
        if self.is_some() {
            T::free(&mut self.0);
        }
    }
}
