//! Pictures in memory, and as PNG.

use std::io;

use crate::error::Error;

/// Distance to which the colour of the fire continues where nothing is seen \[pixels\].
const BLED_PIXELS: u32 = 8;

/// A picture: premultiplied sRGB and alpha, from its upper left.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    rgba: Vec<u8>,
}

impl Picture {
    /// A picture of pixels in rows from the upper left. Missing ones are transparent.
    pub fn premultiplied(width: u32, height: u32, mut rgba: Vec<u8>) -> Picture {
        rgba.resize(width as usize * height as usize * 4, 0);
        Picture {
            width,
            height,
            rgba,
        }
    }

    /// Its pixels: premultiplied red, green, blue, and alpha.
    pub fn pixels(&self) -> impl Iterator<Item = [u8; 4]> {
        let (pixels, _) = self.rgba.as_chunks::<4>();
        pixels.iter().copied()
    }

    /// Its pixels with straight alpha.
    pub fn straight_pixels(&self) -> impl Iterator<Item = [u8; 4]> {
        self.pixels().map(straight)
    }

    /// The bytes of its pixels with straight alpha.
    pub fn straight(&self) -> Vec<u8> {
        self.straight_pixels().flatten().collect()
    }

    /// As [`straight`](Picture::straight), with the colour of near pixels where nothing is seen. An encoder with loss
    /// or a texture filter mixes that colour into the edge of the fire.
    pub fn bled(&self) -> Vec<u8> {
        let mut pixels: Vec<_> = self.straight_pixels().collect();
        let width = self.width as usize;
        let mut known: Vec<_> = pixels.iter().map(|pixel| pixel[3] > 0).collect();
        for _ in 0..BLED_PIXELS {
            let mut found = Vec::new();
            for (at, _) in known.iter().enumerate().filter(|(_, known)| !**known) {
                let (mut sum, mut count) = ([0; 3], 0);
                let column = at % width;
                let sides = [
                    (column > 0).then(|| at - 1),
                    (column + 1 < width).then_some(at + 1),
                    at.checked_sub(width),
                    Some(at + width),
                ];
                for near in sides.into_iter().flatten() {
                    if let (Some(true), Some([r, g, b, _])) = (known.get(near), pixels.get(near)) {
                        sum.iter_mut()
                            .zip([r, g, b])
                            .for_each(|(sum, part)| *sum += u32::from(*part));
                        count += 1;
                    }
                }
                if count > 0 {
                    found.push((at, sum.map(|sum| (sum / count) as u8)));
                }
            }
            if found.is_empty() {
                break;
            }
            for (at, [r, g, b]) in found {
                pixels[at] = [r, g, b, 0];
                known[at] = true;
            }
        }
        pixels.concat()
    }

    /// As [`bled`](Picture::bled), opaque, and below it alpha as a grey.
    pub fn stacked(&self) -> Vec<u8> {
        let mut rgba = self.bled();
        for alpha in rgba.iter_mut().skip(3).step_by(4) {
            *alpha = 255;
        }
        rgba.extend(
            self.pixels()
                .flat_map(|[.., alpha]| [alpha, alpha, alpha, 255]),
        );
        rgba
    }

    /// The mean of the light of pictures of one size, weighted by alpha.
    pub fn mean(pictures: &[Picture]) -> Option<Picture> {
        let (first, count) = (pictures.first()?, pictures.len());
        if count == 1 {
            return Some(first.clone());
        }
        let linear = LinearTable::new();
        let mut sums = vec![[0.0; 4]; first.rgba.len() / 4];
        for picture in pictures {
            for (sum, pixel) in sums.iter_mut().zip(picture.pixels()) {
                let light = linear.light(pixel);
                sum.iter_mut()
                    .zip(light)
                    .for_each(|(sum, part)| *sum += part);
            }
        }
        let mean = sums
            .iter()
            .flat_map(|sum| encoded(sum.map(|sum| sum / count as f32)));
        Some(Picture::premultiplied(
            first.width,
            first.height,
            mean.collect(),
        ))
    }

    /// The mix of the light of two pictures of one size, with that share of the other one, weighted by alpha.
    pub fn mixed(&self, other: &Picture, share: f32) -> Picture {
        let linear = LinearTable::new();
        let pixels = self.pixels().zip(other.pixels()).flat_map(|(a, b)| {
            let (a, b) = (linear.light(a), linear.light(b));
            encoded([0, 1, 2, 3].map(|at| a[at] + share * (b[at] - a[at])))
        });
        Picture::premultiplied(self.width, self.height, pixels.collect())
    }

    /// The sum of the differences of all channels from a picture of the same size.
    pub fn distance(&self, other: &Picture) -> u64 {
        let pairs = self.rgba.iter().zip(&other.rgba);
        pairs.map(|(a, b)| u64::from(a.abs_diff(*b))).sum()
    }

    /// The picture with one pixel for each square of `factor` by `factor`: the mean of their light,
    /// weighted by alpha, so that transparent edges stay as bright as what they belong to.
    pub fn downsampled(self, factor: u32) -> Picture {
        if factor <= 1 {
            return self;
        }
        let linear = LinearTable::new();
        let (width, height) = (self.width / factor, self.height / factor);
        let mut rgba = Vec::with_capacity(width as usize * height as usize * 4);
        let count = (factor * factor) as f32;
        let (columns, factor) = (self.width as usize, factor as usize);
        let (pixels, _) = self.rgba.as_chunks::<4>();
        for y in 0..height as usize {
            for x in 0..width as usize {
                let mut sum = [0.0; 4];
                for row in 0..factor {
                    let start = (y * factor + row) * columns + x * factor;
                    for pixel in pixels.iter().skip(start).take(factor) {
                        let light = linear.light(*pixel);
                        sum.iter_mut()
                            .zip(light)
                            .for_each(|(sum, part)| *sum += part);
                    }
                }
                rgba.extend(encoded(sum.map(|sum| sum / count)));
            }
        }
        Picture::premultiplied(width, height, rgba)
    }

    /// A PNG file, which states that its colours are sRGB, with a text about the fire. Its alpha is straight, as the
    /// format asks; an opaque picture has none.
    ///
    /// # Errors
    /// The picture is too large for memory.
    pub fn png(&self, text: Option<&str>) -> Result<Vec<u8>, Error> {
        let size = [self.width, self.height];
        if self.pixels().all(|pixel| pixel[3] == 255) {
            let rgb: Vec<u8> = self.pixels().flat_map(|[r, g, b, _]| [r, g, b]).collect();
            return png(size, png::ColorType::Rgb, &rgb, text);
        }
        png(size, png::ColorType::Rgba, &self.straight(), text)
    }
}

/// An opaque picture as PNG.
///
/// # Errors
/// The picture is too large for memory.
pub fn png_of_rgb(width: u32, height: u32, rgb: &[u8]) -> Result<Vec<u8>, Error> {
    png([width, height], png::ColorType::Rgb, rgb, None)
}

/// Bytes of red, green, blue and alpha as PNG.
///
/// # Errors
/// The picture is too large for memory.
pub fn png_of_rgba(size: [u32; 2], rgba: &[u8]) -> Result<Vec<u8>, Error> {
    png(size, png::ColorType::Rgba, rgba, None)
}

/// Adds a text about the fire to a PNG, under the keyword `hearth`.
pub fn describe<W: io::Write>(
    encoder: &mut png::Encoder<'_, W>,
    text: Option<&str>,
) -> Result<(), png::EncodingError> {
    text.map_or(Ok(()), |text| {
        encoder.add_itxt_chunk("hearth".to_owned(), text.to_owned())
    })
}

fn png(
    [width, height]: [u32; 2],
    colours: png::ColorType,
    data: &[u8],
    text: Option<&str>,
) -> Result<Vec<u8>, Error> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, width, height);
    encoder.set_color(colours);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let described = describe(&mut encoder, text);
    let written = described.and_then(|()| encoder.write_header());
    let written = written.and_then(|mut writer| {
        writer.write_image_data(data)?;
        writer.finish()
    });
    written.map_err(|error| Error::at("PNG", error))?;
    Ok(file)
}

/// A pixel over an opaque colour.
pub fn blended([r, g, b, a]: [u8; 4], colour: [u8; 3]) -> [u8; 3] {
    let behind = 255 - u32::from(a);
    let over = |front: u8, back: u8| {
        (u32::from(front) + (u32::from(back) * behind + 127) / 255).min(255) as u8
    };
    [over(r, colour[0]), over(g, colour[1]), over(b, colour[2])]
}

/// A premultiplied pixel with straight alpha.
fn straight([r, g, b, a]: [u8; 4]) -> [u8; 4] {
    let alpha = u32::from(a);
    let channel = |premultiplied: u8| match alpha {
        0 => 0,
        _ => ((u32::from(premultiplied) * 255 + alpha / 2) / alpha).min(255) as u8,
    };
    [channel(r), channel(g), channel(b), a]
}

/// Linear light of each eight-bit sRGB value.
struct LinearTable([f32; 256]);

impl LinearTable {
    fn new() -> LinearTable {
        let mut table = [0.0; 256];
        for (value, linear) in table.iter_mut().enumerate() {
            *linear = decoded(value as f32 / 255.0);
        }
        LinearTable(table)
    }

    /// Linear light of a pixel, premultiplied, and its alpha.
    fn light(&self, pixel: [u8; 4]) -> [f32; 4] {
        let [r, g, b, a] = straight(pixel);
        let alpha = f32::from(a) / 255.0;
        let [r, g, b] = [r, g, b].map(|value| self.0[usize::from(value)] * alpha);
        [r, g, b, alpha]
    }
}

/// Linear light as a premultiplied sRGB pixel.
fn encoded([r, g, b, alpha]: [f32; 4]) -> [u8; 4] {
    let byte = |value: f32| (value * 255.0 + 0.5) as u8;
    if alpha <= 0.0 {
        return [0; 4];
    }
    let [r, g, b] = [r, g, b].map(|light| byte(srgb(light / alpha) * alpha));
    [r, g, b, byte(alpha)]
}

/// The transfer function of sRGB, from the value to the light.
fn decoded(value: f32) -> f32 {
    match value {
        ..=0.040_45 => value / 12.92,
        _ => ((value + 0.055) / 1.055).powf(2.4),
    }
}

/// The transfer function of sRGB, from the light to the value.
fn srgb(light: f32) -> f32 {
    match light {
        ..=0.003_130_8 => 12.92 * light,
        _ => 1.055 * light.min(1.0).powf(1.0 / 2.4) - 0.055,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_transparent_edge_keeps_the_colour_of_what_it_belongs_to() {
        let picture = Picture::premultiplied(
            2,
            2,
            vec![
                200, 100, 50, 255, 0, 0, 0, 0, //
                200, 100, 50, 255, 0, 0, 0, 0,
            ],
        );
        let pixels: Vec<_> = picture.downsampled(2).pixels().map(straight).collect();
        let [[r, g, b, a]] = pixels[..] else {
            panic!("{pixels:?}");
        };
        assert_eq!(a, 128);
        for (value, expected) in [(r, 200_u8), (g, 100), (b, 50)] {
            assert!(value.abs_diff(expected) <= 1, "{pixels:?}");
        }
    }

    #[test]
    fn light_is_averaged_and_not_its_code() {
        let picture = Picture::premultiplied(2, 2, [[255; 4], [0, 0, 0, 255]].repeat(2).concat());
        let grey = picture.downsampled(2).pixels().next();
        // Half of the light is the value 188.
        assert_eq!(grey, Some([188, 188, 188, 255]));
    }

    #[test]
    fn the_mean_of_pictures_is_that_of_their_light() {
        let picture = |pixel: [u8; 4]| Picture::premultiplied(1, 1, pixel.to_vec());
        let mean = Picture::mean(&[picture([255; 4]), picture([0, 0, 0, 255])]);
        assert_eq!(mean, Some(picture([188, 188, 188, 255])));
        assert_eq!(Picture::mean(&[]), None);
        let mixed = picture([0, 0, 0, 255]).mixed(&picture([255; 4]), 0.5);
        assert_eq!(mixed, picture([188, 188, 188, 255]));
    }

    #[test]
    fn the_colour_of_an_edge_goes_on_where_nothing_is_seen_and_alpha_stays() {
        let row = [[0; 4], [0; 4], [90, 60, 30, 255], [0; 4]].concat();
        let bled = Picture::premultiplied(4, 1, row).bled();
        let (pixels, _) = bled.as_chunks::<4>();
        let [r, g, b] = [90, 60, 30];
        assert_eq!(
            pixels,
            [[r, g, b, 0], [r, g, b, 0], [r, g, b, 255], [r, g, b, 0]]
        );
    }

    #[test]
    fn every_grey_survives_both_transfer_functions() {
        let table = LinearTable::new();
        for value in 0..=255 {
            let pixel = [value, value, value, 255];
            assert_eq!(encoded(table.light(pixel)), pixel);
        }
    }

    #[test]
    fn an_opaque_pixel_hides_what_is_behind_it() {
        assert_eq!(blended([1, 2, 3, 255], [200; 3]), [1, 2, 3]);
        assert_eq!(blended([0; 4], [200, 100, 0]), [200, 100, 0]);
    }
}
