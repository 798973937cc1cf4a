//! The images that passes read and draw into. A sampler of a shader is named as the image that
//! it reads: `sampler2D light` is [`Image::Light`].

use crate::format::TargetFormat;
use crate::resolution::{Layout, MAX_BLURS};

/// An image of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Image {
    /// The particles, or the embers in a pass that draws these.
    Particles,
    /// The tile of noise.
    Noise,
    /// Colours by temperature.
    Palette,
    /// Sums over the particles.
    Field,
    /// The field as seen from farther away.
    Wide,
    /// Velocities of the gas.
    Flow,
    /// How far the gas has carried the noise.
    Carried,
    /// The same in the last picture.
    CarriedBefore,
    /// Light before the tone map.
    Light,
    /// Displayed colours.
    Shown,
    /// The backdrop in plain light.
    Scenery,
    /// The fire's light on the backdrop.
    Irradiance,
    /// A blurred copy of the light, of a level of the bloom: 0 is the sharpest.
    Blur,
    /// The next sharper copy, or the light itself.
    Sharper,
    /// The next wider copy, joined with all that are wider still.
    Wider,
    /// A copy joined with all wider ones.
    Glow,
    /// The widest copy.
    WidestBlur,
    /// What the canvas shows.
    Picture,
}

/// Where a target lies among all.
const FIELD: usize = 0;
const WIDE: usize = 1;
const FLOW: usize = 2;
/// Two, which take turns.
pub const CARRIED: usize = 3;
const LIGHT: usize = 5;
const SHOWN: usize = 6;
/// The backdrop.
pub const SCENERY: usize = 7;
const IRRADIANCE: usize = 8;
const BLUR: usize = 9;
const GLOW: usize = BLUR + MAX_BLURS;
/// How many targets a frame may have.
pub const TARGETS: usize = GLOW + MAX_BLURS - 1;

impl Image {
    /// The target that this image is, for a pass of that level of a bloom that has `widest + 1`
    /// levels; none for the images that no pass draws, and for the picture.
    pub fn target(self, level: usize, widest: usize, newest: usize) -> Option<usize> {
        Some(match self {
            Image::Particles | Image::Noise | Image::Palette | Image::Picture => return None,
            Image::Field => FIELD,
            Image::Wide => WIDE,
            Image::Flow => FLOW,
            Image::Carried => CARRIED + newest,
            Image::CarriedBefore => CARRIED + 1 - newest,
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
pub fn form(target: usize, layout: &Layout, format: TargetFormat) -> (TargetFormat, [u32; 2]) {
    let size = match target {
        FIELD => layout.field,
        WIDE => layout.wide,
        FLOW => layout.flow,
        LIGHT | SHOWN => layout.light,
        SCENERY => layout.scenery,
        IRRADIANCE => layout.irradiance,
        GLOW.. => layout.blurs()[target - GLOW],
        BLUR.. => layout.blurs()[target - BLUR],
        _ => layout.carried,
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
    fn a_bloom_goes_down_from_the_light_and_up_to_the_glow() {
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
