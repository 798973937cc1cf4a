//! The images that passes read and write. A sampler has the name of its image: `sampler2D light`
//! reads [`Image::Light`].

use crate::format::TargetFormat;
use crate::resolution::{Layout, MAX_BLURS};

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
    /// Offsets of the advected noise.
    NoiseOffsets,
    /// The offsets of the previous picture.
    NoiseOffsetsBefore,
    /// Light before tone mapping.
    Light,
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
    /// The canvas.
    Picture,
}

/// Indices of the targets.
const FIELD: usize = 0;
const WIDE: usize = 1;
const FLOW: usize = 2;
/// Two targets, which alternate.
pub const NOISE_OFFSETS: usize = 3;
const LIGHT: usize = 5;
const SHOWN: usize = 6;
/// The backdrop.
pub const SCENERY: usize = 7;
const IRRADIANCE: usize = 8;
const BLUR: usize = 9;
const GLOW: usize = BLUR + MAX_BLURS;
/// Number of targets.
pub const TARGETS: usize = GLOW + MAX_BLURS - 1;

impl Image {
    /// Index of the image's target in a pass at a level of a bloom with `widest + 1` levels; `None`
    /// for the picture and for images that no pass draws.
    pub fn target(self, level: usize, widest: usize, newest: usize) -> Option<usize> {
        Some(match self {
            Image::Particles | Image::Noise | Image::Palette | Image::Picture => return None,
            Image::Field => FIELD,
            Image::Wide => WIDE,
            Image::Flow => FLOW,
            Image::NoiseOffsets => NOISE_OFFSETS + newest,
            Image::NoiseOffsetsBefore => NOISE_OFFSETS + 1 - newest,
            Image::Light => LIGHT,
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
        FLOW => layout.flow,
        LIGHT | SHOWN => layout.light,
        SCENERY => layout.scenery,
        IRRADIANCE => layout.irradiance,
        GLOW.. => layout.blurs()[target - GLOW],
        BLUR.. => layout.blurs()[target - BLUR],
        _ => layout.noise_offsets,
    };
    let format = match target {
        SHOWN | SCENERY => TargetFormat::Rgba8,
        _ => format,
    };
    (format, size)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bloom_levels_go_down_from_the_light_and_up_to_the_glow() {
        let widest = 3;
        let of = |image: Image, level| image.target(level, widest, 0);
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
