//! A context without a window, and what draws into it.

use std::rc::Rc;

use hearth_cli::Offscreen;
use hearth_render::{Renderer, SharedResources, TargetFormat};

use crate::fire::{Fire, limits};
use crate::{Failure, foreign};

/// A context with the GPU resources that all its fires share.
pub struct Painter {
    offscreen: Offscreen,
    shared: Rc<SharedResources>,
    /// Those with fields in eight bits.
    eight_bits: Rc<SharedResources>,
}

impl Painter {
    /// A painter that keeps fields in the best format that the driver has.
    pub fn new() -> Result<Painter, Failure> {
        let offscreen = Offscreen::new()?;
        let shared = SharedResources::new(offscreen.gl())?;
        let eight_bits = SharedResources::with_format(offscreen.gl(), TargetFormat::Rgba8)?;
        Ok(Painter {
            offscreen,
            shared: Rc::new(shared),
            eight_bits: Rc::new(eight_bits),
        })
    }

    /// The format of its fields.
    pub fn format(&self) -> &'static str {
        self.shared.target_format().name()
    }

    /// The calls of OpenGL.
    pub fn gl(&self) -> &glow::Context {
        self.offscreen.gl()
    }

    /// A renderer of one fire, at that quality, with fields in the format of that name, or in the best.
    pub fn renderer(&self, quality: &str, format: &str) -> Result<Renderer, Failure> {
        let shared = match format {
            "" => &self.shared,
            "rgba8" => &self.eight_bits,
            other => return Err(format!("no format `{other}`").into()),
        };
        let mut renderer = Renderer::within(self.gl(), Rc::clone(shared))?;
        renderer.set_limits(limits(quality)?);
        Ok(renderer)
    }

    /// Draws a fire as it burns now; returns its pixels, premultiplied sRGB from the upper left.
    pub fn draw(
        &self,
        renderer: &mut Renderer,
        fire: &mut Fire,
        size: [u32; 2],
    ) -> Result<Vec<u8>, Failure> {
        self.paint(renderer, fire, size, &mut |_| {})?;
        Ok(self.offscreen.pixels())
    }

    /// Draws a fire; returns its pixels, and its light before glow and tone map, without that of embers:
    /// linear sRGB and coverage. There is none in display modes without light.
    pub fn draw_with_light(
        &self,
        renderer: &mut Renderer,
        fire: &mut Fire,
        size: [u32; 2],
    ) -> Result<(Vec<u8>, Vec<f32>), Failure> {
        let (gl, mut light) = (self.gl(), Vec::new());
        self.paint(renderer, fire, size, &mut |pass| {
            if pass == "shade" || pass == "slices" {
                light = target(gl);
            }
        })?;
        Ok((self.offscreen.pixels(), light))
    }

    fn paint(
        &self,
        renderer: &mut Renderer,
        fire: &mut Fire,
        size: [u32; 2],
        on_pass: &mut dyn FnMut(&'static str),
    ) -> Result<(), Failure> {
        renderer.set_output(Some(self.offscreen.target(size)?));
        fire.draw(self.gl(), renderer, size, on_pass)?;
        foreign::report(self.gl())
    }
}

/// The light in the target of half floats that was drawn into last.
fn target(gl: &glow::Context) -> Vec<f32> {
    foreign::read(gl, foreign::view(gl))
}
