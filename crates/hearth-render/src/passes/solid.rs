//! Draws solids in the light of the fire.

use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::palette::Tint;
use crate::pass::{Blend, Draw, Pass};
use crate::shaders::uniforms;

/// Brightness of a surface relative to gas of the same temperature, which is thin.
const RELATIVE_BRIGHTNESS: f32 = 1.0;

/// Luminance exponent of glowing solids and embers. The flame's is a parameter and larger; with it, coal
/// would be dark.
pub const SOLID_LUMINANCE_EXPONENT: f32 = 0.35;

/// The solids behind the displayed fire: the pass puts the fire on them again.
pub struct Solid;

impl Pass for Solid {
    const TARGET: Image = Image::Picture;
    const BLEND: Blend = Blend::Over;
    const DRAW: Draw = Draw::Solids;
    type Uniforms = uniforms::Solid;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.lights_solids()
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Solid {
        of_solids(frame, frame.cladding, frame.pixel())
    }
}

/// Bricks and hangings that come first, with as few lines as the lit wall that they clad.
pub struct Cladding;

impl Pass for Cladding {
    const TARGET: Image = Image::Plate;
    const BLEND: Blend = Blend::Over;
    const DRAW: Draw = Draw::Cladding;
    type Uniforms = uniforms::Solid;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.cladding > 0
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Solid {
        of_solids(frame, 0, frame.texel(frame.layout.plate))
    }
}

/// Uniforms for solids from the number `first` on, in pixels of that size \[m\].
#[inline(never)]
fn of_solids(frame: &FrameUniforms, first: usize, pixel_size: f32) -> uniforms::Solid {
    let viewport = &frame.viewport;
    let [clip_scale, clip_offset] = viewport.to_clip();
    let (pale, yellow) = Tint::of(frame.parameters).pale();
    uniforms::Solid {
        clip_scale,
        clip_offset,
        first_solid: first as f32,
        count: frame.solids as f32,
        margin: pixel_size,
        pixel_size,
        floor_middle: viewport.floor,
        picture_size: viewport.metres,
        per_height: viewport.heights().map(|side| 1.0 / side),
        light_range: frame.light_on_things(),
        luminance_exponent: SOLID_LUMINANCE_EXPONENT,
        gain: RELATIVE_BRIGHTNESS * frame.gain(),
        sky: frame.sky(),
        pale,
        yellow,
    }
}
