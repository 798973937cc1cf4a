//! The off-screen targets of one layout. They follow from the passes that read or write them.

use crate::error::RenderError;
use crate::format::TargetFormat;
use crate::gl::Graphics;
use crate::image::{TARGETS, format_and_size};
use crate::resolution::Layout;
use crate::target::Target;

/// The targets that frames of one layout have needed.
pub struct Targets<G: Graphics> {
    layout: Option<Layout>,
    made: [Option<Target<G>>; TARGETS],
}

impl<G: Graphics> Targets<G> {
    /// No targets.
    pub fn new() -> Targets<G> {
        Targets {
            layout: None,
            made: [const { None }; TARGETS],
        }
    }

    /// Frees the targets of other layouts.
    pub fn fit(&mut self, gl: &G, layout: Layout) {
        if self.layout != Some(layout) {
            // Before the new targets: a phone may not have the memory for both.
            self.destroy(gl);
            self.layout = Some(layout);
        }
    }

    /// Creates a target unless it exists. Returns whether it is new.
    pub fn need(
        &mut self,
        gl: &G,
        pass: &'static str,
        format: TargetFormat,
        target: usize,
    ) -> Result<bool, RenderError> {
        let (Some(layout), None) = (&self.layout, &self.made[target]) else {
            return Ok(false);
        };
        let (format, size) = format_and_size(target, layout, format);
        self.made[target] = Some(Target::new(gl, pass, format, size)?);
        Ok(true)
    }

    /// The layout and a target of it.
    pub fn get(&self, target: usize) -> Option<(&Layout, &Target<G>)> {
        self.layout.as_ref().zip(self.made[target].as_ref())
    }

    /// Frees a target.
    pub fn free(&mut self, gl: &G, target: usize) {
        if let Some(old) = self.made[target].take() {
            old.destroy(gl);
        }
    }

    /// Frees all targets.
    pub fn destroy(&mut self, gl: &G) {
        for target in 0..TARGETS {
            self.free(gl, target);
        }
    }
}
