//! Lines, powers and bells through points.

/// y = intercept + slope·x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Value at zero.
    pub intercept: f64,
    /// Rise per x.
    pub slope: f64,
}

/// The mean; not a number where there is nothing.
pub fn mean(values: impl IntoIterator<Item = f64>) -> f64 {
    let (sum, n) = values
        .into_iter()
        .fold((0.0, 0.0), |(sum, n), value| (sum + value, n + 1.0));
    sum / n
}

/// Standard deviation over mean.
pub fn variation(values: &[f64]) -> f64 {
    let mean_value = mean(values.iter().copied());
    mean(values.iter().map(|value| (value - mean_value).powi(2))).sqrt() / mean_value
}

/// The line of least squares.
pub fn line(points: impl IntoIterator<Item = (f64, f64)>) -> Line {
    let points: Vec<_> = points.into_iter().collect();
    let x0 = mean(points.iter().map(|p| p.0));
    let y0 = mean(points.iter().map(|p| p.1));
    let (mut xy, mut xx) = (0.0, 0.0);
    for (x, y) in points {
        xy += (x - x0) * (y - y0);
        xx += (x - x0) * (x - x0);
    }
    let slope = xy / xx;
    Line {
        intercept: y0 - slope * x0,
        slope,
    }
}

/// Exponent n of y ∝ xⁿ by least squares of the logarithms.
pub fn exponent(points: impl IntoIterator<Item = (f64, f64)>) -> f64 {
    line(points.into_iter().map(|(x, y)| (x.ln(), y.ln()))).slope
}

/// Height and half width b (to 1/e) of the bell height·e^(−((x − x₀)/b)²).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bell {
    /// Value at the middle.
    pub height: f64,
    /// Distance from the middle at which 1/e of it is left.
    pub width: f64,
    /// Where the middle is.
    pub middle: f64,
}

/// The bell through the points that are above a third of the highest one and
/// joined to it: a parabola of least squares through the logarithms, weighted
/// by the values squared, which is what noise that is the same everywhere asks.
pub fn bell(points: &[(f64, f64)]) -> Bell {
    let top = points
        .iter()
        .enumerate()
        .max_by(|a, b| a.1.1.total_cmp(&b.1.1))
        .map_or(0, |(at, _)| at);
    let least = points.get(top).map_or(0.0, |p| p.1) / 3.0;
    let above = |p: &&(f64, f64)| p.1 > least && p.1 > 0.0;
    let (left, right) = points.split_at(top.min(points.len()));
    let core: Vec<_> = left
        .iter()
        .rev()
        .take_while(above)
        .chain(right.iter().take_while(above))
        .copied()
        .collect();
    // Normal equations of ln y = a + bx + cx².
    let mut m = [[0.0; 4]; 3];
    for (x, y) in core {
        let (weight, powers) = (y * y, [1.0, x, x * x]);
        for (i, row) in m.iter_mut().enumerate() {
            for (j, power) in powers.iter().enumerate() {
                row[j] += weight * powers[i] * power;
            }
            row[3] += weight * powers[i] * y.ln();
        }
    }
    let [a, b, c] = solve(m);
    let middle = -b / (2.0 * c);
    Bell {
        height: (a - b * b / (4.0 * c)).exp(),
        width: (-1.0 / c).sqrt(),
        middle,
    }
}

/// Solves three linear equations by elimination with row exchange.
fn solve(mut m: [[f64; 4]; 3]) -> [f64; 3] {
    for i in 0..3 {
        let pivot = (i..3)
            .max_by(|&a, &b| m[a][i].abs().total_cmp(&m[b][i].abs()))
            .unwrap_or(i);
        m.swap(i, pivot);
        let row = m[i];
        for other in m.iter_mut().skip(i + 1) {
            let share = other[i] / row[i];
            for (value, above) in other.iter_mut().zip(row) {
                *value -= share * above;
            }
        }
    }
    let z = m[2][3] / m[2][2];
    let y = (m[1][3] - m[1][2] * z) / m[1][1];
    let x = (m[0][3] - m[0][2] * z - m[0][1] * y) / m[0][0];
    [x, y, z]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_found_through_noise() {
        let found = line((0..100).map(|i| {
            let x = f64::from(i);
            (x, 3.0 - 0.5 * x + if i % 2 == 0 { 0.1 } else { -0.1 })
        }));
        assert!((found.slope + 0.5).abs() < 1e-3);
        assert!((found.intercept - 3.0).abs() < 0.02);
    }

    #[test]
    fn a_power_law_gives_its_exponent() {
        let found = exponent((1..20).map(|i| (f64::from(i), 0.035 * f64::from(i).powf(2.0 / 3.0))));
        assert!((found - 2.0 / 3.0).abs() < 1e-9);
    }

    #[test]
    fn a_gaussian_is_found_with_a_return_flow() {
        let points: Vec<_> = (-50..50)
            .map(|i| {
                let x = f64::from(i) * 0.02;
                (x, 2.0 * (-((x - 0.05) / 0.3_f64).powi(2)).exp() - 0.01)
            })
            .collect();
        let found = bell(&points);
        assert!((found.height - 2.0).abs() < 0.03, "{found:?}");
        assert!((found.width - 0.3).abs() < 0.01, "{found:?}");
        assert!((found.middle - 0.05).abs() < 0.005, "{found:?}");
    }

    #[test]
    fn variation_of_a_swing() {
        assert!((variation(&[1.0, 3.0]) - 0.5).abs() < 1e-12);
        assert!(mean([]).is_nan());
    }
}
