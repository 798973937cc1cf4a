//! The images of a solid beyond periodic edges.

use glam::Vec2;

use super::{Body, Solids};
use crate::bounds::Bounds;
use crate::extremes::{fast_max, fast_min};

/// Largest sine of the angle of a body that is upright.
const MAX_UPRIGHT_SINE: f32 = 1e-4;
/// Most images on each side of a body: those of one that is three domains long.
const MAX_IMAGES: f32 = 3.0;

impl Solids {
    /// Adds a body and its images within `near` of the domain.
    pub(super) fn place(&mut self, mut body: Body, bounds: &Bounds, near: f32) {
        let period = Vec2::new(bounds.width, bounds.height);
        let low = Vec2::new(-0.5 * bounds.width, bounds.bottom);
        let shape = &mut body.surface.frame;
        let side = shape.axis.abs() * shape.half.x;
        let flat = side + shape.axis.perp().abs() * shape.half.y;
        let reach = flat + shape.radius + near;
        let is_inside =
            |at: Vec2| at.cmpgt(low - reach).all() && at.cmplt(low + period + reach).all();
        let centre = shape.centre;
        if !is_inside(centre) {
            self.bodies.push(body);
            return;
        }
        let is_upright = shape.axis.abs().min_element() < MAX_UPRIGHT_SINE;
        let is_plate =
            is_upright && body.surface.field.is_none() && body.drive.is_none() && !body.is_free;
        let mut count = |periodic: bool, axis: usize| {
            if !periodic {
                return 0;
            }
            if is_plate && 2.0 * flat[axis] >= period[axis] {
                // Its images would overlap it. As one body it has no end.
                shape.centre[axis] = low[axis] + 0.5 * period[axis];
                let along = usize::from((shape.axis.x.abs() < 0.5) != (axis == 1));
                shape.half[along] = fast_max(flat[axis], 0.5 * period[axis] + near);
                return 0;
            }
            let far = (2.0 * reach[axis] / period[axis]).ceil();
            fast_min(far, MAX_IMAGES) as i32
        };
        let (columns, rows) = (count(bounds.periodic_x, 0), count(bounds.periodic_y, 1));
        let middle = shape.centre;
        body.reach = fast_max(body.reach, shape.reach());
        self.bodies.push(body.clone());
        for row in -rows..=rows {
            for column in -columns..=columns {
                let shift = Vec2::new(column as f32, row as f32) * period;
                if (column, row) != (0, 0) && is_inside(centre + shift) {
                    let mut body = body.clone();
                    body.image = shift;
                    body.surface.frame.centre = middle + shift;
                    self.bodies.push(body);
                }
            }
        }
    }
}
