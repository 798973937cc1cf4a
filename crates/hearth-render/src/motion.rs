//! What of a picture the next one goes on from.

use crate::advection::Advection;
use crate::resolution::Layout;
use crate::rise::Rise;
use crate::scale::Scale;

/// How far the fine structure has come, and the scale of what is measured. It outlives a
/// renderer, whose context may be lost: the next renderer goes on from there.
#[derive(Clone, Copy, Debug, Default)]
pub struct Motion {
    pub(crate) rise: Rise,
    pub(crate) advection: Advection,
    pub(crate) scale: Scale,
}

/// How far the gas had carried the noise in a picture that stood still: a lost context forgets
/// it, and gas that stands still does not carry it there again.
pub struct CarriedNoise {
    pub(crate) layout: Layout,
    pub(crate) texels: Vec<f32>,
}
