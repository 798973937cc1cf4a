//! The outlines of solids: points and masks, each written as one text.
//!
//! A text travels through attributes, JSON, links and messages as it is. Points have the form of
//! SVG's attribute `points`. A mask starts with its size, as in `64x32:`, and a letter per run of
//! pixels follows, row by row from the upper left: see [`Mask`].

use std::sync::Arc;

use glam::Vec2;

use super::decimal::{self, Decimal};

/// Most points of an outline, and least.
const MOST_POINTS: usize = 256;
const LEAST_POINTS: usize = 2;
/// Largest coordinate of a point \[m\].
const FARTHEST: f64 = 10.0;
/// Smallest coordinate that is not 0 \[m\].
const SMALLEST: f64 = 1e-6;
/// Longest text of points, in bytes: JavaScript writes a number in at most 25, and a letter follows it.
const LONGEST: usize = MOST_POINTS * 2 * 26;
/// Most pixels of a side of a mask.
const MOST_PIXELS: usize = 256;
/// The opacity of an opaque pixel.
const OPAQUE: u8 = 15;
/// The letters of a mask, by their value.
const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
/// Values from which on a letter is a run of transparent and of opaque pixels.
const TRANSPARENT_RUN: usize = 16;
const OPAQUE_RUN: usize = 40;
/// Runs that differ by a pixel in length; the others double.
const SHORT_RUNS: usize = 16;

/// A value that is written as a text.
pub(super) trait FromText {
    /// Reads a text. Returns whether it has the right form; if not, nothing changes.
    fn read(&mut self, text: &str) -> bool;
}

/// The points of a polygon or a stroke.
#[derive(Clone, Debug, PartialEq)]
pub struct Points(Arc<(String, Vec<Vec2>)>);

/// The opacity of the pixels of a mask.
///
/// A letter is a value of the alphabet of base64url. Values below 16 are the opacity of one pixel;
/// 16 to 39 are runs of transparent pixels and 40 to 63 are runs of opaque ones, of 2 to 17 and
/// 32, 64, … 4096 pixels.
#[derive(Clone, Debug, PartialEq)]
pub struct Mask(Arc<(String, Pixels)>);

/// Decoded pixels.
#[derive(Clone, Debug, Default, PartialEq)]
struct Pixels {
    width: usize,
    opacity: Vec<u8>,
}

impl Points {
    /// The text of new points: a triangle.
    pub const DEFAULT: &str = "-0.1,-0.1 0.1,-0.1 0,0.1";
    /// The required form.
    pub const FORM: &str = "2 to 256 pairs of numbers from -10 to 10 m, such as \"0,0.1 0.2,-0.1\"";

    /// Every point \[m\], relative to the centre of the solid.
    pub fn all(&self) -> &[Vec2] {
        &self.0.1
    }

    /// The text: pairs with a comma between their numbers and a space between pairs.
    pub fn text(&self) -> &str {
        &self.0.0
    }

    fn parse(text: &str) -> Option<Points> {
        if text.len() > LONGEST {
            return None;
        }
        let is_between = |letter: char| letter == ',' || letter.is_ascii_whitespace();
        let words = text.split(is_between).filter(|word| !word.is_empty());
        let (mut points, mut x) = (Vec::new(), None);
        for word in words {
            let number = decimal::parse(word).filter(|number| number.abs() <= FARTHEST)?;
            // −0 + 0 is 0. Texts have four digits of what is smaller.
            let number = if number.abs() < SMALLEST {
                0.0
            } else {
                number as f32 + 0.0
            };
            match x.take() {
                None => x = Some(number),
                Some(x) => points.push(Vec2::new(x, number)),
            }
            if points.len() > MOST_POINTS {
                return None;
            }
        }
        if x.is_some() || points.len() < LEAST_POINTS {
            return None;
        }
        let mut text = String::new();
        for point in &points {
            let space = if text.is_empty() { "" } else { " " };
            let [x, y] = point.to_array().map(|x| Decimal(decimal::shortest(x)));
            text.push_str(&format!("{space}{x},{y}"));
        }
        Some(Points(Arc::new((text, points))))
    }
}

impl Mask {
    /// The text of a new mask: a square.
    pub const DEFAULT: &str = "16x16:7";
    /// The required form.
    pub const FORM: &str = "the text of a mask of at most 256 × 256 pixels that is opaque somewhere, \
                            as hearth-fire/mask makes it";

    /// Pixels across and up.
    pub fn size(&self) -> [usize; 2] {
        let Pixels { width, opacity } = &self.0.1;
        [*width, opacity.len() / (*width).max(1)]
    }

    /// Number of pixels of a mask that is not the default.
    pub fn pixels(&self) -> usize {
        let [width, height] = self.size();
        if self.text() == Mask::DEFAULT {
            0
        } else {
            width * height
        }
    }

    /// The opacity of a pixel, 0–1, counted from the upper left; 0 beyond the mask.
    pub fn opacity(&self, column: usize, row: usize) -> f32 {
        let Pixels { width, opacity } = &self.0.1;
        let pixel = opacity.get(row.wrapping_mul(*width).wrapping_add(column));
        match pixel {
            Some(&pixel) if column < *width => f32::from(pixel) / f32::from(OPAQUE),
            _ => 0.0,
        }
    }

    /// The text.
    pub fn text(&self) -> &str {
        &self.0.0
    }

    fn parse(text: &str) -> Option<Mask> {
        let (size, letters) = text.split_once(':')?;
        let (width, height) = size.split_once('x')?;
        let [width, height] = [width, height].map(|side| {
            let side = decimal::parse(side).unwrap_or_default();
            let whole = side as usize;
            if whole as f64 == side && whole <= MOST_PIXELS {
                whole
            } else {
                0
            }
        });
        let mut opacity = Vec::new();
        let mut is_solid = false;
        for letter in letters.bytes() {
            let value = LETTERS.iter().position(|known| *known == letter)?;
            let (pixel, run) = match value {
                OPAQUE_RUN.. => (OPAQUE, run(value - OPAQUE_RUN)),
                TRANSPARENT_RUN.. => (0, run(value - TRANSPARENT_RUN)),
                _ => (value as u8, 1),
            };
            is_solid |= pixel > OPAQUE / 2;
            if opacity.len() + run > width * height {
                return None;
            }
            for _ in 0..run {
                opacity.push(pixel);
            }
        }
        (is_solid && opacity.len() == width * height)
            .then(|| Mask(Arc::new((text.to_owned(), Pixels { width, opacity }))))
    }
}

/// The length of a run.
fn run(number: usize) -> usize {
    match number {
        0..SHORT_RUNS => number + 2,
        _ => 32 << (number - SHORT_RUNS),
    }
}

impl FromText for Points {
    fn read(&mut self, text: &str) -> bool {
        Points::parse(text).map(|read| *self = read).is_some()
    }
}

impl FromText for Mask {
    fn read(&mut self, text: &str) -> bool {
        Mask::parse(text).map(|read| *self = read).is_some()
    }
}

impl Default for Points {
    fn default() -> Points {
        let points = Points::parse(Points::DEFAULT);
        points.unwrap_or_else(|| Points(Arc::default()))
    }
}

impl Default for Mask {
    fn default() -> Mask {
        Mask::parse(Mask::DEFAULT).unwrap_or_else(|| Mask(Arc::default()))
    }
}

#[cfg(test)]
mod tests;
