//! The signed distance to a polygon, a stroke or a mask, sampled on a grid.
//!
//! Every outline becomes a list of lines. Nodes near a line get their distance from it; then each
//! node takes over the nearest line of its neighbours, in two sweeps over the grid (Danielsson
//! 1980, with lines in place of points). Between nodes the distance is interpolated linearly in
//! both directions.

mod nearest;
#[cfg(test)]
mod tests;

use glam::Vec2;

use super::contour::{self, Line, Nodes};
use crate::extremes::{fast_max, fast_min};
use crate::params::{Mask, Shape, Solid};

/// Nodes of a field of points, about.
const NODE_COUNT: f32 = 32_768.0;
/// Cells between an outline and the border of its field.
const MARGIN_CELLS: usize = 3;
/// Smallest distance between nodes \[m\].
const MIN_STEP: f32 = 1e-4;
/// Slope below which a distance has no direction.
const MIN_SLOPE: f32 = 1e-3;
/// How often the nearest point of one beyond the field is refined.
const REFINEMENTS: u32 = 2;
/// Most strides along half of a line, and their least length in depths that a line may reach.
const MAX_STRIDES: u32 = 8;
const MIN_STRIDE: f32 = 0.25;
/// Distance up to which an outline may be between two nodes, in steps.
const MAX_OUTLINE_DISTANCE: f32 = 1.1;

/// Whether a solid of this shape has a field.
pub(super) fn is_sampled(shape: Shape) -> bool {
    matches!(shape, Shape::Polygon | Shape::Stroke | Shape::Mask)
}

/// The field of a solid; `None` for a rounded box.
pub(super) fn of(solid: &Solid) -> Option<Field> {
    is_sampled(solid.shape).then(|| Field::of(solid))
}

/// A sampled signed distance.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// Its middle, relative to the centre of the solid \[m\].
    pub middle: Vec2,
    /// Half of its size \[m\].
    pub half: Vec2,
    /// Nodes of a row.
    pub columns: usize,
    /// Rows of nodes.
    pub rows: usize,
    /// The distance at each node \[m\], negative inside, row by row from below.
    pub distances: Vec<f32>,
    /// Largest depth of a node inside \[m\].
    pub depth: f32,
    /// Whether the solid is round, as a line is.
    pub round: bool,
    /// Distance between nodes \[m\].
    step: Vec2,
}

crate::state! { Field: middle half columns rows distances depth round step }

impl Field {
    /// The field of a solid that has one.
    fn of(solid: &Solid) -> Field {
        match solid.shape {
            Shape::Polygon => {
                let points = solid.points.all();
                let mut field = Field::around(points, 0.0);
                let sides = contour::sides(points);
                field.measure(&contour::of_polygon(&sides));
                field.fill(&sides);
                field.measured()
            }
            Shape::Stroke => {
                let points = solid.points.all();
                let radius = 0.5 * solid.height;
                let mut field = Field::around(points, radius);
                let lines: Vec<Line> = points.array_windows().copied().collect();
                field.measure(&lines);
                let radius = fast_max(radius, field.step.x);
                field.round = true;
                for distance in &mut field.distances {
                    *distance -= radius;
                }
                field.measured()
            }
            _ => {
                let size = Vec2::new(solid.width, solid.height);
                Field::of_mask(&solid.mask, size).measured()
            }
        }
    }

    /// An empty field around points, with a `border` \[m\] and a margin.
    fn around(points: &[Vec2], border: f32) -> Field {
        let (mut low, mut high) = (Vec2::MAX, Vec2::MIN);
        for &point in points {
            low = Vec2::new(fast_min(low.x, point.x), fast_min(low.y, point.y));
            high = Vec2::new(fast_max(high.x, point.x), fast_max(high.y, point.y));
        }
        let size = high - low + 2.0 * border;
        // The margin takes its share of the nodes.
        let margin = 2.0 * MARGIN_CELLS as f32 / NODE_COUNT * fast_max(size.x, size.y);
        let step = libm::sqrtf(size.x * size.y / NODE_COUNT) + margin + MIN_STEP;
        let cells = (size / step).to_array();
        let [columns, rows] = cells.map(|cells| cells as usize + 2 * MARGIN_CELLS + 2);
        Field::new(0.5 * (low + high), Vec2::splat(step), [columns, rows])
    }

    /// A field without distances.
    fn new(middle: Vec2, step: Vec2, [columns, rows]: [usize; 2]) -> Field {
        let cells = Vec2::new(columns as f32 - 1.0, rows as f32 - 1.0);
        Field {
            middle,
            half: 0.5 * cells * step,
            columns,
            rows,
            distances: vec![f32::MAX; columns * rows],
            depth: 0.0,
            round: false,
            step,
        }
    }

    /// The field of a mask of this size \[m\], whose nodes are the centres of its pixels.
    fn of_mask(mask: &Mask, size: Vec2) -> Field {
        let [width, height] = mask.size();
        let step = size / Vec2::new(width as f32, height as f32);
        let nodes = [width, height].map(|pixels| pixels + 2 * MARGIN_CELLS);
        let mut field = Field::new(Vec2::ZERO, step, nodes);
        let opacity: Vec<f32> = (0..field.distances.len())
            .map(|node| {
                let (column, row) = (node % nodes[0], node / nodes[0]);
                // Beyond the mask, the subtractions wrap to indices of no pixel.
                let row = (height + MARGIN_CELLS - 1).wrapping_sub(row);
                mask.opacity(column.wrapping_sub(MARGIN_CELLS), row)
            })
            .collect();
        field.enclose(opacity);
        field
    }

    /// Measures the distance from the outline of what is opaque at these nodes.
    fn enclose(&mut self, opacity: Vec<f32>) {
        self.measure(&contour::of_nodes(&self.nodes(), &opacity));
        for (node, opacity) in opacity.into_iter().enumerate() {
            if opacity > contour::EDGE_OPACITY {
                self.turn(node);
            }
        }
    }

    /// The field of what is more opaque than half, of this size about its middle \[m\], with about
    /// that distance between nodes \[m\].
    pub(crate) fn of_opacity(half: Vec2, step: f32, at: &dyn Fn(Vec2) -> f32) -> Field {
        let cells = (2.0 * half / step).to_array();
        let nodes = cells.map(|cells| cells as usize + 2 * MARGIN_CELLS + 2);
        let mut field = Field::new(Vec2::ZERO, Vec2::splat(step), nodes);
        let places = field.nodes();
        let all = (0..field.distances.len())
            .map(|node| at(places.place(node % places.columns, node / places.columns)));
        let opacity: Vec<f32> = all.collect();
        field.enclose(opacity);
        field.measured()
    }

    /// Area \[m²\] and circumference \[m\]: from the nodes inside, and from those within a step of
    /// the surface.
    pub(crate) fn measures(&self) -> (f32, f32) {
        let cell = self.step.x * self.step.y;
        let near = fast_max(self.step.x, self.step.y);
        let count = |is_counted: &dyn Fn(f32) -> bool| {
            self.distances
                .iter()
                .filter(|distance| is_counted(**distance))
                .count() as f32
        };
        let inside = count(&|distance| distance < 0.0);
        let beside = count(&|distance| distance.abs() < near);
        (inside * cell, 0.5 * beside * cell / near)
    }

    fn nodes(&self) -> Nodes {
        Nodes {
            first: self.middle - self.half,
            step: self.step,
            columns: self.columns,
            rows: self.rows,
        }
    }

    /// Marks the nodes that a polygon with these sides winds around as inside.
    fn fill(&mut self, sides: &[Line]) {
        let nodes = self.nodes();
        let mut is_inside = false;
        for row in 0..nodes.rows {
            for column in 0..nodes.columns {
                let node = row * nodes.columns + column;
                let distance = self.distances[node];
                // Where the outline is farther than the node to the left, both are on one side.
                if distance < MAX_OUTLINE_DISTANCE * nodes.step.x || column == 0 {
                    is_inside = contour::winding(sides, nodes.place(column, row)) != 0;
                }
                if is_inside {
                    self.distances[node] = -self.distances[node];
                }
            }
        }
    }

    /// Marks a node as inside.
    fn turn(&mut self, node: usize) {
        self.distances[node] = -self.distances[node];
    }

    /// The finished field.
    fn measured(mut self) -> Field {
        let farthest = 2.0 * self.half.length();
        for distance in &mut self.distances {
            // Without a line, nothing is near.
            *distance = fast_max(fast_min(*distance, farthest), -farthest);
            self.depth = fast_max(self.depth, -*distance);
        }
        self
    }

    /// The distance of a point from the outline and the normal there. The point is relative to
    /// the middle of the field, along its width and its height.
    pub fn distance(&self, point: Vec2) -> (f32, Vec2) {
        let inside = self.within(point);
        let (distance, normal) = self.sample(inside);
        if inside == point {
            return (distance, normal);
        }
        // Beyond the border, the nearest point of the outline is nearly that of the border. The
        // nearest one of where the way to it crosses the border is nearer.
        let mut near = inside - normal * distance;
        for _ in 0..REFINEMENTS {
            let away = point - near;
            let room = |away: f32, near: f32, half: f32| {
                let room = if away < 0.0 { half + near } else { half - near };
                room / fast_max(away.abs(), MIN_STEP)
            };
            let [x, y] = [
                room(away.x, near.x, self.half.x),
                room(away.y, near.y, self.half.y),
            ];
            let border = self.within(near + away * fast_min(x, y));
            let (distance, normal) = self.sample(border);
            let other = border - normal * distance;
            if other.distance_squared(point) < away.length_squared() {
                near = other;
            }
        }
        let away = point - near;
        let distance = away.length();
        if distance > 0.0 {
            (distance, away / distance)
        } else {
            (distance, normal)
        }
    }

    /// The nearest point of the field.
    fn within(&self, point: Vec2) -> Vec2 {
        let within = |x: f32, half: f32| fast_min(fast_max(x, -half), half);
        Vec2::new(within(point.x, self.half.x), within(point.y, self.half.y))
    }

    /// The interpolated distance at a point of the field, and its normal.
    fn sample(&self, point: Vec2) -> (f32, Vec2) {
        let at = (point + self.half) / self.step;
        let column = (at.x as usize).min(self.columns - 2);
        let row = (at.y as usize).min(self.rows - 2);
        let node =
            |right: usize, up: usize| self.distances[(row + up) * self.columns + column + right];
        let [a, b, c, d] = [node(0, 0), node(1, 0), node(0, 1), node(1, 1)];
        let (x, y) = (at.x - column as f32, at.y - row as f32);
        let (low, high) = (a + (b - a) * x, c + (d - c) * x);
        let slope = Vec2::new(b - a + (d - c - b + a) * y, high - low) / self.step;
        let magnitude = slope.length();
        // A slope vanishes where the distances of two sides meet.
        let normal = if magnitude > MIN_SLOPE {
            slope / magnitude
        } else {
            Vec2::Y
        };
        (low + (high - low) * y, normal)
    }

    /// Whether the line between two points outside crosses the solid. They are relative to the
    /// middle of the field.
    pub(crate) fn crosses(&self, start: Vec2, end: Vec2) -> bool {
        // A line may touch a bulge between two neighbours at the same side.
        let deep = fast_min(0.3 * self.depth, fast_min(self.step.x, self.step.y));
        let middle = 0.5 * (start + end);
        let way = end - middle;
        let length = fast_max(way.length(), MIN_STEP);
        let (distance, _) = self.distance(middle);
        if distance < -deep {
            return true;
        }
        // Nothing is nearer than the distance.
        for way in [way, -way] {
            let mut done = distance + deep;
            for _ in 0..MAX_STRIDES {
                if done >= length {
                    break;
                }
                let (distance, _) = self.distance(middle + way * (done / length));
                if distance < -deep {
                    return true;
                }
                done += fast_max(distance + deep, MIN_STRIDE * deep);
            }
        }
        false
    }
}
