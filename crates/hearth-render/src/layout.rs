//! Sizes and places: how large each target is, and which part of the picture
//! the fire can reach.
//!
//! Fields are smooth, so a few texels for each kernel are enough; the light
//! keeps half of a large picture's lines; glow needs fewer still. Fill
//! rate is what a phone, or a machine without a graphics card, lacks most.

/// Most blurred copies of the light.
pub const MOST_BLURS: usize = 4;
/// Lines of the widest blurred copy, whatever the quality and the picture: the glow
/// is as wide in all of them. Each sharper copy has twice as many.
const WIDEST_BLUR: u32 = 32;

/// How much coarser than the fields their view from farther away is.
const SPREAD: u32 = 6;

/// Most texels that all kernels together may touch in a frame.
const SPLAT_BUDGET: f32 = 4.0e6;

/// How finely a fire is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lines {
    /// Lines up to which the light keeps every one of the picture's; of more
    /// it keeps half.
    pub full: u32,
    /// Most lines of the light.
    pub most: u32,
    /// Most lines of the fields.
    pub field: u32,
    /// Texels of the fields that a kernel's radius should span: with fewer they show;
    /// more only cost time.
    pub texels: f32,
    /// How much of each sharper blurred copy joins the wider ones, from the widest
    /// on. The shares of copies that two qualities have in common are the same.
    pub sharper: &'static [f32],
}

impl Lines {
    /// For slow machines.
    pub const LOW: Lines = Lines {
        full: 270,
        most: 360,
        field: 180,
        texels: 2.6,
        sharper: &[0.64],
    };
    /// For most.
    pub const MEDIUM: Lines = Lines {
        full: 360,
        most: 720,
        field: 270,
        texels: 3.2,
        sharper: &[0.4, 0.4],
    };
    /// For fast ones.
    pub const HIGH: Lines = Lines {
        full: 540,
        most: 1080,
        field: 405,
        texels: 4.0,
        sharper: &[0.4, 0.25, 0.2],
    };
}

/// Sizes of the targets for one size of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layout {
    /// How finely it is drawn.
    pub fine: Lines,
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
    /// The blurred copies of it, sharpest first; as many as the quality has count.
    blurs: [[u32; 2]; MOST_BLURS],
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
        let mut sharpest = WIDEST_BLUR << fine.sharper.len();
        let blurs = [(); MOST_BLURS].map(|()| {
            let size = lines(sharpest.min(light[1].div_ceil(2)));
            sharpest /= 2;
            size
        });
        let field = lines(fine.field.min(height.div_ceil(2)));
        Some(Layout {
            fine,
            picture,
            field,
            wide: field.map(|side| side.div_ceil(SPREAD)),
            flow: field.map(|side| side.div_ceil(3)),
            drift: field.map(|side| side.div_ceil(2)),
            light,
            blurs,
        })
    }

    /// Sizes of the blurred copies of the light, sharpest first.
    pub fn blurs(&self) -> &[[u32; 2]] {
        &self.blurs[..self.fine.sharper.len() + 1]
    }

    /// The lower left part of the field target that is worth filling with
    /// `count` kernels of `radius` \[m\] in a picture `height` \[m\] high.
    pub fn used_field(&self, count: usize, radius: f32, height: f32) -> [u32; 2] {
        let needed = self.fine.texels * height / radius;
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

    /// For a shader: where in the picture the middle of the floor is, and `x` \[m\].
    pub fn origin(self, x: f32) -> [f32; 4] {
        [0.5, 0.0, x, 0.0]
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
            let sizes = layout.blurs().iter().copied().chain([
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
            let layouts = [Lines::LOW, Lines::MEDIUM, Lines::HIGH]
                .map(|lines| Layout::new(size, lines, 4096).expect("there are pixels"));
            for of in [
                |layout: &Layout| layout.light[1],
                |layout: &Layout| layout.field[1],
                |layout: &Layout| layout.blurs()[0][1],
                |layout: &Layout| layout.used_field(1000, 0.04, 1.5)[1],
            ] {
                assert!(layouts.is_sorted_by_key(of), "{layouts:?}");
            }
            assert!(layouts[2].light[1] <= size[1], "{layouts:?}");
        }
    }

    #[test]
    fn glow_is_as_wide_at_every_quality() {
        for lines in [Lines::LOW, Lines::MEDIUM, Lines::HIGH] {
            let layout = Layout::new([1280, 720], lines, 4096).expect("there are pixels");
            let widest = layout.blurs().last().expect("there are copies");
            assert_eq!(widest[1], WIDEST_BLUR);
            // What of the glow is the widest copy's.
            let share: f32 = lines.sharper.iter().map(|sharper| 1.0 - sharper).product();
            assert!((share - 0.36).abs() < 1e-6, "{lines:?}");
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
