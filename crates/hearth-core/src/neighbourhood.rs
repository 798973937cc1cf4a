//! Vorticity and number of neighbours of every particle, for the displays that show them.
//!
//! A paused fire and particles that a caller has just put in have these too, so the search
//! reads the particles as they are and not the lists of the last step. Its memory is the
//! list of instances itself: behind the instances stands the first particle of each cell,
//! and a free field of each instance holds the next particle of the same cell. So a picture
//! of a warm fire allocates nothing and changes nothing.

use crate::bounds::Bounds;
use crate::extremes::fast_max;
use crate::instance::Instance;
use crate::kernel;

/// Fields of an instance: its volume, a free one, and the result.
const VOLUME: usize = 5;
const NEXT: usize = 6;
const FOUND: usize = 7;

/// After so many metres an axis with two ends begins again: out of every reach.
const FAR: f32 = 1e9;
/// Numbers of an instance.
const FIELDS: usize = size_of::<Instance>() / size_of::<f32>();

/// Finds the `vorticity` of each particle [1/s] or, where that is false, the number of its
/// neighbours within 2`h` \[m\].
///
/// The vorticity is twice the speed at which its neighbours turn around it,
/// ω = 2 Σ V g (r × v)/Σ V g r², g = −W'/r, with r and v from it to each of them:
/// the curl of SPH over what that makes of a rigid rotation, which so comes out
/// exactly, at the rim of the gas too.
pub(crate) fn measure(instances: &mut Vec<Instance>, bounds: &Bounds, h: f32, vorticity: bool) {
    let count = instances.len();
    let reach = 2.0 * h;
    // As wide as a kernel reaches, and no more of them than particles.
    let area = bounds.width * bounds.height;
    let edge = fast_max(reach, (area / (count + 1) as f32).sqrt());
    let across = Axis::new(bounds.width, edge, bounds.periodic);
    let up = Axis::new(bounds.height, edge, bounds.endless);
    let place = |one: &Instance| (across.cell(one[0] + 0.5 * bounds.width), up.cell(one[1]));

    let cells = across.cells * up.cells;
    instances.resize(count + cells.div_ceil(FIELDS), [0.0; FIELDS]);
    let (particles, first) = instances.split_at_mut(count);
    let first = first.as_flattened_mut();
    for (i, one) in particles.iter_mut().enumerate() {
        let (column, row) = place(one);
        if let Some(first) = first.get_mut(row * across.cells + column) {
            one[NEXT] = *first;
            // From one on, zero is nobody. An f32 holds each up to sixteen million.
            *first = (i + 1) as f32;
        }
    }
    for i in 0..count {
        let one = particles[i];
        let (column, row) = place(&one);
        // Its own neighbour is itself too, which turns nothing.
        let (mut turn, mut inertia, mut near) = (0.0, 0.0, -1.0);
        for side in 0..9 {
            let (column, beside) = across.next_to(column, side % 3);
            let (row, above) = up.next_to(row, side / 3);
            let first = first.get(row * across.cells + column);
            let mut next = first.copied().unwrap_or(0.0);
            while let Some(other) = particles.get((next as usize).wrapping_sub(1)) {
                next = other[NEXT];
                let (x, y) = (other[0] + beside - one[0], other[1] + above - one[1]);
                let square = x * x + y * y;
                if square < reach * reach {
                    near += 1.0;
                    let q = fast_max(square.sqrt() / h, 1e-6);
                    let weight = other[VOLUME] * kernel::minus_dw(q) / q;
                    turn += weight * (x * (other[3] - one[3]) - y * (other[2] - one[2]));
                    inertia += weight * square;
                }
            }
        }
        particles[i][FOUND] = if vorticity {
            2.0 * turn / fast_max(inertia, f32::MIN_POSITIVE)
        } else {
            near
        };
    }
    instances.truncate(count);
    for one in instances {
        one[NEXT] = 0.0;
    }
}

/// The cells of the domain along an axis.
struct Axis {
    length: f32,
    cells: usize,
    /// After so much it begins again.
    turn: f32,
}

impl Axis {
    fn new(length: f32, edge: f32, closed: bool) -> Axis {
        Axis {
            length,
            cells: ((length / edge) as usize).max(1),
            turn: if closed { length } else { FAR },
        }
    }

    /// The cell so far from its beginning. What is outside, or not a number, comes
    /// to an end.
    fn cell(&self, at: f32) -> usize {
        ((at / self.length * self.cells as f32) as usize).min(self.cells - 1)
    }

    /// The cell before a cell, that cell or the one after it (`side` of 0, 1, 2), and
    /// what is to be added to the places in it.
    #[inline(never)]
    fn next_to(&self, cell: usize, side: usize) -> (usize, f32) {
        let next = cell + side;
        if next == 0 {
            (self.cells - 1, -self.turn)
        } else if next > self.cells {
            (0, self.turn)
        } else {
            (next - 1, 0.0)
        }
    }
}
