//! The particle texture, with two texels per particle, uploaded each frame.
//!
//! Shaders fetch particles by index, and one instance draws a block of quads. A software renderer
//! takes 8 µs per instance, which would be 40 ms for 5000 particles with one instance each.

use hearth_core::Instance;

use crate::constants::{PARTICLES_PER_ROW, QUADS_PER_INSTANCE, TEXELS_PER_PARTICLE};
use crate::error::RenderError;
use crate::gl::Graphics;
use crate::instance;
use crate::target::{bind, texture};

const _: () = assert!(size_of::<Instance>() == TEXELS_PER_PARTICLE * size_of::<[f32; 4]>());

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
        let instances = &instances[..instances.len().min(self.max_rows * PARTICLES_PER_ROW)];
        self.count = instances.len();
        bind(gl, 0, &self.texture);
        let needed = self.count.div_ceil(PARTICLES_PER_ROW);
        if needed > self.rows {
            // Powers of two, so that a growing fire rarely reallocates.
            self.rows = needed.next_power_of_two().min(self.max_rows);
            let size = [PARTICLES_PER_ROW * TEXELS_PER_PARTICLE, self.rows].map(|side| side as u32);
            gl.allocate_texture(glow::RGBA32F, glow::FLOAT, size);
        }
        let (full, rest) = instances.split_at(self.count / PARTICLES_PER_ROW * PARTICLES_PER_ROW);
        let full_rows = (full.len() / PARTICLES_PER_ROW) as u32;
        for (part, row, size) in [
            (
                full,
                0,
                [(PARTICLES_PER_ROW * TEXELS_PER_PARTICLE) as u32, full_rows],
            ),
            (
                rest,
                full_rows,
                [(rest.len() * TEXELS_PER_PARTICLE) as u32, 1],
            ),
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

    /// Frees the texture.
    pub fn destroy(&self, gl: &G) {
        gl.delete_texture(&self.texture);
    }
}

/// Draws a quad for each of `count` particles with the current program.
pub fn draw_quads<G: Graphics>(gl: &G, count: usize) {
    let blocks = count.div_ceil(QUADS_PER_INSTANCE);
    gl.draw_instances(6 * QUADS_PER_INSTANCE as i32, blocks as i32);
}
