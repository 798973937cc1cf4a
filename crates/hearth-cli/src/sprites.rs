//! Sprite sheets: the pictures of a film as tiles of one picture, for game engines.

pub mod atlas;
pub mod light;
pub mod motion;

use crate::error::Error;
use crate::picture::Picture;

/// Most pixels of a sheet.
const MAX_PIXELS: u64 = 1 << 28;

/// Where the tiles of a sheet are.
#[derive(Clone, Copy, Debug)]
pub struct Grid {
    /// Number of tiles.
    pub count: u32,
    /// Tiles in a row.
    pub columns: u32,
    /// Width and height of a tile before it is trimmed \[pixels\].
    pub tile: [u32; 2],
    /// The part of a tile that the sheet has: left, top, width and height \[pixels\].
    pub kept: [u32; 4],
    /// Transparent pixels around each tile.
    pub gutter: u32,
    /// Whether the sides of the sheet are powers of two.
    pub is_power_of_two: bool,
}

impl Grid {
    /// Tiles in a column.
    pub fn rows(&self) -> u32 {
        self.count.div_ceil(self.columns)
    }

    /// Width and height of the sheet \[pixels\].
    ///
    /// # Errors
    /// It would be too large.
    pub fn size(&self) -> Result<[u32; 2], Error> {
        let [_, _, width, height] = self.kept.map(u64::from);
        let cell = |side: u64, tiles: u32| (side + 2 * u64::from(self.gutter)) * u64::from(tiles);
        let sides = [cell(width, self.columns), cell(height, self.rows())];
        let sides = sides.map(|side| match self.is_power_of_two {
            true => side.next_power_of_two(),
            false => side,
        });
        let [width, height] = sides;
        match width.saturating_mul(height) <= MAX_PIXELS {
            true => Ok(sides.map(|side| side as u32)),
            false => Err(Error::Use(format!(
                "the sheet has {width} x {height} pixels; it may have {MAX_PIXELS} in all"
            ))),
        }
    }

    /// The upper left corner of a tile in the sheet \[pixels\].
    pub fn corner(&self, number: u32) -> [u32; 2] {
        let [_, _, width, height] = self.kept;
        let cell = [width, height].map(|side| side + 2 * self.gutter);
        [
            number % self.columns * cell[0] + self.gutter,
            number / self.columns * cell[1] + self.gutter,
        ]
    }
}

/// The smallest part of pictures of one size outside of which all are transparent: left, top, width and height.
pub fn bounds(pictures: &[Picture]) -> [u32; 4] {
    let mut bounds: Option<[u32; 4]> = None;
    for picture in pictures {
        for (pixel, at) in picture.pixels().zip(0_u32..) {
            if pixel[3] > 0 {
                let (x, y) = (at % picture.width, at / picture.width);
                let [left, top, right, bottom] = bounds.unwrap_or([x, y, x, y]);
                bounds = Some([left.min(x), top.min(y), right.max(x), bottom.max(y)]);
            }
        }
    }
    let [left, top, right, bottom] = bounds.unwrap_or([0; 4]);
    [left, top, right - left + 1, bottom - top + 1]
}

/// A sheet of tiles, each as bytes of red, green, blue and alpha.
///
/// # Errors
/// It would be too large.
pub fn sheet(grid: &Grid, tiles: &[Vec<u8>]) -> Result<Vec<u8>, Error> {
    let [width, height] = grid.size()?.map(|side| side as usize);
    let mut sheet = vec![0; width * height * 4];
    let [left, top, columns, rows] = grid.kept.map(|side| side as usize);
    for (tile, number) in tiles.iter().zip(0..) {
        let [x, y] = grid.corner(number).map(|side| side as usize);
        for row in 0..rows {
            let from = ((top + row) * grid.tile[0] as usize + left) * 4;
            let to = ((y + row) * width + x) * 4;
            let (from, to) = (from..from + columns * 4, to..to + columns * 4);
            if let (Some(to), Some(from)) = (sheet.get_mut(to), tile.get(from)) {
                to.copy_from_slice(from);
            }
        }
    }
    Ok(sheet)
}

#[cfg(test)]
mod tests {
    use super::*;

    const GRID: Grid = Grid {
        count: 3,
        columns: 2,
        tile: [4, 2],
        kept: [1, 0, 2, 2],
        gutter: 1,
        is_power_of_two: true,
    };

    #[test]
    fn a_tile_is_where_its_corner_says() {
        assert_eq!(GRID.size().ok(), Some([8, 8]));
        let tiles: Vec<_> = (1..=3_u8).map(|value| vec![value; 4 * 2 * 4]).collect();
        let sheet = sheet(&GRID, &tiles).expect("a sheet");
        let pixel = |x: usize, y: usize| sheet[(y * 8 + x) * 4];
        for (number, value) in [(0, 1), (1, 2), (2, 3)] {
            let [x, y] = GRID.corner(number).map(|side| side as usize);
            assert_eq!([pixel(x, y), pixel(x + 1, y + 1)], [value; 2]);
            assert_eq!(
                [
                    pixel(x - 1, y),
                    pixel(x + 2, y),
                    pixel(x, y - 1),
                    pixel(x, y + 2)
                ],
                [0; 4]
            );
        }
    }

    #[test]
    fn bounds_are_those_of_all_pictures() {
        let picture = |at: usize| {
            let mut rgba = vec![0; 4 * 3 * 4];
            rgba[at * 4 + 3] = 9;
            Picture::premultiplied(4, 3, rgba)
        };
        assert_eq!(bounds(&[picture(5), picture(10)]), [1, 1, 2, 2]);
        assert_eq!(bounds(&[]), [0, 0, 1, 1]);
    }
}
