//! Draws the shadows of solids on the ground.

use crate::frame_uniforms::FrameUniforms;
use crate::image::Image;
use crate::pass::{Blend, Draw, Pass};
use crate::shaders::uniforms;

/// Darkness of the middle of a shadow: on a ground, and on a page that other light falls on.
const DARKNESS: f32 = 0.8;
const PAGE_DARKNESS: f32 = 0.35;
/// Height above the lower edge of a picture over which a page's shadow ends, as a share of the picture.
const EDGE: f32 = 0.05;

/// The ground is dark where the outline of a solid, laid down from its foot, covers it.
pub struct Shadow;

impl Pass for Shadow {
    const TARGET: Image = Image::Plate;
    const BLEND: Blend = Blend::Over;
    const DRAW: Draw = Draw::Shadows;
    type Uniforms = uniforms::Shadow;

    fn applies(frame: &FrameUniforms) -> bool {
        frame.has_backdrop() && frame.solids > 0
    }

    fn uniforms(frame: &FrameUniforms, _: usize) -> uniforms::Shadow {
        let (viewport, page) = (&frame.viewport, frame.page());
        let [clip_scale, clip_offset] = viewport.to_clip();
        uniforms::Shadow {
            clip_scale,
            clip_offset,
            first_solid: 0.0,
            count: frame.solids as f32,
            margin: 0.0,
            horizon: frame.horizon(),
            picture: [viewport.metres[1], viewport.floor[1]],
            darkness: DARKNESS + (PAGE_DARKNESS - DARKNESS) * page,
            edge: (EDGE * page).max(f32::MIN_POSITIVE),
        }
    }
}
