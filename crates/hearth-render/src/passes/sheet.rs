//! Draws the atlas of a fire that another program shows in its own world.

use super::tone_map::soot_light;
use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::pass::{Draw, Pass, Per};
use crate::shaders::uniforms;

/// The light of a slice alone.
pub struct Sheet;

/// The glow and the light on smoke, which all slices share.
pub struct SheetLight;

impl Pass for Sheet {
    const TARGET: Image = Image::Picture;
    const DRAW: Draw = Draw::All;
    const PER: Per = Per::Slice;
    type Uniforms = uniforms::Sheet;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.sheets
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Sheet {
        of(frame, 0.0)
    }
}

impl Pass for SheetLight {
    const TARGET: Image = Image::Picture;
    const DRAW: Draw = Draw::All;
    type Uniforms = uniforms::Sheet;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.sheets
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Sheet {
        of(frame, 1.0)
    }
}

fn of(frame: &FrameUniforms, whole: f32) -> uniforms::Sheet {
    let light_range = frame.format.light_range();
    uniforms::Sheet {
        light_range,
        rooted: f32::from(frame.format.is_rooted()),
        bloom: light_range * frame.parameters.bloom,
        soot: soot_light(frame),
        whole,
    }
}
