//! Thin solids: gas on one side does not feel gas on the other side.

use glam::Vec2;

use super::{Body, Solids};
use crate::scene::RoundedBox;

/// The part of a rounded corner that hides the particles behind it, in radii.
const OPAQUE: f32 = 0.7;
/// So many solids near a position are found once for all of its neighbours.
const FEW: usize = 8;

impl Body {
    /// Whether it is thinner somewhere than the support of the kernel \[m\]. The thickness of a
    /// sampled one is unknown.
    pub fn is_thin(&self, support: f32) -> bool {
        let shape = &self.surface.frame;
        self.surface.field.is_some() || 2.0 * (shape.half.min_element() + shape.radius) < support
    }

    /// Whether the line between two positions crosses it.
    fn is_between(&self, one: Vec2, other: Vec2) -> bool {
        let frame = &self.surface.frame;
        match &self.surface.field {
            // The outline is inside of its frame by more than a cell.
            Some(field) => {
                crosses(frame, one, other) && field.crosses(frame.local(one), frame.local(other))
            }
            None => crosses(frame, one, other),
        }
    }
}

impl Solids {
    /// The normal of the plane that a thin solid lies behind; zero for one that is not convex.
    pub fn plane(&self, solid: u32, normal: Vec2) -> Vec2 {
        let body = self.bodies.get(solid as usize);
        match body.and_then(|body| body.surface.field.as_ref()) {
            Some(_) => Vec2::ZERO,
            None => normal,
        }
    }

    /// Whether any is thin.
    pub fn any_thin(&self, support: f32) -> bool {
        self.bodies.iter().any(|body| body.is_thin(support))
    }

    /// The thin ones near a position: normal, or zero for one that is not convex, distance and
    /// index.
    pub fn thin_near(&self, at: Vec2, support: f32) -> impl Iterator<Item = (Vec2, f32, u32)> {
        let bodies = (0..).zip(&self.bodies);
        bodies.filter_map(move |(number, body)| {
            if !body.may_touch(at, support) || !body.is_thin(support) {
                return None;
            }
            let (distance, normal) = body.surface.distance(at);
            let entry = (self.plane(number, normal), distance, number);
            (distance < support).then_some(entry)
        })
    }

    /// Whether the line between two positions crosses a solid.
    pub fn crosses(&self, solid: u32, one: Vec2, other: Vec2) -> bool {
        let body = self.bodies.get(solid as usize);
        body.is_some_and(|body| body.is_between(one, other))
    }

    /// Whether a thin solid is between a position and another one within the support of the
    /// kernel \[m\].
    #[inline(never)]
    pub fn part(&self, one: Vec2, other: Vec2, support: f32) -> bool {
        let mut near = self.bodies.iter();
        near.any(|body| {
            body.may_touch(one, support) && body.is_thin(support) && body.is_between(one, other)
        })
    }

    /// The first thin solids near a position, and whether there are more.
    pub fn beside(&self, at: Vec2, support: f32) -> Beside<'_> {
        let mut beside = Beside {
            solids: self,
            first: [0; FEW],
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
    first: [usize; FEW],
    count: usize,
}

impl Beside<'_> {
    /// Whether one of them is between that position and another one within the support of the
    /// kernel \[m\].
    pub fn part(&self, one: Vec2, other: Vec2, support: f32) -> bool {
        let Some(first) = self.first.get(..self.count) else {
            return self.solids.part(one, other, support);
        };
        let mut bodies = first.iter().filter_map(|&at| self.solids.bodies.get(at));
        bodies.any(|body| body.is_between(one, other))
    }
}

/// Whether a line has a part inside of a box, whose corners hide less if they are round: whether
/// neither an axis of the box nor the normal of the line separates them.
fn crosses(shape: &RoundedBox, one: Vec2, other: Vec2) -> bool {
    let (from, to) = (shape.local(one), shape.local(other));
    let half = shape.half + OPAQUE * shape.radius;
    let (middle, path) = (0.5 * (from + to), 0.5 * (to - from));
    let (beside, along) = (middle.abs(), path.abs());
    // Without branches: which of them separates is unpredictable.
    (beside.x < half.x + along.x)
        & (beside.y < half.y + along.y)
        & (middle.perp_dot(path).abs() < half.x * along.y + half.y * along.x)
}

#[cfg(test)]
mod tests {
    use super::*;

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
