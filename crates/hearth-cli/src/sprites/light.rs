//! Which part of the motion of the gas its light follows. A sheet of flame can stand while gas flows through it, and the
//! fine structure fades as it moves: of the vectors near the path of the gas, the one is taken that leads to the next
//! picture.

use crate::picture::Picture;

/// Shares of the path of the gas, and what is added to them along each axis \[pixels\]. The first that fits counts.
const SHARES: [f32; 6] = [1.0, 0.75, 0.5, 0.25, 0.0, 1.25];
const OFFSETS: [f32; 5] = [0.0, -1.0, 1.0, -2.0, 2.0];
/// Pixels to each side over which pictures are compared, and over which vectors are averaged.
const NEAR: usize = 2;

/// The motion of the light from a picture to the next one, near vectors of the gas. Both pictures have one size.
pub fn followed(gas: &[[f32; 2]], before: &Picture, after: &Picture) -> Vec<[f32; 2]> {
    let width = before.width as usize;
    let [from, to] = [before, after].map(|picture| {
        let pixels = picture.pixels().map(|pixel| pixel.map(f32::from));
        pixels.collect::<Vec<_>>()
    });
    let mut least = vec![f32::MAX; gas.len()];
    let mut best = gas.to_vec();
    for share in SHARES {
        for (x, y) in OFFSETS.iter().flat_map(|y| OFFSETS.map(|x| (x, *y))) {
            let vector = |[u, v]: [f32; 2]| [u * share + x, v * share + y];
            let errors = gas.iter().zip(&to).enumerate().map(|(at, (gas, wanted))| {
                let moved = sample(&from, width, at, vector(*gas));
                let parts = moved.iter().zip(wanted);
                parts.map(|(a, b)| (a - b).abs()).sum::<f32>()
            });
            let errors = near_mean(&errors.collect::<Vec<_>>(), width);
            for (((least, best), error), gas) in
                least.iter_mut().zip(&mut best).zip(errors).zip(gas)
            {
                if error < *least {
                    (*least, *best) = (error, vector(*gas));
                }
            }
        }
    }
    let [x, y] = [0, 1].map(|axis| {
        let all: Vec<_> = best.iter().map(|vector| vector[axis]).collect();
        near_mean(&all, width)
    });
    x.into_iter().zip(y).map(|(x, y)| [x, y]).collect()
}

/// What was at a pixel before it moved by a vector, between the four nearest pixels.
fn sample(pixels: &[[f32; 4]], width: usize, at: usize, [u, v]: [f32; 2]) -> [f32; 4] {
    let height = pixels.len() / width;
    let side = |place: usize, moved: f32, length: usize| {
        let place = (place as f32 - moved).clamp(0.0, length as f32 - 1.0);
        let low = (place as usize).min(length.saturating_sub(2));
        (low, place - low as f32)
    };
    let ((x, right), (y, down)) = (side(at % width, u, width), side(at / width, v, height));
    let mut sum = [0.0; 4];
    for (step, share) in [
        (0, (1.0 - right) * (1.0 - down)),
        (1, right * (1.0 - down)),
        (width, (1.0 - right) * down),
        (width + 1, right * down),
    ] {
        let pixel = pixels.get(y * width + x + step).copied();
        let pixel = pixel.unwrap_or_default();
        sum.iter_mut()
            .zip(pixel)
            .for_each(|(sum, part)| *sum += share * part);
    }
    sum
}

/// The mean of the numbers around each of rows of that width.
fn near_mean(numbers: &[f32], width: usize) -> Vec<f32> {
    let along = |numbers: &[f32], step: usize, count: usize| -> Vec<f32> {
        let mean = |at: usize| {
            let place = at / step % count;
            let (low, high) = (place.saturating_sub(NEAR), (place + NEAR).min(count - 1));
            let all = (low..=high).filter_map(|near| numbers.get(at - place * step + near * step));
            all.sum::<f32>() / (high + 1 - low) as f32
        };
        (0..numbers.len()).map(mean).collect()
    };
    let rows = along(numbers, 1, width);
    along(&rows, width, numbers.len() / width)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square of light whose left edge is in that column.
    fn square(column: u32) -> Picture {
        let lit =
            |at: u32| (column..column + 6).contains(&(at % 24)) && (6..12).contains(&(at / 24));
        let pixel = |at: u32| [if lit(at) { 255 } else { 0 }; 4];
        Picture::premultiplied(24, 18, (0..24 * 18).flat_map(pixel).collect())
    }

    #[test]
    fn light_that_stands_in_gas_that_flows_has_no_motion_and_light_that_moves_has_that_of_the_gas()
    {
        let gas = vec![[4.0, 0.0]; 24 * 18];
        let middle = |column: u32| 8 * 24 + column as usize + 3;
        let stands = followed(&gas, &square(8), &square(8));
        let moves = followed(&gas, &square(8), &square(12));
        assert!(stands[middle(8)][0].abs() < 2.5, "{:?}", stands[middle(8)]);
        assert!(
            (moves[middle(12)][0] - 4.0).abs() < 0.5,
            "{:?}",
            moves[middle(12)]
        );
        // Where nothing is seen, the gas counts.
        assert_eq!(moves[0], [4.0, 0.0]);
    }
}
