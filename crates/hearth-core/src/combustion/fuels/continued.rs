//! What goes on of a solid that burns when the scene or the spacing changes.

use std::sync::Arc;

use super::cells::Burning;
use crate::params::Solid;
use crate::scene::Surface;

impl Burning {
    /// Whether it is that solid with that fuel.
    pub fn is(&self, solid: &Solid, surface: &Surface, spacing: f32) -> bool {
        let frame = &self.shape.frame;
        let same_field = match (&self.shape.field, &surface.field) {
            (Some(first), Some(second)) => Arc::ptr_eq(first, second),
            (None, None) => true,
            _ => false,
        };
        same_field
            && (frame.half, frame.radius) == (surface.frame.half, surface.frame.radius)
            && (self.fuel, self.load, self.moisture) == (solid.fuel, solid.load, solid.moisture)
            && self.spacing == spacing
    }

    /// Takes over the state of the same solid in another grid. One that has broken keeps its grid.
    pub fn continue_from(&mut self, old: Burning) {
        if old.is_broken {
            *self = Burning {
                shape: self.shape.clone(),
                spacing: self.spacing,
                ..old
            };
            return;
        }
        for index in 0..self.cells.len() {
            let Some(then) = old.at(self.place(index)) else {
                continue;
            };
            let (cell, then) = (&mut self.cells[index], &old.cells[then]);
            if then.first > 0.0 && cell.first > 0.0 {
                let share = cell.first / then.first;
                cell.temperature = then.temperature;
                cell.fuel = then.fuel * share;
                cell.water = then.water * share;
                cell.char = then.char * share;
            }
        }
        self.account = old.account;
        self.left.clone_from(&old.left);
        self.stood = self.standing();
        self.find_surface();
    }

    /// Whether it is the same solid in a grid for another spacing.
    pub fn is_finer_or_coarser(&self, other: &Burning) -> bool {
        self.shape == other.shape
            && (self.fuel, self.load, self.moisture) == (other.fuel, other.load, other.moisture)
    }
}
