//! Creates the resources that a frame needs and frees others.

use super::Renderer;
use super::slices::Noise;
use crate::backdrop::has_backdrop;
use crate::error::RenderError;
use crate::frame_uniforms::FrameUniforms;
use crate::gl::Graphics;
use crate::image::{Image, PLATE, SCENERY, Which};
use crate::palette::Tint;
use crate::passes::PASSES;
use crate::shaders::SOURCES;
use crate::shared::colour_table;
use crate::slices::Slice;

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
        self.tinted = Some((tint, colour_table(gl, &tint.table())?));
        Ok(())
    }

    /// Creates every program and target that a pass of the frame needs.
    pub(super) fn fit_targets(
        &mut self,
        gl: &G,
        frame: &FrameUniforms,
        slices: &[Slice],
    ) -> Result<(), RenderError> {
        self.targets.fit(gl, frame.layout);
        if !has_backdrop(frame.parameters) {
            self.targets.free(gl, SCENERY);
        }
        if !frame.enlarges() {
            self.targets.free(gl, PLATE);
        }
        if frame.advects_noise() {
            for slice in slices {
                self.fit_noise(gl, frame, slice.index)?;
            }
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
                let Some(target) = image.target(Which {
                    level,
                    widest,
                    enlarges: frame.enlarges(),
                    ..Which::default()
                }) else {
                    continue;
                };
                let is_new = self.targets.need(gl, source.name, frame.format, target)?;
                if is_new && target == SCENERY {
                    self.scenery = None;
                }
            }
        }
        Ok(())
    }

    /// Creates the targets of the advected noise of a slice.
    fn fit_noise(
        &mut self,
        gl: &G,
        frame: &FrameUniforms,
        slice: usize,
    ) -> Result<(), RenderError> {
        for image in [
            Image::Flow,
            Image::NoiseOffsets,
            Image::AdvectedNoise,
            Image::AdvectedNoiseBefore,
        ] {
            let which = Which {
                slice,
                ..Which::default()
            };
            if let Some(target) = image.target(which)
                && self
                    .targets
                    .need(gl, "advect_noise", frame.format, target)?
            {
                self.noise[slice] = Noise::default();
            }
        }
        Ok(())
    }
}
