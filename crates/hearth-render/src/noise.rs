//! The tile of gradient noise, computed once.
//!
//! Reading a small texture is far cheaper than computing noise per pixel. The tile repeats without
//! a visible edge.

use crate::constants::NOISE_LEVELS;

/// Texels along an edge of the tile.
pub const SIZE: usize = 1 << NOISE_LEVELS;
/// Lattice cells of the coarsest octave along an edge.
pub const CELLS: usize = 8;

/// Octaves of the channels, as lattice cells along an edge: three smooth channels and a fine one.
const OCTAVES: [&[usize]; 4] = [
    &[CELLS, 2 * CELLS, 4 * CELLS],
    &[CELLS, 2 * CELLS, 4 * CELLS],
    &[CELLS, 2 * CELLS, 4 * CELLS],
    &[2 * CELLS, 4 * CELLS],
];

/// Amplitude of an octave relative to the next coarser one.
const PERSISTENCE: f32 = 0.55;
/// Scale of the sum, which rarely exceeds ±0.8.
const CONTRAST: f32 = 1.2;

/// RGBA texels of the tile; 128 is zero.
pub fn tile() -> Vec<u8> {
    let mut texels = vec![0; SIZE * SIZE * 4];
    for (at, texel) in texels.iter_mut().enumerate() {
        let (channel, x, y) = (at % 4, at / 4 % SIZE, at / 4 / SIZE);
        let mut sum = 0.0;
        let mut amplitude = 1.0;
        for &cells in OCTAVES[channel] {
            let scale = cells as f32 / SIZE as f32;
            sum += amplitude * gradient_noise(x as f32 * scale, y as f32 * scale, cells, channel);
            amplitude *= PERSISTENCE;
        }
        *texel = (128.0 + 127.0 * (CONTRAST * sum).clamp(-1.0, 1.0)).round() as u8;
    }
    texels
}

/// Perlin noise on a lattice that repeats after `period` cells, about −0.7 to 0.7.
fn gradient_noise(x: f32, y: f32, period: usize, seed: usize) -> f32 {
    let (column, row) = (x.floor(), y.floor());
    let (fx, fy) = (x - column, y - row);
    let corner = |dx: usize, dy: usize| {
        let cell = ((row as usize + dy) % period) * period + (column as usize + dx) % period;
        let (x, y) = direction((cell * 4 + seed) as u32 ^ ((period as u32) << 16));
        x * (fx - dx as f32) + y * (fy - dy as f32)
    };
    let fade = |t: f32| t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
    let mix = |a: f32, b: f32, t: f32| a + (b - a) * t;
    mix(
        mix(corner(0, 0), corner(1, 0), fade(fx)),
        mix(corner(0, 1), corner(1, 1), fade(fx)),
        fade(fy),
    )
}

/// Direction of a lattice point by its number: towards a random point of a square. The hash
/// is Wang's.
fn direction(mut number: u32) -> (f32, f32) {
    number = (number ^ 61 ^ (number >> 16)).wrapping_mul(9);
    number = (number ^ (number >> 4)).wrapping_mul(0x27d4_eb2d);
    number ^= number >> 15;
    let side = |half: u32| half as f32 / 32_767.5 - 1.0;
    let (x, y) = (side(number & 0xffff), side(number >> 16));
    let length = (x * x + y * y).sqrt().max(1e-6);
    (x / length, y / length)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(texels: &[u8], x: usize, y: usize, channel: usize) -> f32 {
        f32::from(texels[((y % SIZE) * SIZE + x % SIZE) * 4 + channel])
    }

    #[test]
    fn the_tile_repeats_without_a_visible_edge() {
        let texels = tile();
        for channel in 0..4 {
            let jump = |from: usize, to: usize| {
                (0..SIZE)
                    .map(|k| {
                        (at(&texels, from, k, channel) - at(&texels, to, k, channel)).abs()
                            + (at(&texels, k, from, channel) - at(&texels, k, to, channel)).abs()
                    })
                    .sum::<f32>()
            };
            let inside: f32 = (0..SIZE - 1).map(|k| jump(k, k + 1)).sum();
            assert!(jump(SIZE - 1, SIZE) < 2.0 * inside / (SIZE - 1) as f32);
        }
    }

    #[test]
    fn the_mean_is_zero_and_the_contrast_high() {
        let texels = tile();
        for channel in 0..4 {
            let values = || (0..SIZE * SIZE).map(|k| at(&texels, k % SIZE, k / SIZE, channel));
            let mean = values().sum::<f32>() / (SIZE * SIZE) as f32;
            let spread = values().map(|v| (v - mean).powi(2)).sum::<f32>() / (SIZE * SIZE) as f32;
            assert!((mean - 128.0).abs() < 8.0, "mean {mean}");
            assert!(spread.sqrt() > 20.0, "spread {}", spread.sqrt());
        }
    }
}
