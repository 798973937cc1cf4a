//! Thin solids: gas on one side does not act on gas on the other side.

use glam::Vec2;

use super::{Body, Solids};
use crate::lanes::{LANES, Lanes};
use crate::scene::{Field, RoundedBox, Surface};

/// The part of a rounded corner that hides the particles behind it, in radii.
const OPAQUE_RADII: f32 = 0.7;
/// So many solids near a position are found once for all of its neighbours.
const MAX_LISTED: usize = 8;

impl Body {
    /// Whether it is thinner somewhere than the support of the kernel \[m\]. The thickness of a
    /// sampled one is unknown.
    pub fn is_thin(&self, support: f32) -> bool {
        let shape = &self.surface.frame;
        self.surface.field.is_some() || 2.0 * (shape.half.min_element() + shape.radius) < support
    }

    /// Whether the line between two positions crosses it.
    pub fn is_between(&self, from: Vec2, to: Vec2) -> bool {
        let to = to.to_array().map(Lanes::splat);
        self.surface.lines_from(from).crossed(to, 1) != 0
    }
}

impl Surface {
    /// The lines from a position.
    fn lines_from(&self, from: Vec2) -> Lines<'_> {
        Lines {
            frame: &self.frame,
            field: self.field.as_deref(),
            from: self.frame.local(from),
        }
    }
}

/// The lines from a position, beside a solid.
pub(crate) struct Lines<'a> {
    frame: &'a RoundedBox,
    field: Option<&'a Field>,
    /// The position relative to the centre of the solid, along its width and its height \[m\].
    from: Vec2,
}

impl Lines<'_> {
    /// Whether the solid is convex.
    pub fn is_convex(&self) -> bool {
        self.field.is_none()
    }

    /// Which of those to four positions of a bit mask have a part inside of the solid, whose corners
    /// hide less if they are round: whether neither an axis of its box nor the normal of the line
    /// separates them.
    pub fn crossed(&self, [x, y]: [Lanes; 2], mask: u32) -> u32 {
        let RoundedBox {
            centre,
            axis,
            half,
            radius,
        } = *self.frame;
        // Twice of it, as the middle and the half of each line.
        let half = 2.0 * (half + OPAQUE_RADII * radius);
        let (x, y) = (x - centre.x, y - centre.y);
        let (x, y) = (x * axis.x + y * axis.y, y * axis.x - x * axis.y);
        let (middle_x, middle_y) = (x + self.from.x, y + self.from.y);
        let (path_x, path_y) = (x - self.from.x, y - self.from.y);
        let (along_x, along_y) = (path_x.abs(), path_y.abs());
        let turned = (middle_x * path_y - middle_y * path_x).abs();
        // Without branches: which of them separates is unpredictable.
        let crossed = mask
            & middle_x.abs().less_mask(along_x + half.x)
            & middle_y.abs().less_mask(along_y + half.y)
            & turned.less_mask(along_y * half.x + along_x * half.y);
        match self.field {
            // The outline is inside of its frame by more than a cell.
            Some(field) if crossed != 0 => self.inside(field, [x, y], crossed),
            _ => crossed,
        }
    }

    /// Which of the lines to four positions, relative to the centre, cross a sampled outline.
    fn inside(&self, field: &Field, to: [Lanes; 2], mask: u32) -> u32 {
        let [x, y] = to.map(Lanes::to_array);
        let lanes = (0..LANES).filter(|&lane| {
            mask >> lane & 1 != 0 && field.crosses(self.from, Vec2::new(x[lane], y[lane]))
        });
        lanes.fold(0, |all, lane| all | 1 << lane)
    }
}

impl Solids {
    /// Whether any is thin.
    pub fn any_thin(&self, support: f32) -> bool {
        self.bodies.iter().any(|body| body.is_thin(support))
    }

    /// The thin ones near a position: normal, distance and index.
    pub fn thin_near(&self, at: Vec2, support: f32) -> impl Iterator<Item = (Vec2, f32, u32)> {
        let bodies = (0..).zip(&self.bodies);
        bodies.filter_map(move |(number, body)| {
            if !body.may_touch(at, support) || !body.is_thin(support) {
                return None;
            }
            let (distance, normal) = body.surface.distance(at);
            (distance < support).then_some((normal, distance, number))
        })
    }

    /// The lines from a position, beside a solid.
    pub fn lines_from(&self, solid: u32, from: Vec2) -> Lines<'_> {
        self.bodies[solid as usize].surface.lines_from(from)
    }

    /// Whether a thin solid is between a position and another one within the support of the
    /// kernel \[m\].
    pub fn separate(&self, from: Vec2, to: Vec2, support: f32) -> bool {
        !self.is_empty() && self.any_between(from, to, support)
    }

    fn any_between(&self, from: Vec2, to: Vec2, support: f32) -> bool {
        let mut near = self.bodies.iter();
        near.any(|body| {
            body.may_touch(from, support) && body.is_thin(support) && body.is_between(from, to)
        })
    }

    /// The first thin solids near a position, and whether there are more.
    pub fn beside(&self, at: Vec2, support: f32) -> Beside<'_> {
        let mut beside = Beside {
            solids: self,
            first: [0; MAX_LISTED],
            count: 0,
        };
        for (number, body) in self.bodies.iter().enumerate() {
            if body.may_touch(at, support) && body.is_thin(support) {
                if let Some(first) = beside.first.get_mut(beside.count) {
                    *first = number;
                }
                beside.count += 1;
            }
        }
        beside
    }
}

/// The thin solids near a position.
pub(crate) struct Beside<'a> {
    solids: &'a Solids,
    first: [usize; MAX_LISTED],
    count: usize,
}

impl Beside<'_> {
    /// Whether one of them is between that position and another one within the support of the
    /// kernel \[m\].
    pub fn separate(&self, from: Vec2, to: Vec2, support: f32) -> bool {
        let Some(first) = self.first.get(..self.count) else {
            return self.solids.separate(from, to, support);
        };
        let mut bodies = first.iter().map(|&at| &self.solids.bodies[at]);
        bodies.any(|body| body.is_between(from, to))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn crosses(frame: &RoundedBox, from: Vec2, to: Vec2) -> bool {
        let surface = Surface {
            frame: *frame,
            field: None,
        };
        let lines = surface.lines_from(from);
        let [near, far] = [from, to].map(|at| at.to_array());
        // The other lanes have lines without a length.
        let to = [0, 1].map(|axis| Lanes::new([near[axis], far[axis], near[axis], near[axis]]));
        lines.crossed(to, 0b1111) == 0b10
    }

    #[test]
    fn a_plate_is_between_the_particles_on_its_two_sides() {
        let plate = RoundedBox {
            centre: Vec2::new(1.0, 0.0),
            axis: Vec2::Y,
            half: Vec2::new(0.5, 0.0),
            radius: 0.01,
        };
        let left = Vec2::new(0.97, 0.1);
        assert!(crosses(&plate, left, Vec2::new(1.08, 0.3)));
        assert!(!crosses(&plate, left, Vec2::new(0.95, 0.3)));
        // Around its end.
        assert!(!crosses(
            &plate,
            Vec2::new(0.97, 0.5),
            Vec2::new(1.03, 0.55)
        ));
        assert!(crosses(
            &plate,
            Vec2::new(0.97, 0.47),
            Vec2::new(1.03, 0.51)
        ));
    }
}
