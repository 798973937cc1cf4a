//! The particles as the graphics card gets them: a texture, two texels each,
//! sent anew each frame.
//!
//! The shaders read it by number, and one instance draws a block of quads. An
//! instance for each quad would be shorter to write, but a software renderer
//! pays some eight microseconds for every instance: with 5000 particles, 40 ms.

use hearth_core::Instance;

use crate::error::RenderError;
use crate::gl::Graphics;
use crate::program::Program;
use crate::target::{bind, texture};

/// Quads that one instance draws; `BLOCK` in `shaders/particle.glsl`.
const BLOCK: usize = 64;
/// Particles in a row of the texture; `ROW` in `shaders/particle.glsl`.
const ROW: usize = 512;
/// Texels of a particle.
const TEXELS: usize = size_of::<Instance>() / size_of::<[f32; 4]>();

/// The particles on the graphics card.
pub struct Particles<G: Graphics> {
    texture: G::Texture,
    /// Rows that the texture has.
    rows: usize,
    /// Most rows that it may have.
    most: usize,
    count: usize,
}

impl<G: Graphics> Particles<G> {
    /// Room for no particle yet, and for at most `most` rows of them.
    pub fn new(gl: &G, most: u32) -> Result<Particles<G>, RenderError> {
        let texture = texture(gl, "splat", glow::CLAMP_TO_EDGE)?;
        // A float texture that is not read texel by texel needs an extension.
        for filter in [glow::TEXTURE_MIN_FILTER, glow::TEXTURE_MAG_FILTER] {
            gl.tex_parameter(filter, glow::NEAREST);
        }
        Ok(Particles {
            texture,
            rows: 0,
            most: most as usize,
            count: 0,
        })
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Sends them.
    pub fn upload(&mut self, gl: &G, instances: &[Instance]) {
        let instances = &instances[..instances.len().min(self.most * ROW)];
        self.count = instances.len();
        bind(gl, 0, &self.texture);
        let needed = self.count.div_ceil(ROW);
        if needed > self.rows {
            // Doubled, so that a growing fire seldom asks for more.
            self.rows = needed.next_power_of_two().min(self.most);
            let size = [ROW * TEXELS, self.rows].map(|side| side as u32);
            gl.make_room(glow::RGBA32F, glow::FLOAT, size);
        }
        let (full, rest) = instances.split_at(self.count / ROW * ROW);
        let full_rows = (full.len() / ROW) as u32;
        for (part, row, size) in [
            (full, 0, [(ROW * TEXELS) as u32, full_rows]),
            (rest, full_rows, [(rest.len() * TEXELS) as u32, 1]),
        ] {
            if !part.is_empty() {
                gl.replace_floats([0, row], size, part.as_flattened());
            }
        }
    }

    /// Draws a quad for each with the current program, which is `program`.
    pub fn draw(&self, gl: &G, program: &Program<G>) {
        program.set(gl, "count", [self.count as f32, 0.0, 0.0, 0.0]);
        bind(gl, 0, &self.texture);
        let blocks = self.count.div_ceil(BLOCK);
        gl.draw_instances(6 * BLOCK as i32, blocks as i32);
    }

    /// Frees the texture.
    pub fn destroy(&self, gl: &G) {
        gl.delete_texture(&self.texture);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shader_divides_the_particles_the_same_way() {
        let shader = include_str!("../../../shaders/particle.glsl");
        assert!(shader.contains(&format!("BLOCK = {BLOCK};")));
        assert!(shader.contains(&format!("ROW = {ROW};")));
        assert!(shader.contains(&format!("number % ROW * {TEXELS},")));
    }
}
