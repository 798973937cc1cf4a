//! Solids that have fuel, for a picture.

use std::sync::Arc;

use crate::instance::Instance;
use crate::scene::{Field, RoundedBox};

/// The solids that have fuel, for a picture.
#[derive(Clone, Debug, Default)]
pub struct Charred {
    /// For each of them a head and its cells: its id, the columns and rows of its cells, half of the
    /// size of their grid, and the box that its material is drawn on; then, eight in a record, for
    /// each cell its temperature \[K\], a whole number, and the share of it that is char.
    pub records: Vec<Instance>,
    /// The solids, then the parts that have broken off them.
    pub solids: Vec<CharredSolid>,
}

impl Charred {
    /// Removes all of them.
    pub(crate) fn clear(&mut self) {
        self.records.clear();
        self.solids.clear();
    }
}

/// A solid that has fuel or a part of one, for a picture.
#[derive(Clone, Debug)]
pub struct CharredSolid {
    /// The id of the object that it is, or that it was a part of.
    pub id: u32,
    /// The place of its head in the records.
    pub place: usize,
    /// The distance to what is left if something is lost.
    pub left: Option<Arc<Field>>,
    /// Where a part is. A solid is where its object is.
    pub part: Option<RoundedBox>,
}
