//! Vorticity and number of neighbours of every particle, for the displays that show them.
//!
//! A paused fire and particles that a caller has just put in have these too, so the search
//! reads the present particles and not the lists of the last step. Its cell lists are in the
//! list of instances: the first particle of each cell follows the instances, and a free field
//! of each instance holds the next particle of the same cell. So a frame of a warm fire
//! allocates nothing.

use glam::Vec2;

use crate::bounds::Bounds;
use crate::extremes::fast_max;
use crate::instance::Instance;
use crate::kernel;
use crate::solids::Solids;

/// Fields of an instance: the volume, the next particle of the cell, and the result.
const VOLUME: usize = 5;
const NEXT: usize = 6;
const RESULT: usize = 7;

/// Period of an axis that is not periodic \[m\]: beyond every support.
const NO_PERIOD: f32 = 1e9;
/// Number of fields of an instance.
const FIELDS: usize = size_of::<Instance>() / size_of::<f32>();

/// Finds the `vorticity` of each particle [1/s] or, if that is false, the number of its
/// neighbours within 2`h` \[m\].
///
/// The vorticity is twice the angular velocity of the neighbours around the particle,
/// ω = 2 Σ V g (r × v)/Σ V g r², g = −W'/r, with the offsets r and relative velocities v. It is
/// the curl of SPH, normalised so that a rigid rotation is exact at the rim of the gas too.
/// Particles behind a thin solid are no neighbours.
pub(crate) fn measure(
    instances: &mut Vec<Instance>,
    bounds: &Bounds,
    solids: &Solids,
    h: f32,
    vorticity: bool,
) {
    let count = instances.len();
    let reach = 2.0 * h;
    // Cells are at least a support radius wide, and no more than the particles.
    let area = bounds.width * bounds.height;
    let edge = fast_max(reach, (area / (count + 1) as f32).sqrt());
    let axis_x = Axis::new(bounds.width, edge, bounds.periodic_x);
    let axis_y = Axis::new(bounds.height, edge, bounds.periodic_y);
    let cell = |instance: &Instance| {
        (
            axis_x.cell(instance[0] + 0.5 * bounds.width),
            axis_y.cell(instance[1] - bounds.bottom),
        )
    };

    let cells = axis_x.cells * axis_y.cells;
    instances.resize(count + cells.div_ceil(FIELDS), [0.0; FIELDS]);
    let (particles, first) = instances.split_at_mut(count);
    let first = first.as_flattened_mut();
    for (i, instance) in particles.iter_mut().enumerate() {
        let (column, row) = cell(instance);
        let first = &mut first[row * axis_x.cells + column];
        instance[NEXT] = *first;
        // Indices are one-based; zero ends a list. An f32 holds integers up to 2²⁴.
        *first = (i + 1) as f32;
    }
    for i in 0..count {
        let instance = particles[i];
        let (column, row) = cell(&instance);
        // The search includes the particle itself, which has no angular momentum.
        let (mut rotation, mut inertia, mut near) = (0.0, 0.0, -1.0);
        let place = Vec2::new(instance[0], instance[1]);
        let beside_solid = solids.touch(place, reach);
        for side in 0..9 {
            let (column, beside) = axis_x.next_to(column, side % 3);
            let (row, above) = axis_y.next_to(row, side / 3);
            let mut next = first[row * axis_x.cells + column];
            while next > 0.0 {
                let other = &particles[next as usize - 1];
                next = other[NEXT];
                let (x, y) = (
                    other[0] + beside - instance[0],
                    other[1] + above - instance[1],
                );
                let square = x * x + y * y;
                let is_behind =
                    || beside_solid && solids.separate(place, place + Vec2::new(x, y), reach);
                if square < reach * reach && !is_behind() {
                    near += 1.0;
                    let q = fast_max(square.sqrt() / h, 1e-6);
                    let weight = other[VOLUME] * kernel::minus_dw(q) / q;
                    rotation +=
                        weight * (x * (other[3] - instance[3]) - y * (other[2] - instance[2]));
                    inertia += weight * square;
                }
            }
        }
        particles[i][RESULT] = if vorticity {
            2.0 * rotation / fast_max(inertia, f32::MIN_POSITIVE)
        } else {
            near
        };
    }
    instances.truncate(count);
    for instance in instances {
        instance[NEXT] = 0.0;
    }
}

/// The cells of the domain along an axis.
struct Axis {
    length: f32,
    cells: usize,
    /// Period \[m\].
    period: f32,
}

impl Axis {
    fn new(length: f32, edge: f32, periodic: bool) -> Axis {
        Axis {
            length,
            cells: ((length / edge) as usize).max(1),
            period: if periodic { length } else { NO_PERIOD },
        }
    }

    /// The cell at a distance from the start of the axis. Positions outside and NaN are clamped
    /// to an end.
    fn cell(&self, at: f32) -> usize {
        ((at / self.length * self.cells as f32) as usize).min(self.cells - 1)
    }

    /// The cell before a cell, that cell or the one after it (`side` 0, 1, 2), and the shift
    /// of the positions in it.
    fn next_to(&self, cell: usize, side: usize) -> (usize, f32) {
        let next = cell + side;
        if next == 0 {
            (self.cells - 1, -self.period)
        } else if next > self.cells {
            (0, self.period)
        } else {
            (next - 1, 0.0)
        }
    }
}
