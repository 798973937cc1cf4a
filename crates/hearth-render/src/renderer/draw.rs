//! Draws the passes of a frame.

use super::Renderer;
use super::slices::SliceFrame;
use crate::bounds::Bounds;
use crate::constants::QUADS_PER_INSTANCE;
use crate::frame_uniforms::{FrameUniforms, background};
use crate::gl::Graphics;
use crate::image::{Image, Which};
use crate::particles::draw_quads;
use crate::pass::{Draw, Load, Per, Row};
use crate::passes::PASSES;
use crate::shaders::{FLOATS, SOURCES};
use crate::target::{Target, bind};

/// Name of the passes of all slices in `stats.passes`.
const SLICES: &str = "slices";

/// Content of a cleared target.
const TRANSPARENT: [f32; 4] = [0.0; 4];

impl<G: Graphics> Renderer<G> {
    /// Draws the passes of a frame with these targets. Calls `on_pass` with the name of each pass after it is submitted.
    pub(super) fn draw(
        &self,
        gl: &G,
        frame: &FrameUniforms,
        slices: &[SliceFrame],
        on_pass: &mut dyn FnMut(&'static str),
    ) {
        let mut slices = slices;
        if frame.sheets {
            gl.bind_framebuffer(self.output.as_ref());
            gl.clear(TRANSPARENT);
        }
        for row in PASSES.iter().filter(|row| (row.applies)(frame)) {
            if row.per == Per::Frame {
                for level in row.levels.of(frame.widest_blur()) {
                    self.draw_pass(gl, frame, row, level, row.load);
                }
                on_pass(row.name);
            } else if !slices.is_empty() {
                self.draw_slices(gl, std::mem::take(&mut slices));
                on_pass(SLICES);
            }
        }
    }

    /// Draws the light of the slices, each over those behind it.
    fn draw_slices(&self, gl: &G, slices: &[SliceFrame]) {
        let mut loads = [Load::Clear; 2];
        for at in 0..slices.len() {
            // An atlas shows each slice alone, from the front; then each goes under those before it.
            let slice = if slices[at].frame.sheets {
                loads = [Load::Clear; 2];
                &slices[at]
            } else {
                &slices[slices.len() - 1 - at]
            };
            let applies = |row: &&Row| (row.applies)(&slice.frame);
            let rows = |per| {
                PASSES
                    .iter()
                    .filter(applies)
                    .filter(move |row| row.per == per)
            };
            for sample in &slice.samples {
                rows(Per::Sample).for_each(|row| self.draw_pass(gl, sample, row, 0, row.load));
            }
            for row in rows(Per::Slice) {
                // The slices behind share a target, and the front one is over them.
                let load = match row.target {
                    Image::Light => {
                        let target = usize::from(slice.frame.slice.index > 0);
                        std::mem::replace(&mut loads[target], Load::Keep)
                    }
                    _ => row.load,
                };
                self.draw_pass(gl, &slice.frame, row, 0, load);
                if let (Draw::Particles, Some(later)) = (row.draw, &slice.later) {
                    self.draw_pass(gl, later, row, 0, Load::Keep);
                }
            }
        }
    }

    fn draw_pass(&self, gl: &G, frame: &FrameUniforms, row: &Row, level: usize, load: Load) {
        let size = match self.target(frame, row.target, level) {
            Some(target) => {
                let part = if row.target == Image::Field {
                    frame.used
                } else {
                    target.size()
                };
                target.bind_for_drawing(gl, part);
                part
            }
            None => {
                gl.bind_framebuffer(self.output.as_ref());
                let slice = (row.per != Per::Frame).then_some(frame.slice.index);
                let (corner, size) = if frame.sheets {
                    frame.layout.in_atlas(slice)
                } else {
                    ([0, 0], frame.layout.picture)
                };
                gl.viewport(corner, size);
                size
            }
        };
        if load == Load::Clear {
            gl.clear(match row.target {
                Image::Picture => background(frame.parameters.background),
                _ => TRANSPARENT,
            });
        }
        let source = &SOURCES[row.shader as usize];
        for (unit, &(_, image)) in source.samplers.iter().enumerate() {
            if let Some(texture) = self.texture(frame, row.draw, image, level) {
                bind(gl, unit as u32, texture);
            }
        }
        let mut uniforms = [0.0; FLOATS];
        (row.uniforms)(frame, level, &mut uniforms);
        let programs = &self.shared.programs;
        programs.activate(gl, row.shader, &uniforms[..source.floats]);
        let blends = row.blend.factors();
        if let Some((source, destination)) = blends {
            gl.enable(glow::BLEND);
            gl.blend_func(source, destination);
            gl.blend_equation(row.blend.equation(frame.format.is_rooted()));
        }
        match row.draw {
            Draw::All => gl.draw_triangle(),
            Draw::Reach => draw_part(gl, frame, &frame.reach, size),
            Draw::Behind => draw_part(gl, frame, &frame.behind.unwrap_or_default(), size),
            Draw::Halo => draw_part(gl, frame, &frame.halo(), size),
            Draw::Particles => {
                draw_quads(gl, frame.particles.count.div_ceil(frame.particles.stride))
            }
            Draw::Embers => draw_quads(gl, self.embers.count()),
            Draw::Solids => draw_solids(gl, frame.solids - frame.cladding),
            Draw::Cladding => draw_solids(gl, frame.cladding),
            Draw::Backdrop | Draw::Shadows => {
                let is_wall = row.draw == Draw::Backdrop && frame.has_wall();
                let top = if is_wall {
                    f32::INFINITY
                } else {
                    frame.horizon()
                };
                // An enlarged row blends with the one above it.
                let above = f32::from(row.target == Image::Plate && frame.enlarges());
                let upper = frame.viewport.row(top, size[1]).ceil() + above;
                gl.enable(glow::SCISSOR_TEST);
                scissor(gl, [0.0; 2], [size[0] as f32, upper]);
                if row.draw == Draw::Backdrop {
                    gl.draw_triangle();
                } else {
                    draw_solids(gl, frame.solids);
                }
                gl.disable(glow::SCISSOR_TEST);
            }
        }
        if blends.is_some() {
            gl.disable(glow::BLEND);
        }
    }

    /// The target of an image; `None` for the picture and for images that no pass draws.
    fn target(&self, frame: &FrameUniforms, image: Image, level: usize) -> Option<&Target<G>> {
        let target = image.target(Which {
            level,
            widest: frame.widest_blur(),
            slice: frame.slice.index,
            newest: frame.advected.newest,
            enlarges: frame.enlarges(),
        })?;
        self.targets.get(target).map(|(_, target)| target)
    }

    /// The texture of an image in a pass with that geometry.
    fn texture(
        &self,
        frame: &FrameUniforms,
        draw: Draw,
        image: Image,
        level: usize,
    ) -> Option<&G::Texture> {
        match image {
            Image::Particles if draw == Draw::Embers => Some(self.embers.texture()),
            Image::Particles if matches!(draw, Draw::Solids | Draw::Cladding | Draw::Shadows) => {
                Some(self.solids.texture.texture())
            }
            Image::Particles if frame.particles.row.is_some() => self.ring.texture(),
            Image::Particles => Some(self.particles.texture()),
            Image::Noise => Some(&self.shared.noise),
            Image::Palette => self.tinted.as_ref().map(|(_, colours)| colours),
            _ => self.target(frame, image, level).map(Target::texture),
        }
    }
}

/// Draws an instance for each of `count` solids, whose quads are its parts.
fn draw_solids<G: Graphics>(gl: &G, count: usize) {
    draw_quads(gl, count * QUADS_PER_INSTANCE);
}

/// Draws the part of a target that `bounds` touch. Each texel once: passes blend.
#[inline(never)]
fn draw_part<G: Graphics>(gl: &G, frame: &FrameUniforms, bounds: &Bounds, size: [u32; 2]) {
    let viewport = &frame.viewport;
    let mut lower = viewport.row(bounds.heights[0], size[1]).floor();
    gl.enable(glow::SCISSOR_TEST);
    for (row, range) in bounds.rows.iter().enumerate() {
        let upper = viewport.row(bounds.height(row + 1), size[1]).ceil();
        let [left, right] = range.map(|x| viewport.column(x, size[0]));
        scissor(gl, [left.floor(), lower], [right.ceil(), upper]);
        gl.draw_triangle();
        lower = upper;
    }
    gl.disable(glow::SCISSOR_TEST);
}

/// Limits what is drawn to the texels between two corners.
fn scissor<G: Graphics>(gl: &G, from: [f32; 2], to: [f32; 2]) {
    let [x, y] = from.map(|at| at as i32);
    let [right, upper] = to.map(|at| at as i32);
    gl.scissor(x, y, (right - x).max(0), (upper - y).max(0));
}
