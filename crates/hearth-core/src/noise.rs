//! Perlin's gradient noise in two dimensions (Perlin, SIGGRAPH 2002).
//!
//! The gradients come from a hash of the lattice point and the seed, so there
//! is no table to fill and the noise never repeats.

use glam::Vec2;

/// Smooth noise of a seed at (x, y): from −1 to 1, zero on average and at every lattice point,
/// one lattice cell per unit. `y` is a time, which an `f32` would not resolve after a day.
pub fn perlin(seed: u32, x: f32, y: f64) -> f32 {
    let (cell_x, cell_y) = (x.floor(), y.floor());
    let (fx, fy) = (x - cell_x, (y - cell_y) as f32);
    let (ix, iy) = (cell_x as i32, cell_y as i64 as i32);
    let corner = |dx: i32, dy: i32| {
        let (gx, gy) = gradient(seed, ix.wrapping_add(dx), iy.wrapping_add(dy));
        gx * (fx - dx as f32) + gy * (fy - dy as f32)
    };
    let (u, v) = (fade(fx), fade(fy));
    let lower = corner(0, 0) + u * (corner(1, 0) - corner(0, 0));
    let upper = corner(0, 1) + u * (corner(1, 1) - corner(0, 1));
    lower + v * (upper - lower)
}

/// The gradient of the noise at `at`, in a lattice with these periods in cells.
pub fn perlin_gradient(seed: u32, at: Vec2, periods: [u32; 2]) -> Vec2 {
    let cell = at.floor();
    let inside = at - cell;
    let wrapped = |axis: f32, periods: u32| (axis as i32).rem_euclid(periods.max(1) as i32);
    let (left, lower) = (wrapped(cell.x, periods[0]), wrapped(cell.y, periods[1]));
    let right = wrapped(left as f32 + 1.0, periods[0]);
    let upper = wrapped(lower as f32 + 1.0, periods[1]);
    let corner = |ix, iy, dx: f32, dy: f32| {
        let (gx, gy) = gradient(seed, ix, iy);
        let slope = Vec2::new(gx, gy);
        (slope, slope.dot(inside - Vec2::new(dx, dy)))
    };
    let (a, at_a) = corner(left, lower, 0.0, 0.0);
    let (b, at_b) = corner(right, lower, 1.0, 0.0);
    let (c, at_c) = corner(left, upper, 0.0, 1.0);
    let (d, at_d) = corner(right, upper, 1.0, 1.0);
    let (u, v) = (fade(inside.x), fade(inside.y));
    let twist = at_a - at_b - at_c + at_d;
    a + (b - a) * u
        + (c - a) * v
        + (a - b - c + d) * (u * v)
        + Vec2::new(
            fade_slope(inside.x) * (at_b - at_a + v * twist),
            fade_slope(inside.y) * (at_c - at_a + u * twist),
        )
}

/// 6t⁵ − 15t⁴ + 10t³: the gradient of the noise is continuous.
fn fade(t: f32) -> f32 {
    t * t * t * (t * (t * 6.0 - 15.0) + 10.0)
}

/// The derivative of [`fade`].
fn fade_slope(t: f32) -> f32 {
    30.0 * t * t * (t * (t - 2.0) + 1.0)
}

/// One of eight gradients, each of length √2, so that the noise reaches ±1.
// Turbulence evaluates eight gradients per particle.
#[inline(always)]
fn gradient(seed: u32, ix: i32, iy: i32) -> (f32, f32) {
    const DIAGONAL: f32 = 1.0;
    const AXIS: f32 = std::f32::consts::SQRT_2;
    let mut hash = seed
        .wrapping_add((ix as u32).wrapping_mul(0x9E37_79B1))
        .wrapping_add((iy as u32).wrapping_mul(0x85EB_CA77));
    hash = (hash ^ (hash >> 15)).wrapping_mul(0x2C1B_3C6D);
    hash = (hash ^ (hash >> 12)).wrapping_mul(0x297A_2D39);
    match (hash ^ (hash >> 15)) & 7 {
        0 => (DIAGONAL, DIAGONAL),
        1 => (-DIAGONAL, DIAGONAL),
        2 => (DIAGONAL, -DIAGONAL),
        3 => (-DIAGONAL, -DIAGONAL),
        4 => (AXIS, 0.0),
        5 => (-AXIS, 0.0),
        6 => (0.0, AXIS),
        _ => (0.0, -AXIS),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_smooth_bounded_and_zero_on_average() {
        let (mut sum, mut n) = (0.0, 0);
        for i in 0..300 {
            for j in 0..300 {
                let (x, y) = (i as f32 * 0.37 - 50.0, f64::from(j) * 0.41 - 60.0);
                let value = perlin(3, x, y);
                assert!(value.abs() <= 1.0, "{value} at {x}, {y}");
                assert!((perlin(3, x + 1e-3, y) - value).abs() < 0.02);
                sum += f64::from(value);
                n += 1;
            }
        }
        assert!((sum / f64::from(n)).abs() < 0.02);
    }

    #[test]
    fn its_gradient_is_its_rate_of_change() {
        let mut checked = 0;
        for i in 0..400 {
            // Within one period of the lattice.
            let at = Vec2::new((i % 20) as f32 * 0.37, (i / 20) as f32 * 0.31);
            let noise = |x: f32, y: f32| perlin(3, x, f64::from(y));
            let d = 1e-3;
            let slope = Vec2::new(
                noise(at.x + d, at.y) - noise(at.x - d, at.y),
                noise(at.x, at.y + d) - noise(at.x, at.y - d),
            ) / (2.0 * d);
            let gradient = perlin_gradient(3, at, [64, 64]);
            assert!(
                slope.distance(gradient) < 5e-3,
                "{slope} and {gradient} at {at}"
            );
            checked += i32::from(gradient.length() > 0.1);
        }
        assert!(checked > 300);
    }

    #[test]
    fn it_is_as_smooth_after_a_year() {
        let year = 365.0 * 86_400.0 * 3.0;
        let values: Vec<f32> = (0..500)
            .map(|i| perlin(1, 0.3, year + f64::from(i) * 0.01))
            .collect();
        let moves = |pair: &[f32]| (pair[1] - pair[0]).abs();
        assert!(values.windows(2).all(|pair| moves(pair) < 0.1));
        assert!(values.windows(2).filter(|pair| moves(pair) > 0.0).count() > 490);
    }

    #[test]
    fn seeds_give_different_noise() {
        let differs = (0..20).any(|i| {
            let x = i as f32 * 0.3 + 0.1;
            (perlin(1, x, 0.5) - perlin(2, x, 0.5)).abs() > 0.05
        });
        assert!(differs);
    }
}
