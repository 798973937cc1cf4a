//! GPU resources that all fires of a context share: compiled shaders and constant textures.
//!
//! Compiling the shaders takes longer than all other preparations of a fire. A page with thirty
//! fires does it once.

use crate::constants::COLOUR_ENTRIES;
use crate::error::RenderError;
use crate::format::TargetFormat;
use crate::gl::Graphics;
use crate::noise;
use crate::program::Programs;
use crate::target::{Target, texture};

/// Maximum side of a texture that every WebGL2 driver has at least: MAX_TEXTURE_SIZE in the table of
/// limits of OpenGL ES 3.0.
const MIN_LARGEST_TEXTURE: u32 = 2048;

/// The shared resources of the renderers of one context.
pub struct SharedResources<G: Graphics = glow::Context> {
    pub(crate) programs: Programs<G>,
    pub(crate) format: TargetFormat,
    /// Maximum side of a texture.
    pub(crate) max_side: u32,
    pub(crate) noise: G::Texture,
    /// A vertex array without attributes, because no pass reads a buffer.
    pub(crate) no_attributes: G::VertexArray,
}

impl<G: Graphics> SharedResources<G> {
    /// Compiles the shaders and chooses the target format.
    ///
    /// # Errors
    /// The driver rejects a shader, a texture or every format.
    pub fn new(gl: &G) -> Result<SharedResources<G>, RenderError> {
        let mut last = RenderError::NoTarget;
        for &format in TargetFormat::candidates(gl) {
            match SharedResources::with_format(gl, format) {
                Ok(shared) => return Ok(shared),
                Err(error) => last = error,
            }
        }
        Err(last)
    }

    /// As [`new`](SharedResources::new), with a given target format.
    ///
    /// # Errors
    /// The driver rejects a shader, a texture or this format.
    pub fn with_format(gl: &G, format: TargetFormat) -> Result<SharedResources<G>, RenderError> {
        // Only a trial shows whether a format is renderable.
        Target::new(gl, "splat", format, [4, 4])?.destroy(gl);
        Ok(SharedResources {
            programs: Programs::new(gl)?,
            format,
            // A lost context returns nothing.
            max_side: gl.largest_texture().max(MIN_LARGEST_TEXTURE),
            noise: {
                let noise = texture(gl, "shade", glow::REPEAT)?;
                let size = [noise::SIZE as u32; 2];
                gl.allocate_texture(glow::RGBA8, glow::UNSIGNED_BYTE, size);
                gl.replace_bytes(size, &noise::tile());
                // Advection folds noise finer than texels, which needs mipmaps.
                gl.tex_parameter(glow::TEXTURE_MIN_FILTER, glow::LINEAR_MIPMAP_NEAREST);
                gl.generate_mipmap();
                noise
            },
            no_attributes: gl
                .create_vertex_array()
                .ok_or(RenderError::Resource { pass: "splat" })?,
        })
    }

    /// Format of the off-screen targets.
    pub fn target_format(&self) -> TargetFormat {
        self.format
    }

    /// Frees the resources. No renderer of this context may draw afterwards.
    pub fn destroy(self, gl: &G) {
        self.programs.destroy(gl);
        gl.delete_texture(&self.noise);
        gl.delete_vertex_array(&self.no_attributes);
    }
}

/// A texture of a colour table.
pub fn colour_table<G: Graphics>(gl: &G, table: &[[f32; 4]]) -> Result<G::Texture, RenderError> {
    gl.active_texture(0);
    let colours = texture(gl, "shade", glow::CLAMP_TO_EDGE)?;
    let size = [COLOUR_ENTRIES as u32, (table.len() / COLOUR_ENTRIES) as u32];
    let (internal, _) = TargetFormat::Rgba16F.constants();
    gl.allocate_texture(internal, glow::FLOAT, size);
    gl.replace_floats([0, 0], size, table.as_flattened());
    Ok(colours)
}
