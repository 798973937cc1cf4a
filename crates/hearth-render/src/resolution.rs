//! Sizes of the targets.
//!
//! Fields are smooth, so a few texels per kernel are enough. The light has half of a large
//! picture's lines, and glow needs fewer. Fill rate limits phones and machines without a graphics
//! card.

use hearth_core::resolution::Level;

/// Maximum number of blurred copies of the light.
pub const MAX_BLURS: usize = 4;
/// Lines of the widest blurred copy, independent of quality and picture size, so that the glow
/// has the same width in all of them. Each sharper copy has twice as many.
const WIDEST_BLUR_LINES: u32 = 32;

/// Lines of the field per line of its blurred copy.
const FIELD_LINES_PER_WIDE: u32 = 6;
/// Lines of the field per line of the flow, and of the noise advection.
const FIELD_LINES_PER_FLOW: u32 = 3;
const FIELD_LINES_PER_NOISE_OFFSETS: u32 = 2;

/// Minimum number of lines of the light of slices behind the front one, which has half of the light's.
const MIN_BEHIND_LINES: u32 = 240;
/// Texels of the field of a slice behind the front one per radius of a kernel, relative to those of the front.
const BEHIND_TEXELS_SHARE: f32 = 0.65;

/// Maximum number of lines of the backdrop, which is far away.
const MAX_SCENERY_LINES: u32 = 1080;
/// Lines and maximum number of columns of the irradiance on the backdrop. Each texel reads the
/// whole fire.
const IRRADIANCE_LINES_AND_COLUMNS: [u32; 2] = [16, 64];

/// Maximum number of texels that all kernels of a frame cover.
const MAX_SPLAT_TEXELS: f32 = 4.0e6;
/// Minimum number of used lines of the field.
const MIN_FIELD_LINES: f32 = 32.0;

/// Limits of the resolution at a level of quality.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResolutionLimits {
    /// Maximum number of lines of a picture whose light has all lines. The light of a larger
    /// picture has half of them.
    pub full: u32,
    /// Maximum number of lines of the light.
    pub light: u32,
    /// Maximum number of lines of the field.
    pub field: u32,
    /// Maximum number of lines of a lit wall. That of a larger picture is enlarged.
    pub wall: u32,
    /// Texels of the field per radius of a kernel. With fewer, texels become visible; more cost
    /// time without effect.
    pub texels: f32,
    /// Maximum number of slices.
    pub slices: usize,
    /// Share of each sharper copy when it blends with the wider ones, widest first.
    pub sharper_shares: &'static [f32],
}

impl ResolutionLimits {
    /// Those of a level.
    pub const fn of(level: Level) -> ResolutionLimits {
        match level {
            Level::Low => ResolutionLimits::LOW,
            Level::Medium => ResolutionLimits::MEDIUM,
            Level::High => ResolutionLimits::HIGH,
        }
    }

    /// Those before a lit wall: the light has no more lines than the wall that shows it.
    pub fn before_wall(self) -> ResolutionLimits {
        ResolutionLimits {
            light: self.light.min(self.wall),
            ..self
        }
    }

    /// For slow machines.
    pub const LOW: ResolutionLimits = ResolutionLimits {
        full: 270,
        light: 360,
        wall: 270,
        field: 180,
        texels: 2.6,
        slices: 3,
        sharper_shares: &[0.64],
    };
    /// For most machines.
    pub const MEDIUM: ResolutionLimits = ResolutionLimits {
        full: 360,
        light: 720,
        wall: u32::MAX,
        field: 270,
        texels: 3.2,
        slices: 5,
        sharper_shares: &[0.4, 0.4],
    };
    /// For fast machines.
    pub const HIGH: ResolutionLimits = ResolutionLimits {
        full: 540,
        light: 1080,
        wall: u32::MAX,
        field: 405,
        texels: 4.0,
        slices: 5,
        sharper_shares: &[0.4, 0.25, 0.2],
    };
}

/// Columns and rows of cells of an atlas.
const ATLAS: [u32; 2] = [5, 2];

/// Size of the [atlas](crate::View::sheets) of a picture of that size. No cell has more texels than the light.
pub fn atlas_size(picture: [u32; 2], limits: ResolutionLimits) -> [u32; 2] {
    let layout = Layout::new(picture, limits, u32::MAX);
    let [width, height] = layout.map_or([1, 1], |layout| layout.atlas_cell());
    [ATLAS[0] * width, ATLAS[1] * height]
}

/// Sizes of the targets of a picture.
#[derive(Clone, Copy, Debug)]
pub struct Layout {
    /// Limits of these sizes.
    pub limits: ResolutionLimits,
    /// The picture.
    pub picture: [u32; 2],
    /// The field.
    pub field: [u32; 2],
    /// The blurred field.
    pub wide: [u32; 2],
    /// Velocities of the gas.
    pub flow: [u32; 2],
    /// Offsets of the advected noise.
    pub noise_offsets: [u32; 2],
    /// The light before the tone map.
    pub light: [u32; 2],
    /// The light of the slices behind the front one.
    pub behind: [u32; 2],
    /// The backdrop.
    pub scenery: [u32; 2],
    /// The lit wall.
    pub plate: [u32; 2],
    /// Irradiance on the backdrop.
    pub irradiance: [u32; 2],
    /// Blurred copies of the light, sharpest first; unused ones last.
    blurs: [[u32; 2]; MAX_BLURS],
}

impl PartialEq for Layout {
    /// All sizes follow from the picture's size and the limits.
    fn eq(&self, other: &Layout) -> bool {
        self.picture == other.picture && self.limits == other.limits
    }
}

impl Layout {
    /// The layout of a picture, with sides of at most `max`; `None` for a picture without pixels.
    pub fn new(picture: [u32; 2], limits: ResolutionLimits, max: u32) -> Option<Layout> {
        let [width, height] = picture;
        if width == 0 || height == 0 || max == 0 {
            return None;
        }
        let lines = |lines: u32| {
            let share = f64::from(lines.max(1)) / f64::from(height);
            [(f64::from(width) * share).ceil(), f64::from(lines)]
                .map(|side| (side as u32).clamp(1, max))
        };
        let light = lines(height.min((height / 2).max(limits.full).min(limits.light)));
        let mut sharpest = WIDEST_BLUR_LINES << limits.sharper_shares.len();
        let blurs = [(); MAX_BLURS].map(|()| {
            let size = lines(sharpest.min(light[1].div_ceil(2)));
            sharpest /= 2;
            size
        });
        let field = lines(limits.field.min(height.div_ceil(2)));
        let backdrop = |lines: u32, columns: u32| {
            let lines = lines.min(height).min(max);
            let across = f64::from(width) * f64::from(lines) / f64::from(height);
            [(across as u32).clamp(1, columns.min(max)), lines]
        };
        Some(Layout {
            limits,
            picture,
            field,
            wide: field.map(|side| side.div_ceil(FIELD_LINES_PER_WIDE)),
            flow: field.map(|side| side.div_ceil(FIELD_LINES_PER_FLOW)),
            noise_offsets: field.map(|side| side.div_ceil(FIELD_LINES_PER_NOISE_OFFSETS)),
            light,
            behind: lines(light[1].min((light[1] / 2).max(MIN_BEHIND_LINES))),
            scenery: backdrop(MAX_SCENERY_LINES, max),
            plate: lines(limits.wall.min(height)),
            irradiance: backdrop(
                IRRADIANCE_LINES_AND_COLUMNS[0],
                IRRADIANCE_LINES_AND_COLUMNS[1],
            ),
            blurs,
        })
    }

    /// Corner and size of the light of a slice in an [atlas](atlas_size), or without one those of the glow below the light on
    /// smoke.
    pub(crate) fn in_atlas(&self, slice: Option<usize>) -> ([u32; 2], [u32; 2]) {
        let [width, height] = self.atlas_cell();
        let (column, row, columns, rows) = match slice {
            Some(0) => (0, 0, 2, 2),
            Some(index) => (2 + (index as u32 - 1) / 2, (index as u32 - 1) % 2, 1, 1),
            None => (4, 0, 1, 2),
        };
        (
            [column * width, row * height],
            [columns * width, rows * height],
        )
    }

    /// Size of a cell: half of the sides of the light.
    fn atlas_cell(&self) -> [u32; 2] {
        self.light.map(|side| side.div_ceil(2))
    }

    /// Sizes of the blurred copies of the light, sharpest first.
    pub fn blurs(&self) -> &[[u32; 2]] {
        &self.blurs[..self.limits.sharper_shares.len() + 1]
    }

    /// The lower left part of the field that a frame uses: as fine as `count` kernels of
    /// `radius` \[m\] need in a picture of `height` \[m\], within the budget of texels. `behind`: for a slice
    /// behind the front one.
    pub fn used_field(&self, count: usize, radius: f32, height: f32, behind: bool) -> [u32; 2] {
        let share = if behind { BEHIND_TEXELS_SHARE } else { 1.0 };
        let needed = share * self.limits.texels * height / radius;
        let affordable = (MAX_SPLAT_TEXELS / count.max(1) as f32).sqrt() * height / (2.0 * radius);
        let share = needed.min(affordable).max(MIN_FIELD_LINES) / self.field[1] as f32;
        self.field
            .map(|side| ((side as f32 * share.min(1.0)).ceil() as u32).clamp(1, side))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_without_pixels_has_no_layout() {
        for size in [[0, 0], [0, 480], [640, 0]] {
            assert_eq!(Layout::new(size, ResolutionLimits::MEDIUM, 4096), None);
        }
    }

    #[test]
    fn light_has_no_more_lines_than_the_wall_that_shows_it() {
        let light = |limits: ResolutionLimits, size| {
            Layout::new(size, limits, 4096).map(|layout| layout.light[1])
        };
        let low = ResolutionLimits::LOW;
        for size in [[1280, 720], [320, 200], [720, 1280]] {
            let before = light(low.before_wall(), size);
            assert_eq!(before, light(low, size).map(|lines| lines.min(low.wall)));
            for limits in [ResolutionLimits::MEDIUM, ResolutionLimits::HIGH] {
                assert_eq!(limits.before_wall(), limits);
            }
        }
    }

    #[test]
    fn every_target_has_texels_and_fits_the_driver() {
        for size in [
            [1, 1],
            [1, 5000],
            [5000, 1],
            [360, 640],
            [2560, 1440],
            [30_000, 30_000],
        ] {
            let layout =
                Layout::new(size, ResolutionLimits::HIGH, 2048).expect("a picture with pixels");
            let sizes = layout.blurs().iter().copied().chain([
                layout.field,
                layout.wide,
                layout.flow,
                layout.noise_offsets,
                layout.light,
                layout.behind,
                layout.scenery,
                layout.plate,
                layout.irradiance,
            ]);
            for [width, height] in sizes {
                assert!((1..=2048).contains(&width) && (1..=2048).contains(&height));
            }
            let [width, height] = layout.used_field(100_000, 0.01, 6.0, false);
            assert!((1..=layout.field[0]).contains(&width));
            assert!((1..=layout.field[1]).contains(&height));
        }
    }

    #[test]
    fn slices_and_glow_fill_an_atlas_without_overlap() {
        for picture in [[1, 1], [16, 2048], [512, 512], [333, 257]] {
            for limits in [ResolutionLimits::LOW, ResolutionLimits::HIGH] {
                let layout = Layout::new(picture, limits, 4096).expect("a picture with pixels");
                let [width, height] = atlas_size(picture, limits);
                let mut covered = vec![0; (width * height) as usize];
                for slice in (0..crate::slices::MAX_SLICES).map(Some).chain([None]) {
                    let ([left, lower], [across, up]) = layout.in_atlas(slice);
                    assert!(slice != Some(0) || across >= layout.light[0]);
                    for y in lower..lower + up {
                        for x in left..left + across {
                            covered[(y * width + x) as usize] += 1;
                        }
                    }
                }
                assert!(covered.iter().all(|&count| count == 1), "{picture:?}");
            }
        }
    }

    #[test]
    fn higher_quality_is_never_coarser() {
        for size in [[320, 200], [360, 640], [1280, 720], [3840, 2160]] {
            let layouts = [
                ResolutionLimits::LOW,
                ResolutionLimits::MEDIUM,
                ResolutionLimits::HIGH,
            ]
            .map(|limits| Layout::new(size, limits, 4096).expect("a picture with pixels"));
            for of in [
                |layout: &Layout| layout.light[1],
                |layout: &Layout| layout.field[1],
                |layout: &Layout| layout.plate[1],
                |layout: &Layout| layout.blurs()[0][1],
                |layout: &Layout| layout.used_field(1000, 0.04, 1.5, false)[1],
            ] {
                assert!(layouts.is_sorted_by_key(of), "{layouts:?}");
            }
            assert!(layouts[2].light[1] <= size[1], "{layouts:?}");
            // Only low quality enlarges a lit wall.
            assert_eq!([layouts[1].plate, layouts[2].plate], [size; 2]);
            assert!(layouts[0].plate[1] <= ResolutionLimits::LOW.wall);
        }
    }

    #[test]
    fn glow_has_the_same_width_at_every_quality() {
        for limits in [
            ResolutionLimits::LOW,
            ResolutionLimits::MEDIUM,
            ResolutionLimits::HIGH,
        ] {
            let layout = Layout::new([1280, 720], limits, 4096).expect("a picture with pixels");
            let widest = layout.blurs().last().expect("blurred copies");
            assert_eq!(widest[1], WIDEST_BLUR_LINES);
            // Share of the widest copy in the glow.
            let share: f32 = limits
                .sharper_shares
                .iter()
                .map(|sharper| 1.0 - sharper)
                .product();
            assert!((share - 0.36).abs() < 1e-6, "{limits:?}");
        }
    }

    #[test]
    fn kernels_cover_no_more_texels_than_the_budget() {
        let layout = Layout::new([1280, 720], ResolutionLimits::MEDIUM, 4096)
            .expect("a picture with pixels");
        for count in [1000, 10_000, 100_000] {
            let [_, lines] = layout.used_field(count, 0.04, 1.5, false);
            let side = 2.0 * 0.04 / 1.5 * lines as f32;
            assert!(
                count as f32 * side * side <= 1.1 * MAX_SPLAT_TEXELS,
                "{count}"
            );
        }
    }
}
