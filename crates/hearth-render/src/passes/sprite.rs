//! Draws particles as textured sprites.

use hearth_core::params::{DisplayMode, Model};

use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::palette::Tint;
use crate::pass::{Blend, Draw, Load, Pass};
use crate::shaders::uniforms;

/// Opacity of a sprite, and the remaining life or the soot from which it glows fully.
const OF_LIFE: [f32; 2] = [0.45, 0.25];
const OF_SOOT: [f32; 2] = [0.9, 0.3];
/// Brightness of a sprite relative to gas: many sprites overlap.
const RELATIVE_BRIGHTNESS: f32 = 0.16;
/// Mean time of one turn of a sprite \[s\].
const TURN_SECONDS: f64 = 9.0;

/// Flakes of noise.
pub struct Sprite;

impl Pass for Sprite {
    const TARGET: Image = Image::Shown;
    const LOAD: Load = Load::Clear;
    const BLEND: Blend = Blend::Screen;
    const DRAW: Draw = Draw::Particles;
    type Uniforms = uniforms::Sprite;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.shows(DisplayMode::Sprites)
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Sprite {
        let parameters = frame.parameters;
        let [opacity, full] = match parameters.model() {
            Model::Classic => OF_LIFE,
            Model::Combustion => OF_SOOT,
        };
        // Speeds are odd multiples of one half, so two turns of speed 1 are a common period.
        let turns = frame.time / (2.0 * TURN_SECONDS);
        let [clip_scale, clip_offset] = frame.viewport.to_clip();
        let (pale, yellow) = Tint::of(parameters).pale();
        uniforms::Sprite {
            clip_scale,
            clip_offset,
            count: frame.particles.count as f32,
            radius: frame.kernel.radius,
            turns: 2.0 * (turns - turns.floor()) as f32,
            opacity,
            full,
            luminance_exponent: parameters.luminance_exponent,
            gain: RELATIVE_BRIGHTNESS * frame.gain(),
            pale,
            yellow,
        }
    }
}
