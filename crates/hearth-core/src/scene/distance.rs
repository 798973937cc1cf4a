//! The signed distance to a solid.

use std::f32::consts::PI;
use std::sync::Arc;

use glam::Vec2;

use super::field::{self, Field};

use crate::direction::direction;
use crate::extremes::{fast_max, fast_min};
use crate::params::{Shape, Solid};

/// A circle, a box or a line as a rounded box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RoundedBox {
    /// Centre \[m\].
    pub centre: Vec2,
    /// Direction of its width.
    pub axis: Vec2,
    /// Half of the size of the box that the radius surrounds \[m\].
    pub half: Vec2,
    /// Radius of the corners \[m\].
    pub radius: f32,
}

impl RoundedBox {
    /// The distance of a point from the surface \[m\], negative inside, and the unit normal
    /// there, outward.
    #[inline]
    pub fn distance(&self, point: Vec2) -> (f32, Vec2) {
        let from = point - self.centre;
        let local = Vec2::new(self.axis.dot(from), self.axis.perp_dot(from));
        let sign = Vec2::new(sign(local.x), sign(local.y));
        // Beyond the inner box, the distance is that from its corner or edge.
        let beyond = local * sign - self.half;
        let outside = Vec2::new(fast_max(beyond.x, 0.0), fast_max(beyond.y, 0.0));
        let length = outside.length();
        let (distance, normal) = if length > 0.0 {
            (length, outside / length)
        } else if beyond.x > beyond.y {
            (beyond.x, Vec2::X)
        } else {
            (beyond.y, Vec2::Y)
        };
        let normal = normal * sign;
        let normal = self.axis * normal.x + self.axis.perp() * normal.y;
        (distance - self.radius, normal)
    }

    /// A point relative to its centre, along its width and its height.
    pub fn local(&self, point: Vec2) -> Vec2 {
        let from = point - self.centre;
        Vec2::new(self.axis.dot(from), self.axis.perp_dot(from))
    }

    /// Half of the size of the upright rectangle around it \[m\].
    pub fn extent(&self) -> Vec2 {
        let side = self.axis.abs() * self.half.x;
        side + self.axis.perp().abs() * self.half.y + self.radius
    }

    /// Radius of the circle around the centre that contains it \[m\].
    pub fn reach(&self) -> f32 {
        self.half.length() + self.radius
    }
}

/// The surface of a solid: a rounded box, or a box with a sampled distance inside.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// The rounded box, or that of the field.
    pub frame: RoundedBox,
    /// The sampled distance.
    pub field: Option<Arc<Field>>,
}

crate::state! { RoundedBox: centre axis half radius, Surface: frame field }

impl Surface {
    /// The distance of a point from the surface \[m\], negative inside, and the unit normal
    /// there, outward.
    #[inline]
    pub fn distance(&self, point: Vec2) -> (f32, Vec2) {
        match &self.field {
            None => self.frame.distance(point),
            Some(field) => self.sampled(field, point),
        }
    }

    fn sampled(&self, field: &Field, point: Vec2) -> (f32, Vec2) {
        let (distance, normal) = field.distance(self.frame.local(point));
        let axis = self.frame.axis;
        (distance, axis * normal.x + axis.perp() * normal.y)
    }
}

impl Surface {
    /// Area \[m²\] and circumference \[m\]; of a sampled distance, within a few percent.
    pub fn measures(&self) -> (f32, f32) {
        let RoundedBox { half, radius, .. } = self.frame;
        match &self.field {
            None => {
                let straight = 4.0 * (half.x + half.y);
                let area = 4.0 * half.x * half.y + radius * (straight + PI * radius);
                (area, straight + 2.0 * PI * radius)
            }
            Some(field) => field.measures(),
        }
    }
}

fn sign(x: f32) -> f32 {
    if x < 0.0 { -1.0 } else { 1.0 }
}

impl Solid {
    /// Its surface. That of a polygon, a stroke or a mask takes a millisecond: a scene keeps those
    /// of its solids.
    pub fn surface(&self) -> Surface {
        self.surface_with(field::of(self).map(Arc::new))
    }

    /// Its surface with a field that was sampled before.
    pub(crate) fn surface_with(&self, field: Option<Arc<Field>>) -> Surface {
        let size = 0.5 * Vec2::new(self.width, self.height);
        let radius = match self.shape {
            Shape::Circle => size.x,
            Shape::Box => fast_min(self.corner, fast_min(size.x, size.y)),
            Shape::Line => size.y,
            _ => 0.0,
        };
        let half = match (&field, self.shape) {
            (Some(field), _) => field.half,
            (_, Shape::Box) => size - radius,
            // Its length does not include the round ends.
            (_, Shape::Line) => Vec2::new(fast_max(size.x, 0.0), 0.0),
            _ => Vec2::ZERO,
        };
        let axis = match self.shape {
            Shape::Circle => Vec2::X,
            _ => direction(self.angle),
        };
        let mut centre = Vec2::new(self.x, self.y);
        if let Some(field) = &field {
            centre += axis * field.middle.x + axis.perp() * field.middle.y;
        }
        let frame = RoundedBox {
            centre,
            axis,
            half,
            radius,
        };
        Surface { frame, field }
    }

    /// Whether the field of another solid is its own.
    pub(super) fn has_field_of(&self, other: &Solid) -> bool {
        let size = |solid: &Solid| [solid.width, solid.height];
        self.shape == other.shape
            && size(self) == size(other)
            && self.points.text() == other.points.text()
            && self.mask.text() == other.mask.text()
    }

    /// The distance of a point from the surface \[m\], positive outside, and the unit normal
    /// there, outward.
    pub fn distance(&self, point: Vec2) -> (f32, Vec2) {
        self.surface().distance(point)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(found: (f32, Vec2), distance: f32, normal: Vec2) {
        assert!((found.0 - distance).abs() < 1e-5, "{found:?}");
        assert!((found.1 - normal).length() < 1e-5, "{found:?}");
    }

    #[test]
    fn a_circle_has_its_diameter() {
        let circle = Solid {
            x: 1.0,
            y: 2.0,
            width: 0.4,
            ..Solid::default()
        };
        close(circle.distance(Vec2::new(1.5, 2.0)), 0.3, Vec2::X);
        close(circle.distance(Vec2::new(1.0, 1.9)), -0.1, -Vec2::Y);
        let at_centre = circle.distance(Vec2::new(1.0, 2.0));
        assert!((at_centre.0 + 0.2).abs() < 1e-6 && at_centre.1.is_normalized());
    }

    #[test]
    fn a_turned_box_has_round_corners() {
        let solid = Solid {
            shape: Shape::Box,
            y: 0.0,
            width: 0.6,
            height: 0.2,
            corner: 0.05,
            angle: 90.0,
            ..Solid::default()
        };
        close(solid.distance(Vec2::new(0.0, 0.5)), 0.2, Vec2::Y);
        close(solid.distance(Vec2::new(-0.3, 0.1)), 0.2, -Vec2::X);
        close(solid.distance(Vec2::new(0.02, 0.0)), -0.08, Vec2::X);
        let corner = Vec2::new(0.05, -0.25);
        let diagonal = Vec2::new(1.0, -1.0).normalize();
        close(solid.distance(corner + 0.2 * diagonal), 0.15, diagonal);
    }

    #[test]
    fn a_line_has_round_ends_beyond_its_length() {
        let line = Solid {
            shape: Shape::Line,
            y: 0.0,
            width: 0.4,
            height: 0.1,
            ..Solid::default()
        };
        close(line.distance(Vec2::new(0.1, -0.2)), 0.15, -Vec2::Y);
        close(line.distance(Vec2::new(0.4, 0.0)), 0.15, Vec2::X);
        let up = Vec2::new(3.0, 4.0) / 5.0;
        close(line.distance(Vec2::new(0.2, 0.0) + 0.3 * up), 0.25, up);
    }

    #[test]
    fn every_distance_is_that_of_the_nearest_point_of_the_surface() {
        for shape in [Shape::Circle, Shape::Box, Shape::Line] {
            let solid = Solid {
                shape,
                width: 0.5,
                height: 0.2,
                corner: 0.07,
                angle: 30.0,
                ..Solid::default()
            };
            for index in 0..400 {
                let place = Vec2::new((index % 20) as f32, (index / 20) as f32) * 0.05;
                let point = place + Vec2::new(-0.51, 0.01);
                let (distance, normal) = solid.distance(point);
                // Inside, the nearest point of a rounded box may be on another side.
                if distance > 0.0 {
                    let (rest, _) = solid.distance(point - normal * distance);
                    assert!(rest.abs() < 1e-5, "{shape:?} at {point}: {rest}");
                }
                assert!(normal.is_normalized());
            }
        }
    }
}
