//! Fields sampled from particles on a grid.

use hearth_core::Vec2;
use hearth_core::kernel::Kernel;

/// A grid over a domain that is periodic in x, and the kernel that particles
/// are seen through.
#[derive(Clone, Debug)]
pub struct Sampler {
    /// Cells across.
    pub columns: usize,
    /// Cells up.
    pub rows: usize,
    /// Side of a cell \[m\].
    pub cell: f64,
    width: f64,
    kernel: Kernel,
}

/// Quantities on the grid, row by row from below.
pub type Field = Vec<f64>;

impl Sampler {
    /// A grid of about `cell` \[m\] over `width` × `height` \[m\], x from −width/2
    /// and y from 0, and a kernel of smoothing length `h` \[m\].
    pub fn new(width: f64, height: f64, cell: f64, h: f64) -> Sampler {
        let columns = (width / cell).round().max(1.0);
        let cell = width / columns;
        Sampler {
            columns: columns as usize,
            rows: (height / cell) as usize,
            cell,
            width,
            kernel: Kernel::new(h as f32),
        }
    }

    /// x of the middle of a column \[m\].
    pub fn x(&self, column: usize) -> f64 {
        (column as f64 + 0.5) * self.cell - 0.5 * self.width
    }

    /// y of the middle of a row \[m\].
    pub fn y(&self, row: usize) -> f64 {
        (row as f64 + 0.5) * self.cell
    }

    /// The row at height `y` \[m\].
    pub fn row(&self, y: f64) -> usize {
        ((y / self.cell).max(0.0) as usize).min(self.rows - 1)
    }

    /// The column at `x` \[m\].
    pub fn column(&self, x: f64) -> usize {
        (((x + 0.5 * self.width) / self.cell).max(0.0) as usize).min(self.columns - 1)
    }

    /// Means of `K` quantities of particles of these volumes, weighted by V·W;
    /// zero where there is no particle.
    pub fn sample<const K: usize>(
        &self,
        particles: impl IntoIterator<Item = (Vec2, f32, [f32; K])>,
    ) -> [Field; K] {
        let cells = self.columns * self.rows;
        let mut weights = vec![0.0_f64; cells];
        let mut fields: [Field; K] = std::array::from_fn(|_| vec![0.0; cells]);
        let reach = f64::from(self.kernel.support());
        let columns = self.columns as i64;
        for (position, volume, values) in particles {
            let (px, py) = (f64::from(position.x), f64::from(position.y));
            let across = |x: f64| ((x + 0.5 * self.width) / self.cell - 0.5).ceil() as i64;
            let up = |y: f64| (y / self.cell - 0.5).ceil().max(0.0) as usize;
            for row in up(py - reach)..up(py + reach).min(self.rows) {
                let dy = self.y(row) - py;
                for column in across(px - reach)..across(px + reach) {
                    let dx = (column as f64 + 0.5) * self.cell - 0.5 * self.width - px;
                    let w = f64::from(volume * self.kernel.value(dx.hypot(dy) as f32));
                    let at = row * self.columns + column.rem_euclid(columns) as usize;
                    weights[at] += w;
                    for (field, value) in fields.iter_mut().zip(values) {
                        field[at] += w * f64::from(value);
                    }
                }
            }
        }
        for field in &mut fields {
            for (value, weight) in field.iter_mut().zip(&weights) {
                *value /= weight.max(1e-12);
            }
        }
        fields
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_linear_profile_is_exact() {
        let (dx, width, height) = (0.02_f32, 0.4, 0.6);
        let sampler = Sampler::new(width, height, 0.015, 0.03);
        let particles = (0..600).map(|i| {
            let (column, row) = (i % 20, i / 20);
            let x = (column as f32 + 0.5) * dx - 0.2;
            let y = (row as f32 + 0.5) * dx;
            (Vec2::new(x, y), dx * dx, [300.0 + 100.0 * y, 7.0])
        });
        let [slope, constant] = sampler.sample(particles);
        for row in sampler.row(0.1)..sampler.row(0.5) {
            for column in 0..sampler.columns {
                let at = row * sampler.columns + column;
                let expected = 300.0 + 100.0 * sampler.y(row);
                assert!(
                    (slope[at] - expected).abs() < 0.3,
                    "{} {expected}",
                    slope[at]
                );
                assert!((constant[at] - 7.0).abs() < 1e-4);
            }
        }
    }

    #[test]
    fn the_sides_are_one() {
        let sampler = Sampler::new(0.4, 0.4, 0.02, 0.03);
        let [seen] = sampler.sample([(Vec2::new(0.199, 0.2), 1e-4, [1.0])]);
        let at = sampler.row(0.2) * sampler.columns;
        assert!(seen[at] > 0.99, "left of the left side is the right one");
        assert!(seen[at + sampler.columns / 2] < 0.01);
    }
}
