//! Textures and render targets.

use crate::error::RenderError;
use crate::format::TargetFormat;
use crate::gl::Graphics;

/// Creates a texture with linear filtering and leaves it bound.
pub fn texture<G: Graphics>(
    gl: &G,
    pass: &'static str,
    wrap: u32,
) -> Result<G::Texture, RenderError> {
    let texture = gl.create_texture().ok_or(RenderError::Resource { pass })?;
    gl.bind_texture(&texture);
    for (name, value) in [
        (glow::TEXTURE_MIN_FILTER, glow::LINEAR),
        (glow::TEXTURE_MAG_FILTER, glow::LINEAR),
        (glow::TEXTURE_WRAP_S, wrap),
        (glow::TEXTURE_WRAP_T, wrap),
    ] {
        gl.tex_parameter(name, value);
    }
    Ok(texture)
}

/// A render target: a texture and its framebuffer.
pub struct Target<G: Graphics> {
    texture: G::Texture,
    framebuffer: G::Framebuffer,
    size: [u32; 2],
}

impl<G: Graphics> Target<G> {
    /// Creates a target.
    pub fn new(
        gl: &G,
        pass: &'static str,
        format: TargetFormat,
        size: [u32; 2],
    ) -> Result<Target<G>, RenderError> {
        gl.active_texture(0);
        let texture = texture(gl, pass, glow::CLAMP_TO_EDGE)?;
        let (internal, kind) = format.constants();
        gl.allocate_texture(internal, kind, size);
        let Some(framebuffer) = gl.create_framebuffer() else {
            gl.delete_texture(&texture);
            return Err(RenderError::Resource { pass });
        };
        gl.bind_framebuffer(Some(&framebuffer));
        let status = gl.attach_texture(&texture);
        if status == glow::FRAMEBUFFER_COMPLETE {
            // Native drivers do not clear it.
            gl.clear([0.0; 4]);
        }
        gl.bind_framebuffer(None);
        let target = Target {
            texture,
            framebuffer,
            size,
        };
        if status == glow::FRAMEBUFFER_COMPLETE {
            Ok(target)
        } else {
            target.destroy(gl);
            Err(RenderError::Resource { pass })
        }
    }

    /// Width and height.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Directs drawing to the lower left part of that size.
    pub fn bind_for_drawing(&self, gl: &G, size: [u32; 2]) {
        gl.bind_framebuffer(Some(&self.framebuffer));
        gl.viewport([0, 0], size);
    }

    /// The texture.
    pub fn texture(&self) -> &G::Texture {
        &self.texture
    }

    /// Frees the target.
    pub fn destroy(&self, gl: &G) {
        gl.delete_framebuffer(&self.framebuffer);
        gl.delete_texture(&self.texture);
    }
}

/// Binds `texture` to a texture unit.
pub fn bind<G: Graphics>(gl: &G, unit: u32, texture: &G::Texture) {
    gl.active_texture(unit);
    gl.bind_texture(texture);
}
