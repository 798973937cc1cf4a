//! Animated GIF: one palette of all pictures, and an ordered dither, which does not crawl from picture to picture as
//! diffused errors do.

use gif::{DisposalMethod, Encoder as GifEncoder, Extension, Frame, Repeat};
use quantette::deps::palette::Srgb;
use quantette::{PaletteSize, Pipeline};

use super::{Encoder, Header, Plays};
use crate::error::Error;
use crate::output::Output;
use crate::picture::Picture;

/// Times are in hundredths of a second.
const PER_SECOND: f64 = 100.0;
/// Colours of the palette. One more entry is transparent.
const COLOURS: u8 = 255;
const TRANSPARENT: u8 = COLOURS;
/// Every so many pixels, one counts for the palette.
const STRIDE: usize = 7;
/// Alpha from which a pixel is opaque.
const OPAQUE: u8 = 128;
/// Side of the matrix of thresholds, B. E. Bayer, 1973, and the distance of the colours between which it chooses.
const SIDE: usize = 8;
const SPREAD: f32 = 20.0;
/// Bits of a channel in the table of nearest colours.
const BITS: u32 = 5;

/// Keeps all pictures, since the palette follows from them.
pub struct Gif {
    output: Output,
    header: Header,
    pictures: Vec<Picture>,
}

impl Gif {
    pub fn new(output: Output, header: Header) -> Gif {
        Gif {
            output,
            header,
            pictures: Vec::new(),
        }
    }
}

fn failed(error: gif::EncodingError) -> Error {
    Error::at("GIF", error)
}

impl Encoder for Gif {
    fn add(&mut self, picture: &Picture) -> Result<(), Error> {
        self.pictures.push(picture.clone());
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<(), Error> {
        let side = |side: u32| u16::try_from(side).map_err(|_| too_large(self.header.size));
        let [width, height] = self.header.size;
        let (width, height) = (side(width)?, side(height)?);
        let palette = Palette::of(&self.pictures);
        let mut file = Vec::new();
        let mut encoder =
            GifEncoder::new(&mut file, width, height, &palette.colours.concat()).map_err(failed)?;
        if self.header.plays == Plays::Forever {
            encoder.set_repeat(Repeat::Infinite).map_err(failed)?;
        }
        if let Some(text) = &self.header.text {
            let comment = Extension::Comment.into();
            let written = encoder.write_raw_extension(comment, &[text.as_bytes()]);
            written.map_err(|error| Error::at("GIF", error))?;
        }
        let time = |number: usize| self.header.rate.ticks(number as u32, PER_SECOND);
        for (number, picture) in self.pictures.iter().enumerate() {
            let frame = Frame {
                width,
                height,
                delay: (time(number + 1) - time(number)) as u16,
                dispose: DisposalMethod::Background,
                transparent: Some(TRANSPARENT),
                buffer: palette.indices(picture).into(),
                ..Frame::default()
            };
            encoder.write_frame(&frame).map_err(failed)?;
        }
        drop(encoder);
        self.output.write(&file)
    }
}

fn too_large([width, height]: [u32; 2]) -> Error {
    Error::Use(format!(
        "a GIF has at most 65535 x 65535 pixels, and the film has {width} x {height}"
    ))
}

/// The colours of a film.
struct Palette {
    colours: Vec<[u8; 3]>,
    /// The index of the nearest colour for each colour of few bits.
    nearest: Vec<u8>,
}

impl Palette {
    fn of(pictures: &[Picture]) -> Palette {
        let pixels = pictures.iter().flat_map(Picture::straight_pixels);
        let seen = pixels.step_by(STRIDE).filter(|pixel| pixel[3] >= OPAQUE);
        let seen: Vec<_> = seen.map(|[r, g, b, _]| Srgb::new(r, g, b)).collect();
        let size = PaletteSize::from_u8_clamped(COLOURS);
        // There are fewer pixels than the library has room for, and at least one.
        let seen = if seen.is_empty() {
            vec![Srgb::new(0, 0, 0)]
        } else {
            seen
        };
        let found = Pipeline::new().palette_size(size).input_slice(&seen);
        let found = found.map(|pipeline| pipeline.output_srgb8_palette().into_vec());
        let mut colours: Vec<[u8; 3]> = found
            .unwrap_or_default()
            .into_iter()
            .map(
                |Srgb {
                     red, green, blue, ..
                 }| [red, green, blue],
            )
            .collect();
        // A stable order gives the same bytes.
        colours.sort_unstable();
        colours.resize(usize::from(COLOURS) + 1, [0; 3]);
        let side = 1_usize << BITS;
        let level = |at: usize| ((at as f32 + 0.5) * 256.0 / side as f32) as i32;
        let nearest = (0..side * side * side).map(|at| {
            let colour = [at / side / side, at / side % side, at % side].map(level);
            let distance = |known: &[u8; 3]| -> i32 {
                let channels = known.iter().zip(colour);
                channels
                    .map(|(&known, wanted)| (i32::from(known) - wanted).pow(2))
                    .sum()
            };
            let known = colours.iter().take(COLOURS.into()).zip(0_u8..);
            known
                .min_by_key(|(known, _)| distance(known))
                .map_or(0, |(_, index)| index)
        });
        let nearest = nearest.collect();
        Palette { colours, nearest }
    }

    /// The indices of a picture's pixels.
    fn indices(&self, picture: &Picture) -> Vec<u8> {
        let width = picture.width.max(1) as usize;
        let pixels = picture.straight_pixels().enumerate();
        pixels
            .map(|(at, [r, g, b, alpha])| {
                if alpha < OPAQUE {
                    return TRANSPARENT;
                }
                let offset = (threshold(at % width, at / width) - 0.5) * SPREAD;
                let [r, g, b] = [r, g, b].map(|channel| {
                    let shifted = (f32::from(channel) + offset).clamp(0.0, 255.0);
                    (shifted as usize) >> (8 - BITS)
                });
                let at = (r << (2 * BITS)) | (g << BITS) | b;
                self.nearest.get(at).copied().unwrap_or(0)
            })
            .collect()
    }
}

/// The threshold of a pixel, from 0 to 1.
fn threshold(x: usize, y: usize) -> f32 {
    let (x, y) = (x % SIDE, y % SIDE);
    let bit = |number: usize, at: usize| (number >> at) & 1;
    let bits = (0..3).map(|at| {
        let weight = 4 - 2 * at;
        (bit(x ^ y, at) << (weight + 1)) | (bit(y, at) << weight)
    });
    bits.sum::<usize>() as f32 / (SIDE * SIDE) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_has_each_threshold_once() {
        let mut all: Vec<_> = (0..SIDE * SIDE)
            .map(|at| (threshold(at % SIDE, at / SIDE) * 64.0) as usize)
            .collect();
        all.sort_unstable();
        assert_eq!(all, (0..64).collect::<Vec<_>>());
    }

    #[test]
    fn a_dithered_grey_has_the_mean_of_its_light_and_transparent_pixels_stay_so() {
        let grey = |value: u8| Picture::premultiplied(8, 8, [value, value, value, 255].repeat(64));
        let clear = Picture::premultiplied(8, 8, vec![0; 256]);
        let palette = Palette::of(&[grey(40), grey(56), clear.clone()]);
        let indices = palette.indices(&grey(48));
        let shown = indices
            .iter()
            .map(|&index| f32::from(palette.colours[usize::from(index)][0]));
        let mean = shown.sum::<f32>() / 64.0;
        assert!((mean - 48.0).abs() < 3.0, "{mean}");
        assert!(
            palette
                .indices(&clear)
                .iter()
                .all(|&index| index == TRANSPARENT)
        );
    }
}
