//! Solids that have fuel, for a picture. A page has this code without that of [fuels](super::fuels).

use std::sync::Arc;

use crate::instance::Instance;
use crate::scene::Field;

/// The solids that have fuel, for a picture.
#[derive(Clone, Debug, Default)]
pub struct Charred {
    /// For each of them a head and its cells: its id, the columns and rows of its cells, half of the
    /// size of their grid, and the box that its material is drawn on; then, eight in a record, for
    /// each cell its temperature \[K\], a whole number, and the share of it that is char.
    pub records: Vec<Instance>,
    /// Their ids, the places of their heads, and the distance to what is left if something is lost.
    pub solids: Vec<(u32, usize, Option<Arc<Field>>)>,
}
