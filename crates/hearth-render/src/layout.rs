//! Sizes: how large each target is.
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
}
