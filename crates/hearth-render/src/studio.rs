//! What all fires that are drawn in one context share: compiled passes, and the
//! pictures that none of them changes.
//!
//! A page may have thirty fires. Compiling shaders takes a driver longer than all
//! else that a new fire needs, so only the first one waits for it.

use crate::blackbody::{self, ENTRIES};
use crate::error::RenderError;
use crate::format::TargetFormat;
use crate::gl::Graphics;
use crate::noise;
use crate::passes::Passes;
use crate::target::{Target, texture};

/// The shared part of the renderers of one context.
pub struct Studio<G: Graphics = glow::Context> {
    pub(crate) passes: Passes<G>,
    pub(crate) format: TargetFormat,
    /// Longest side of a texture.
    pub(crate) most: u32,
    pub(crate) noise: G::Texture,
    pub(crate) black_body: G::Texture,
    /// Without attributes: no pass reads a buffer, whatever else the context holds.
    pub(crate) nothing: G::VertexArray,
}

impl<G: Graphics> Studio<G> {
    /// Compiles every pass and chooses the target format.
    ///
    /// # Errors
    /// The driver refuses a shader, a texture or every format.
    pub fn new(gl: &G) -> Result<Studio<G>, RenderError> {
        let mut last = RenderError::NoTarget;
        for &format in TargetFormat::candidates(gl) {
            match Studio::with_format(gl, format) {
                Ok(studio) => return Ok(studio),
                Err(error) => last = error,
            }
        }
        Err(last)
    }

    /// As [`new`](Studio::new), with a given target format.
    ///
    /// # Errors
    /// The driver refuses a shader, a texture or this format.
    pub fn with_format(gl: &G, format: TargetFormat) -> Result<Studio<G>, RenderError> {
        // Whether a format can be drawn into is known only once it was tried.
        Target::new(gl, "splat", format, [4, 4])?.destroy(gl);
        Ok(Studio {
            passes: Passes::new(gl)?,
            format,
            most: gl.largest_texture(),
            noise: {
                let noise = texture(gl, "shade", glow::REPEAT)?;
                let size = [noise::SIZE as u32; 2];
                gl.make_room(glow::RGBA8, glow::UNSIGNED_BYTE, size);
                gl.replace_bytes(size, &noise::tile());
                // Ever smaller copies, to be read where it is seen from farther away.
                gl.tex_parameter(glow::TEXTURE_MIN_FILTER, glow::LINEAR_MIPMAP_NEAREST);
                gl.generate_mipmap();
                noise
            },
            black_body: colour_table(gl, &blackbody::table())?,
            nothing: gl.create_vertex_array().ok_or(RenderError::none("splat"))?,
        })
    }

    /// The pixels of the off-screen targets.
    pub fn target_format(&self) -> TargetFormat {
        self.format
    }

    /// Frees everything. No renderer of this context may draw any more.
    pub fn destroy(self, gl: &G) {
        self.passes.destroy(gl);
        gl.delete_texture(&self.noise);
        gl.delete_texture(&self.black_body);
        gl.delete_vertex_array(&self.nothing);
    }
}

/// A table of colours by temperature, as a texture.
pub fn colour_table<G: Graphics>(gl: &G, table: &[[f32; 4]]) -> Result<G::Texture, RenderError> {
    gl.active_texture(0);
    let colours = texture(gl, "shade", glow::CLAMP_TO_EDGE)?;
    let size = [ENTRIES as u32, 1];
    let (internal, _) = TargetFormat::Rgba16F.constants();
    gl.make_room(internal, glow::FLOAT, size);
    gl.replace_floats([0, 0], size, table.as_flattened());
    Ok(colours)
}
