//! The distance of each node of a field from the nearest line of an outline, by sweeps.

use glam::Vec2;

use super::Field;
use crate::extremes::{fast_max, fast_min};
use crate::scene::contour::Line;

/// No line.
const NONE: u32 = u32::MAX;

impl Field {
    /// Sets the distance of each node from the nearest of these lines.
    pub(super) fn measure(&mut self, lines: &[Line]) {
        let mut nearest = vec![NONE; self.distances.len()];
        for (index, line) in (0..).zip(lines) {
            self.seed(&mut nearest, lines, index, line);
        }
        let (columns, rows) = (self.columns as isize, self.rows as isize);
        for sweep in 0..4 {
            let (up, right) = ([1, -1][sweep / 2], [1, -1][sweep % 2]);
            for row in 0..rows {
                let row = if up > 0 { row } else { rows - 1 - row };
                for column in 0..columns {
                    let column = if right > 0 {
                        column
                    } else {
                        columns - 1 - column
                    };
                    for (x, y) in [(-right, 0), (-1, -up), (0, -up), (1, -up)] {
                        let (x, y) = (column + x, row + y);
                        if (0..columns).contains(&x) && (0..rows).contains(&y) {
                            let known = nearest[(y * columns + x) as usize];
                            let node = [column as usize, row as usize];
                            self.offer(&mut nearest, lines, node, known);
                        }
                    }
                }
            }
        }
        for distance in &mut self.distances {
            *distance = libm::sqrtf(*distance);
        }
    }

    /// Offers a line to the nodes around it.
    fn seed(&mut self, nearest: &mut [u32], lines: &[Line], index: u32, &[start, end]: &Line) {
        let place = |point: Vec2| (point - self.middle + self.half) / self.step;
        let (start, end) = (place(start), place(end));
        let (low, high) = if start.y < end.y {
            (start, end)
        } else {
            (end, start)
        };
        let slope = (high.x - low.x) / fast_max(high.y - low.y, 1e-6);
        let columns = self.columns;
        let (first, last) = (low.y as usize, high.y as usize + 1);
        for row in first..=last {
            // Where the line passes the rows before and after this one.
            let [begin, end] = [-1.0, 1.0].map(|beside| {
                let y = fast_min(fast_max(row as f32 + beside, low.y), high.y);
                fast_min(fast_max(low.x + slope * (y - low.y), 0.0), columns as f32)
            });
            let (left, right) = (fast_min(begin, end), fast_max(begin, end));
            for column in left as usize..=right as usize + 1 {
                if column < columns && row < self.rows {
                    self.offer(nearest, lines, [column, row], index);
                }
            }
        }
    }

    /// Makes a line the nearest one of a node if it is nearer.
    fn offer(
        &mut self,
        nearest: &mut [u32],
        lines: &[Line],
        [column, row]: [usize; 2],
        index: u32,
    ) {
        if index == NONE {
            return;
        }
        let squared = distance_squared(self.nodes().place(column, row), &lines[index as usize]);
        let node = row * self.columns + column;
        if squared < self.distances[node] {
            (self.distances[node], nearest[node]) = (squared, index);
        }
    }
}

/// The square of the distance of a point from a line.
#[inline]
pub(super) fn distance_squared(point: Vec2, &[start, end]: &Line) -> f32 {
    let (path, from) = (end - start, point - start);
    let along = from.dot(path) / fast_max(path.length_squared(), 1e-12);
    let along = fast_min(fast_max(along, 0.0), 1.0);
    (from - path * along).length_squared()
}
