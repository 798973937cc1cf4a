//! The state that a picture continues from the previous one.

use crate::advection::Advection;
use crate::resolution::Layout;
use crate::rise::Rise;
use crate::scale::Scale;

/// State of the fine structure and of the colour scale. After the loss of a context, the next
/// renderer continues it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Motion {
    pub(crate) rise: Rise,
    pub(crate) advection: Advection,
    pub(crate) scale: Scale,
}

/// The offsets of the advected noise of a paused fire, which a lost context does not keep and a
/// paused fire cannot compute again.
pub struct CarriedNoise {
    pub(crate) layout: Layout,
    pub(crate) texels: Vec<f32>,
}
