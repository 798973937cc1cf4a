//! Creates the resources that a frame needs and frees others.

use super::{NOISE_OFFSETS, Renderer, SCENERY};
use crate::error::RenderError;
use crate::frame_uniforms::{FrameUniforms, has_backdrop};
use crate::gl::Graphics;
use crate::palette::Tint;
use crate::passes::PASSES;
use crate::shaders::SOURCES;
use crate::shared::colour_table;

impl<G: Graphics> Renderer<G> {
    /// Creates the colour table of a tint.
    pub(super) fn fit_colours(&mut self, gl: &G, tint: Tint) -> Result<(), RenderError> {
        if self
            .tinted
            .as_ref()
            .is_some_and(|(drawn, _)| *drawn == tint)
        {
            return Ok(());
        }
        if let Some((_, old)) = self.tinted.take() {
            gl.delete_texture(&old);
        }
        if !tint.is_black_body() {
            self.tinted = Some((tint, colour_table(gl, &tint.table())?));
        }
        Ok(())
    }

    /// Creates every program and target that a pass of the frame needs.
    pub(super) fn fit_targets(&mut self, gl: &G, frame: &FrameUniforms) -> Result<(), RenderError> {
        self.targets.fit(gl, frame.layout);
        if !has_backdrop(frame.parameters) {
            self.targets.free(gl, SCENERY);
        }
        let widest = frame.widest_blur();
        for row in PASSES.iter().filter(|row| (row.applies)(frame)) {
            self.shared.programs.need(gl, row.shader)?;
            let source = &SOURCES[row.shader as usize];
            let read = source.samplers.iter().map(|(_, image)| *image);
            let images = read.chain([row.target]);
            for (image, level) in
                images.flat_map(|image| row.levels.of(widest).map(move |level| (image, level)))
            {
                // The two targets of the noise advection are created together.
                let Some(target) = image.target(level, widest, 0) else {
                    continue;
                };
                let is_new = self.targets.need(gl, source.name, frame.format, target)?;
                if is_new && target == SCENERY {
                    self.scenery = None;
                }
                if is_new && target == NOISE_OFFSETS {
                    self.fit_noise_offsets(gl, frame)?;
                }
            }
        }
        Ok(())
    }

    /// Creates the targets of the noise advection, with the offsets of a paused fire or empty.
    fn fit_noise_offsets(&mut self, gl: &G, frame: &FrameUniforms) -> Result<(), RenderError> {
        self.targets
            .need(gl, "advect_noise", frame.format, NOISE_OFFSETS + 1)?;
        match self.carried.take() {
            Some(carried) if carried.layout == frame.layout => {
                for target in [NOISE_OFFSETS, NOISE_OFFSETS + 1] {
                    if let Some((_, target)) = self.targets.get(target) {
                        target.write(gl, &carried.texels);
                    }
                }
            }
            _ => self.motion.advection.forget(),
        }
        Ok(())
    }
}
