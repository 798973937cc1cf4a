//! Sizes and places: how large each target is, and which part of the picture
//! the fire can reach.
//!
//! Fields are smooth, so a few texels for each kernel are enough; the light
//! keeps half of a large picture's lines; the glow starts at a quarter. Fill
//! rate is what a phone, or a machine without a graphics card, lacks most.

/// Blurred copies of the light: the first a quarter as wide, each other half as
/// wide as the one before.
pub const BLURS: usize = 3;

/// How much coarser than the fields their view from farther away is.
const SPREAD: u32 = 6;

/// Most lines of the fields.
const FIELD_LINES: u32 = 270;
/// Texels that a kernel's radius should span: below, the fields show the
/// texels; above, they only cost time.
const TEXELS_PER_RADIUS: f32 = 3.2;
/// Most texels that all kernels together may touch in a frame.
const SPLAT_BUDGET: f32 = 4.0e6;

/// How finely the light is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lines {
    /// Lines up to which the light keeps every one of the picture's; of more
    /// it keeps half.
    pub full: u32,
    /// Most lines of the light.
    pub most: u32,
}

impl Lines {
    /// For slow machines.
    pub const LOW: Lines = Lines {
        full: 270,
        most: 360,
    };
    /// For most.
    pub const MEDIUM: Lines = Lines {
        full: 360,
        most: 720,
    };
    /// For fast ones.
    pub const HIGH: Lines = Lines {
        full: 540,
        most: 1080,
    };
}

/// Sizes of the targets for one size of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// The picture itself.
    pub picture: [u32; 2],
    /// The fields.
    pub field: [u32; 2],
    /// The fields as seen from farther away.
    pub wide: [u32; 2],
    /// How fast the gas moves.
    pub flow: [u32; 2],
    /// How far it has carried the fine structure.
    pub drift: [u32; 2],
    /// The light before the tone map.
    pub light: [u32; 2],
    /// The blurred copies of it.
    pub blurs: [[u32; 2]; BLURS],
}

impl Layout {
    /// The layout of a picture, none of whose targets is larger than `most`.
    /// A picture without a pixel has none.
    pub fn new(picture: [u32; 2], fine: Lines, most: u32) -> Option<Layout> {
        let [width, height] = picture;
        if width == 0 || height == 0 || most == 0 {
            return None;
        }
        let lines = |lines: u32| {
            let share = f64::from(lines.max(1)) / f64::from(height);
            [(f64::from(width) * share).ceil(), f64::from(lines)]
                .map(|side| (side as u32).clamp(1, most))
        };
        let light = lines(height.min((height / 2).max(fine.full).min(fine.most)));
        let mut size = light.map(|side| side.div_ceil(2));
        let blurs = [(); BLURS].map(|()| {
            size = size.map(|side| side.div_ceil(2));
            size
        });
        let field = lines(FIELD_LINES.min(height.div_ceil(2)));
        Some(Layout {
            picture,
            field,
            wide: field.map(|side| side.div_ceil(SPREAD)),
            flow: field.map(|side| side.div_ceil(3)),
            drift: field.map(|side| side.div_ceil(2)),
            light,
            blurs,
        })
    }

    /// The lower left part of the field target that is worth filling with
    /// `count` kernels of `radius` \[m\] in a picture `height` \[m\] high.
    pub fn used_field(&self, count: usize, radius: f32, height: f32) -> [u32; 2] {
        let needed = TEXELS_PER_RADIUS * height / radius;
        let affordable = (SPLAT_BUDGET / count.max(1) as f32).sqrt() * height / (2.0 * radius);
        let share = needed.min(affordable).max(32.0) / self.field[1] as f32;
        self.field
            .map(|side| ((side as f32 * share.min(1.0)).ceil() as u32).clamp(1, side))
    }
}

/// A rectangle in pixels, from the lower left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rectangle {
    /// Left edge.
    pub x: i32,
    /// Lower edge.
    pub y: i32,
    /// Width; 0: nothing to draw.
    pub width: i32,
    /// Height.
    pub height: i32,
}

/// Where the world stands in the picture: its height fits, x is centred.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Width and height of what the picture shows \[m\].
    pub metres: [f32; 2],
}

impl Place {
    /// The place of a domain `height` \[m\] high in a picture of that size.
    pub fn new(picture: [u32; 2], height: f32) -> Place {
        let aspect = picture[0] as f32 / picture[1].max(1) as f32;
        Place {
            metres: [height * aspect, height],
        }
    }

    /// Metres to clip coordinates: scale x, y, offset x, y.
    pub fn to_clip(self) -> [f32; 4] {
        [2.0 / self.metres[0], 2.0 / self.metres[1], 0.0, -1.0]
    }

    /// The texels of a target of that size that `bounds` (left, lower, right,
    /// upper \[m\]) touches.
    pub fn rectangle(self, bounds: [f32; 4], size: [u32; 2]) -> Rectangle {
        let [left, lower, right, upper] = bounds;
        let [width, height] = size.map(|side| side as f32);
        let column = |x: f32| (x / self.metres[0] + 0.5) * width;
        let row = |y: f32| y / self.metres[1] * height;
        // A float that is too large, or no number, becomes an edge: `as` saturates.
        let clamp = |at: f32, most: f32| at.max(0.0).min(most) as i32;
        let (x, y) = (
            clamp(column(left).floor(), width),
            clamp(row(lower).floor(), height),
        );
        Rectangle {
            x,
            y,
            width: (clamp(column(right).ceil(), width) - x).max(0),
            height: (clamp(row(upper).ceil(), height) - y).max(0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_without_pixels_has_no_targets() {
        for size in [[0, 0], [0, 480], [640, 0]] {
            assert_eq!(Layout::new(size, Lines::MEDIUM, 4096), None);
        }
    }

    #[test]
    fn every_target_fits_the_driver_and_is_not_empty() {
        for size in [
            [1, 1],
            [1, 5000],
            [5000, 1],
            [360, 640],
            [2560, 1440],
            [30_000, 30_000],
        ] {
            let layout = Layout::new(size, Lines::HIGH, 2048).expect("there are pixels");
            let sizes = layout.blurs.into_iter().chain([
                layout.field,
                layout.wide,
                layout.flow,
                layout.drift,
                layout.light,
            ]);
            for [width, height] in sizes {
                assert!((1..=2048).contains(&width) && (1..=2048).contains(&height));
            }
            let [width, height] = layout.used_field(100_000, 0.01, 6.0);
            assert!((1..=layout.field[0]).contains(&width));
            assert!((1..=layout.field[1]).contains(&height));
        }
    }

    #[test]
    fn more_quality_is_never_coarser() {
        for size in [[320, 200], [360, 640], [1280, 720], [3840, 2160]] {
            let light = [Lines::LOW, Lines::MEDIUM, Lines::HIGH].map(|lines| {
                Layout::new(size, lines, 4096)
                    .expect("there are pixels")
                    .light
            });
            assert!(light.is_sorted_by_key(|[_, lines]| *lines), "{light:?}");
            assert!(light[2][1] <= size[1], "{light:?}");
        }
    }

    #[test]
    fn many_particles_do_not_cost_more_than_the_budget() {
        let layout = Layout::new([1280, 720], Lines::MEDIUM, 4096).expect("there are pixels");
        for count in [1000, 10_000, 100_000] {
            let [_, lines] = layout.used_field(count, 0.04, 1.5);
            let side = 2.0 * 0.04 / 1.5 * lines as f32;
            assert!(count as f32 * side * side <= 1.1 * SPLAT_BUDGET, "{count}");
        }
    }

    #[test]
    fn the_source_stands_in_the_lower_middle() {
        let place = Place::new([1280, 720], 1.5);
        let at = place.rectangle([-0.1, 0.0, 0.1, 0.75], [1280, 720]);
        assert_eq!(at.y, 0);
        assert_eq!(at.height, 360);
        assert_eq!(2 * at.x + at.width, 1280);
        assert!((95..=98).contains(&at.width), "{at:?}");
    }

    #[test]
    fn what_is_outside_or_no_number_touches_nothing() {
        let place = Place::new([100, 100], 1.0);
        for bounds in [
            [3.0, 0.0, 4.0, 1.0],
            [0.0, 2.0, 0.1, 3.0],
            [
                f32::INFINITY,
                f32::INFINITY,
                f32::NEG_INFINITY,
                f32::NEG_INFINITY,
            ],
        ] {
            let at = place.rectangle(bounds, [100, 100]);
            assert!(at.width == 0 || at.height == 0, "{bounds:?}: {at:?}");
        }
    }
}
