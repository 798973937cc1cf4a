//! The images that passes read and write. A sampler has the name of its image: `sampler2D light`
//! reads [`Image::Light`].

use crate::format::TargetFormat;
use crate::resolution::{Layout, MAX_BLURS, ResolutionLimits};
use crate::slices::MAX_SLICES;

/// An image of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Image {
    /// Particles, or the embers or solids of a pass that draws those.
    Particles,
    /// The noise tile.
    Noise,
    /// Colours by temperature.
    Palette,
    /// Sums over the particles.
    Field,
    /// The blurred field.
    Wide,
    /// Velocities of the gas.
    Flow,
    /// Offsets of the noise at the newest sample of the slice.
    AdvectedNoise,
    /// The same at the sample before.
    AdvectedNoiseBefore,
    /// Offsets of the noise at the moment of the slice.
    NoiseOffsets,
    /// Light before tone mapping. Slices behind the front one have a coarser target.
    Light,
    /// Light of the slices behind the front one.
    Behind,
    /// Light of the fire on smoke, and the share of the sky that reaches it.
    SmokeLight,
    /// Displayed colours.
    Shown,
    /// The backdrop in white light.
    Scenery,
    /// Irradiance on the backdrop and on solids.
    Irradiance,
    /// The blurred copy of the light at a level of the bloom; level 0 is the sharpest.
    Blur,
    /// The next sharper copy, or the light itself.
    Sharper,
    /// The next wider copy, blended with all wider ones.
    Wider,
    /// A copy blended with all wider ones.
    Glow,
    /// The widest copy.
    WidestBlur,
    /// The fire before its lit backdrop, which a low quality enlarges. Otherwise the canvas.
    Plate,
    /// The canvas.
    Picture,
}

/// Indices of the targets.
const FIELD: usize = 0;
const WIDE: usize = 1;
const NOISE_OFFSETS: usize = 2;
const LIGHT: usize = 3;
const SHOWN: usize = 4;
/// The backdrop.
pub const SCENERY: usize = 5;
const IRRADIANCE: usize = 6;
const BEHIND: usize = 7;
const OFFSETS_BEHIND: usize = 8;
const SMOKE_LIGHT: usize = 9;
/// The lit backdrop.
pub const PLATE: usize = 10;
const BLUR: usize = 11;
const GLOW: usize = BLUR + MAX_BLURS;
/// A target for each slice.
const FLOW: usize = GLOW + MAX_BLURS - 1;
/// Two targets for each slice, which alternate.
const ADVECTED_NOISE: usize = FLOW + MAX_SLICES;
/// Number of targets.
pub const TARGETS: usize = ADVECTED_NOISE + 2 * MAX_SLICES;

/// Which of the targets of an image a pass uses.
#[derive(Clone, Copy, Debug, Default)]
pub struct Which {
    /// Level of the bloom.
    pub level: usize,
    /// Level of the widest copy.
    pub widest: usize,
    /// Number of the slice.
    pub slice: usize,
    /// The newer target of its advected noise, 0 or 1.
    pub newest: usize,
    /// Whether the lit backdrop has a target of its own.
    pub enlarges: bool,
}

impl Image {
    /// Index of the image's target; `None` for the picture and for images that no pass draws.
    pub fn target(self, which: Which) -> Option<usize> {
        let Which {
            level,
            widest,
            slice,
            newest,
            enlarges,
        } = which;
        Some(match self {
            Image::Particles | Image::Noise | Image::Palette | Image::Picture => return None,
            Image::Plate if !enlarges => return None,
            Image::Plate => PLATE,
            Image::Field => FIELD,
            Image::Wide => WIDE,
            Image::Flow => FLOW + slice,
            Image::AdvectedNoise => ADVECTED_NOISE + 2 * slice + newest,
            Image::AdvectedNoiseBefore => ADVECTED_NOISE + 2 * slice + 1 - newest,
            Image::NoiseOffsets if slice > 0 => OFFSETS_BEHIND,
            Image::NoiseOffsets => NOISE_OFFSETS,
            Image::Behind => BEHIND,
            Image::Light if slice > 0 => BEHIND,
            Image::Light => LIGHT,
            Image::SmokeLight => SMOKE_LIGHT,
            Image::Shown => SHOWN,
            Image::Scenery => SCENERY,
            Image::Irradiance => IRRADIANCE,
            Image::Sharper if level == 0 => LIGHT,
            Image::Sharper => BLUR + level - 1,
            Image::Blur => BLUR + level,
            Image::Wider if level + 1 < widest => GLOW + level + 1,
            Image::Wider | Image::WidestBlur => BLUR + widest,
            Image::Glow => GLOW + level,
        })
    }
}

/// Format and size of a target.
pub fn format_and_size(
    target: usize,
    layout: &Layout,
    format: TargetFormat,
) -> (TargetFormat, [u32; 2]) {
    let size = match target {
        FIELD => layout.field,
        WIDE => layout.wide,
        NOISE_OFFSETS => layout.noise_offsets,
        // Slices behind the front one need less detail.
        ADVECTED_NOISE.. if target < ADVECTED_NOISE + 2 => layout.noise_offsets,
        OFFSETS_BEHIND | ADVECTED_NOISE.. => layout.flow,
        LIGHT | SHOWN => layout.light,
        BEHIND => layout.behind,
        SCENERY => layout.scenery,
        PLATE => layout.plate,
        IRRADIANCE => layout.irradiance,
        FLOW.. => layout.flow,
        // Smoke scatters light softly.
        SMOKE_LIGHT => layout.blurs()[1],
        GLOW.. => layout.blurs()[target - GLOW],
        _ => layout.blurs()[target - BLUR],
    };
    let format = match target {
        SHOWN | SCENERY | SMOKE_LIGHT | PLATE => TargetFormat::Rgba8,
        _ => format,
    };
    (format, size)
}

/// Memory of all targets of a picture of that size, those of its slices included, in half floats \[bytes\].
pub fn memory(picture: [u32; 2], limits: ResolutionLimits, max_side: u32) -> u64 {
    let Some(layout) = &Layout::new(picture, limits, max_side) else {
        return 0;
    };
    let levels = layout.blurs().len();
    let is_made = |target: &usize| {
        !(BLUR + levels..GLOW).contains(target)
            && !(GLOW + levels..FLOW).contains(target)
            && (*target != PLATE || layout.plate != layout.picture)
    };
    let targets = (0..TARGETS).filter(is_made).map(|target| {
        let (format, [width, height]) = format_and_size(target, layout, TargetFormat::Rgba16F);
        let pixel = if format == TargetFormat::Rgba8 { 4 } else { 8 };
        pixel * u64::from(width) * u64::from(height)
    });
    targets.sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bloom_levels_go_down_from_the_light_and_up_to_the_glow() {
        let widest = 3;
        let of = |image: Image, level| {
            image.target(Which {
                level,
                widest,
                ..Which::default()
            })
        };
        assert_eq!(of(Image::Sharper, 0), of(Image::Light, 0));
        for level in 1..=widest {
            assert_eq!(of(Image::Sharper, level), of(Image::Blur, level - 1));
        }
        assert_eq!(of(Image::Wider, widest - 1), of(Image::WidestBlur, 0));
        assert_eq!(of(Image::WidestBlur, 0), of(Image::Blur, widest));
        for level in 0..widest - 1 {
            assert_eq!(of(Image::Wider, level), of(Image::Glow, level + 1));
        }
    }
}
