//! A font of the letters that the browser draws: the panel has the face of the page around it, which no page may read
//! as a file.
//!
//! An outline goes where opacity is a half, between the middles of pixels: within a tenth of a pixel. Letters in the panel are a quarter as
//! large as their pictures, so that their corners are sharp.

/// The size of the letters in their pictures [px].
pub const EM: u32 = 64;

/// Columns and rows of a picture, and the origin of the letter in it, from the upper left corner [px].
pub const COLUMNS: u32 = 2 * EM;
/// See [`COLUMNS`].
pub const ROWS: u32 = 3 * EM / 2;
/// See [`COLUMNS`].
pub const ORIGIN: (u32, u32) = (EM / 4, 9 * EM / 8);

/// Units of the font in a pixel.
const UNITS: f32 = 16.0;

/// The opacity on an outline.
const HALF: f32 = 127.5;

/// A letter as it is drawn.
#[derive(Debug)]
pub struct Letter {
    /// Which letter.
    pub letter: char,
    /// The width that it takes in a line [px].
    pub advance: f32,
    /// Opacities, row by row from the top.
    pub picture: Vec<u8>,
}

/// The sides of squares between four samples, of a picture with an empty border: from each sample one across and one
/// down, which an outline may cross.
const WIDE: usize = COLUMNS as usize + 2;
const SIDES: usize = 2 * WIDE * (ROWS as usize + 2);

/// A TrueType font.
///
/// `letters` are in the order of their codes. `ascent` and `descent` are those of a line, up and down from its base
/// \[px\].
pub fn font(letters: &[Letter], ascent: f32, descent: f32) -> Vec<u8> {
    // The first glyph is that of unknown letters.
    let (mut glyphs, mut places) = (Bytes::default(), Bytes::default());
    places.longs(&[0, 0]);
    let mut metrics = Bytes::default();
    metrics.shorts(&[0, 0]);
    let mut map = Bytes::default();
    let count = letters.len() as u32;
    map.shorts(&[0, 1, 3, 10]);
    map.longs(&[12]);
    map.shorts(&[12, 0]);
    map.longs(&[16 + 12 * count, 0, count]);
    for (glyph, letter) in (1..).zip(letters) {
        glyphs.0.extend(glyph_of(&contours(&letter.picture)).0);
        places.longs(&[glyphs.0.len() as u32]);
        metrics.shorts(&[units(letter.advance), 0]);
        let code = u32::from(letter.letter);
        map.longs(&[code, code, glyph]);
    }
    let mut head = Bytes::default();
    head.longs(&[0x1_0000, 0x1_0000, 0, 0x5f0f_3cf5]);
    head.shorts(&[0, units(EM as f32)]);
    head.longs(&[0; 4]);
    // Offsets of glyphs have four bytes.
    head.shorts(&[0, 0, 0, 0, 0, 8, 2, 1, 0]);
    let mut line = Bytes::default();
    line.longs(&[0x1_0000]);
    line.shorts(&[units(ascent), -units(descent)]);
    line.shorts(&[0; 13]);
    line.shorts(&[count as i32 + 1]);
    let mut most = Bytes::default();
    most.longs(&[0x5000]);
    most.shorts(&[count as i32 + 1]);
    file(&[
        (b"cmap", map),
        (b"glyf", glyphs),
        (b"head", head),
        (b"hhea", line),
        (b"hmtx", metrics),
        (b"loca", places),
        (b"maxp", most),
    ])
}

/// A file of tables, in the order of their names.
fn file(tables: &[(&[u8; 4], Bytes)]) -> Vec<u8> {
    let mut file = Bytes::default();
    file.longs(&[0x1_0000]);
    // Nobody reads what helps to search the directory.
    file.shorts(&[tables.len() as i32, 0, 0, 0]);
    let mut at = 12 + 16 * tables.len();
    for (name, Bytes(table)) in tables {
        file.0.extend(*name);
        file.longs(&[0, at as u32, table.len() as u32]);
        at += table.len().next_multiple_of(4);
    }
    for (_, Bytes(table)) in tables {
        file.0.extend(table);
        file.0.resize(file.0.len().next_multiple_of(4), 0);
    }
    file.0
}

/// Numbers of a font, the highest byte first.
#[derive(Default)]
struct Bytes(Vec<u8>);

impl Bytes {
    fn longs(&mut self, values: &[u32]) {
        self.0
            .extend(values.iter().flat_map(|value| value.to_be_bytes()));
    }

    fn shorts(&mut self, values: &[i32]) {
        self.0.extend(
            values
                .iter()
                .flat_map(|&value| (value as i16).to_be_bytes()),
        );
    }
}

fn units(pixels: f32) -> i32 {
    (pixels * UNITS).round() as i32
}

/// The record of a glyph; nothing for a space.
fn glyph_of(contours: &[Vec<(i32, i32)>]) -> Bytes {
    let points: Vec<_> = contours.iter().flatten().copied().collect();
    let mut bytes = Bytes::default();
    let (Some(&first), false) = (points.first(), points.len() > usize::from(u16::MAX)) else {
        return bytes;
    };
    let least = points
        .iter()
        .fold(first, |a, b| (a.0.min(b.0), a.1.min(b.1)));
    let most = points
        .iter()
        .fold(first, |a, b| (a.0.max(b.0), a.1.max(b.1)));
    bytes.shorts(&[contours.len() as i32, least.0, least.1, most.0, most.1]);
    let mut end = -1;
    for contour in contours {
        end += contour.len() as i32;
        bytes.shorts(&[end]);
    }
    bytes.shorts(&[0]);
    // Each point is on the outline, and has two coordinates of two bytes.
    bytes.0.resize(bytes.0.len() + points.len(), 1);
    let steps = |axis: fn(&(i32, i32)) -> i32| {
        let before = std::iter::once(0).chain(points.iter().map(axis));
        let steps: Vec<_> = points
            .iter()
            .zip(before)
            .map(|(p, q)| axis(p) - q)
            .collect();
        steps
    };
    bytes.shorts(&steps(|point| point.0));
    bytes.shorts(&steps(|point| point.1));
    bytes.0.resize(bytes.0.len().next_multiple_of(4), 0);
    bytes
}

/// The closed lines around what is opaque, and, in the other direction, around holes.
fn contours(picture: &[u8]) -> Vec<Vec<(i32, i32)>> {
    let opacity = |x: usize, y: usize| {
        let inside = (1..WIDE - 1).contains(&x) && y > 0;
        let at = inside.then(|| (y - 1) * (WIDE - 2) + x - 1);
        at.and_then(|at| picture.get(at))
            .map_or(0.0, |&opacity| f32::from(opacity))
    };
    // The side that follows each on an outline; itself where there is none.
    let mut next: Vec<usize> = (0..SIDES).collect();
    for y in 0..SIDES / 2 / WIDE - 1 {
        for x in 0..WIDE - 1 {
            let corners = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)];
            let inside = corners.map(|(x, y)| opacity(x, y) > HALF);
            let crosses = |at: usize| (inside[at % 4], inside[(at + 1) % 4]);
            let first = 2 * (y * WIDE + x);
            let sides = [first, first + 3, first + 2 * WIDE, first + 1];
            for from in (0..4).filter(|&at| crosses(at) == (true, false)) {
                if let Some(to) = (from + 1..from + 4).find(|&at| crosses(at) == (false, true)) {
                    next[sides[from]] = sides[to % 4];
                }
            }
        }
    }
    let point = |side: usize| {
        let (x, y, down) = (side / 2 % WIDE, side / 2 / WIDE, side % 2);
        let (p, q) = (opacity(x, y), opacity(x + 1 - down, y + down));
        let share = (HALF - p) / (q - p);
        let (across, along) = (share * (1 - down) as f32, share * down as f32);
        (
            units(x as f32 + across - 0.5 - ORIGIN.0 as f32),
            units(ORIGIN.1 as f32 + 0.5 - y as f32 - along),
        )
    };
    let mut contours = Vec::new();
    for start in 0..SIDES {
        let mut contour = Vec::new();
        let mut at = start;
        while next[at] != at {
            contour.push(point(at));
            at = std::mem::replace(&mut next[at], at);
        }
        if !contour.is_empty() {
            contours.push(contour);
        }
    }
    contours
}

#[cfg(test)]
mod tests {
    use ab_glyph::{Font, FontVec};

    use super::*;

    /// A picture of what `is_in` says of points [px], with smooth edges.
    fn picture(is_in: impl Fn(f32, f32) -> bool) -> Vec<u8> {
        let opacity = |x: u32, y: u32| {
            let parts = (0..64).filter(|at| {
                let (dx, dy) = (at % 8, at / 8);
                is_in(
                    x as f32 + (dx as f32 + 0.5) / 8.0,
                    y as f32 + (dy as f32 + 0.5) / 8.0,
                )
            });
            (parts.count() as f32 * 255.0 / 64.0) as u8
        };
        let places = (0..ROWS).flat_map(|y| (0..COLUMNS).map(move |x| (x, y)));
        places.map(|(x, y)| opacity(x, y)).collect()
    }

    /// The pixels that a letter covers in a size, the sum of their opacity, and its bounds.
    fn drawn(font: &FontVec, letter: char, size: f32) -> (f32, ab_glyph::Rect) {
        let glyph = font.glyph_id(letter);
        let glyph = glyph.with_scale(size * font.height_unscaled() / 1024.0);
        let outlined = font
            .outline_glyph(glyph)
            .expect("the letter has an outline");
        let mut sum = 0.0;
        outlined.draw(|_, _, opacity| sum += opacity);
        (sum, outlined.px_bounds())
    }

    #[test]
    fn a_letter_covers_what_its_picture_covers_with_its_holes_in_its_place() {
        let (left, base) = (ORIGIN.0 as f32, ORIGIN.1 as f32);
        let ring =
            |x: f32, y: f32| (10.0..20.0).contains(&(x - left - 24.0).hypot(y - base + 22.0));
        let stem = |x: f32, y: f32| {
            (left + 4.3..left + 10.6).contains(&x) && (base - 48.0..base).contains(&y)
        };
        let letter = |letter, picture| Letter {
            letter,
            advance: 40.0,
            picture,
        };
        let letters = [
            letter(' ', picture(|_, _| false)),
            letter('l', picture(stem)),
            letter('o', picture(ring)),
            letter('ρ', picture(|x, y| ring(x, y) || stem(x, y))),
        ];
        let bytes = font(&letters, 60.0, 15.0);
        let font = FontVec::try_from_vec(bytes).expect("it is a font");
        assert_eq!(font.units_per_em(), Some(1024.0));
        assert_eq!(
            (font.ascent_unscaled(), font.descent_unscaled()),
            (960.0, -240.0)
        );
        assert_eq!(font.h_advance_unscaled(font.glyph_id('o')), 640.0);
        assert!(font.glyph_id('x').0 == 0 && font.glyph_id(' ').0 != 0);
        assert!(font.outline(font.glyph_id(' ')).is_none());
        // In its own size and in a quarter of it.
        for share in [1.0, 0.25] {
            let area = |letter| drawn(&font, letter, EM as f32 * share).0 / share / share;
            let ring = std::f32::consts::PI * (400.0 - 100.0);
            assert!((area('o') / ring - 1.0).abs() < 0.01, "{}", area('o'));
            assert!(
                (area('l') / (6.3 * 48.0) - 1.0).abs() < 0.04,
                "{}",
                area('l')
            );
        }
        let (_, bounds) = drawn(&font, 'l', EM as f32);
        assert_eq!((bounds.min.x, bounds.max.x), (4.0, 11.0));
        assert_eq!((bounds.min.y, bounds.max.y), (-48.0, 0.0));
    }

    #[test]
    fn a_picture_that_is_opaque_up_to_its_edge_has_an_outline() {
        let letters = [Letter {
            letter: 'm',
            advance: 1.0,
            picture: vec![255; (COLUMNS * ROWS) as usize],
        }];
        let font = FontVec::try_from_vec(font(&letters, 60.0, 15.0)).expect("it is a font");
        let (area, _) = drawn(&font, 'm', EM as f32);
        assert!((area / (COLUMNS * ROWS) as f32 - 1.0).abs() < 0.01);
    }
}
