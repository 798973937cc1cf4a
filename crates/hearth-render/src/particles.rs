//! The particle texture, with two texels per particle, uploaded each frame.
//!
//! Shaders fetch particles by index, and one instance draws a block of quads. A software renderer
//! takes 8 µs per instance, which would be 40 ms for 5000 particles with one instance each.

use hearth_core::Instance;

use crate::constants::{BLOCK, ROW, TEXELS};
use crate::error::RenderError;
use crate::gl::Graphics;
use crate::instance;
use crate::target::{bind, texture};

const _: () = assert!(size_of::<Instance>() == TEXELS * size_of::<[f32; 4]>());

/// The particles on the graphics card.
pub struct Particles<G: Graphics> {
    texture: G::Texture,
    /// Rows of the texture.
    rows: usize,
    /// Maximum number of rows.
    max_rows: usize,
    count: usize,
}

impl<G: Graphics> Particles<G> {
    /// An empty texture that grows up to `max_rows` rows.
    pub fn new(gl: &G, max_rows: u32) -> Result<Particles<G>, RenderError> {
        let texture = texture(gl, "splat", glow::CLAMP_TO_EDGE)?;
        // Filtering a float texture needs an extension.
        for filter in [glow::TEXTURE_MIN_FILTER, glow::TEXTURE_MAG_FILTER] {
            gl.tex_parameter(filter, glow::NEAREST);
        }
        Ok(Particles {
            texture,
            rows: 0,
            max_rows: max_rows as usize,
            count: 0,
        })
    }

    /// Number of particles.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Replaces the particles.
    pub fn upload(&mut self, gl: &G, instances: &[Instance]) {
        let instances = &instances[..instances.len().min(self.max_rows * ROW)];
        self.count = instances.len();
        bind(gl, 0, &self.texture);
        let needed = self.count.div_ceil(ROW);
        if needed > self.rows {
            // Powers of two, so that a growing fire rarely reallocates.
            self.rows = needed.next_power_of_two().min(self.max_rows);
            let size = [ROW * TEXELS, self.rows].map(|side| side as u32);
            gl.allocate_texture(glow::RGBA32F, glow::FLOAT, size);
        }
        let (full, rest) = instances.split_at(self.count / ROW * ROW);
        let full_rows = (full.len() / ROW) as u32;
        for (part, row, size) in [
            (full, 0, [(ROW * TEXELS) as u32, full_rows]),
            (rest, full_rows, [(rest.len() * TEXELS) as u32, 1]),
        ] {
            if !part.is_empty() {
                gl.replace_floats([0, row], size, instance::floats(part));
            }
        }
    }

    /// The texture.
    pub fn texture(&self) -> &G::Texture {
        &self.texture
    }

    /// Draws a quad for each particle with the current program.
    pub fn draw(&self, gl: &G) {
        let blocks = self.count.div_ceil(BLOCK);
        gl.draw_instances(6 * BLOCK as i32, blocks as i32);
    }

    /// Frees the texture.
    pub fn destroy(&self, gl: &G) {
        gl.delete_texture(&self.texture);
    }
}
