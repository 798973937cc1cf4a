//! Textures: small ones that are read, and targets that are drawn into.

use crate::error::RenderError;
use crate::format::TargetFormat;
use crate::gl::Gl;

/// Makes a texture with linear filtering and leaves it bound.
pub fn texture(gl: Gl<'_>, wrap: u32) -> Result<glow::Texture, String> {
    let texture = gl.create_texture()?;
    gl.bind_texture(glow::TEXTURE_2D, Some(texture));
    for (name, value) in [
        (glow::TEXTURE_MIN_FILTER, glow::LINEAR),
        (glow::TEXTURE_MAG_FILTER, glow::LINEAR),
        (glow::TEXTURE_WRAP_S, wrap),
        (glow::TEXTURE_WRAP_T, wrap),
    ] {
        gl.tex_parameter_i32(glow::TEXTURE_2D, name, value as i32);
    }
    Ok(texture)
}

/// A texture that is drawn into.
pub struct Target {
    texture: glow::Texture,
    framebuffer: glow::Framebuffer,
    size: [u32; 2],
}

impl Target {
    /// Makes a target, or says why the driver refuses.
    pub fn new(
        gl: Gl<'_>,
        pass: &'static str,
        format: TargetFormat,
        size: [u32; 2],
    ) -> Result<Target, RenderError> {
        let refuse = |log| RenderError::Resource { pass, log };
        gl.active_texture(glow::TEXTURE0);
        let texture = texture(gl, glow::CLAMP_TO_EDGE).map_err(refuse)?;
        let (internal, kind) = format.constants();
        gl.texels(internal, kind, size, None);
        let framebuffer = match gl.create_framebuffer() {
            Ok(framebuffer) => framebuffer,
            Err(log) => {
                gl.delete_texture(texture);
                return Err(refuse(log));
            }
        };
        let target = Target {
            texture,
            framebuffer,
            size,
        };
        gl.bind_framebuffer(glow::FRAMEBUFFER, Some(framebuffer));
        gl.framebuffer_texture_2d(
            glow::FRAMEBUFFER,
            glow::COLOR_ATTACHMENT0,
            glow::TEXTURE_2D,
            Some(texture),
            0,
        );
        let status = gl.check_framebuffer_status(glow::FRAMEBUFFER);
        gl.bind_framebuffer(glow::FRAMEBUFFER, None);
        if status == glow::FRAMEBUFFER_COMPLETE {
            Ok(target)
        } else {
            target.destroy(gl);
            Err(refuse(format!("framebuffer status {status:#x}")))
        }
    }

    /// Width and height.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Draws go here from now on, into the lower left `size` of it.
    pub fn draw_here(&self, gl: Gl<'_>, [width, height]: [u32; 2]) {
        gl.bind_framebuffer(glow::FRAMEBUFFER, Some(self.framebuffer));
        gl.viewport(0, 0, width as i32, height as i32);
    }

    /// Reads of texture `unit` come from here from now on.
    pub fn read_here(&self, gl: Gl<'_>, unit: u32) {
        bind(gl, unit, self.texture);
    }

    /// Frees the target.
    pub fn destroy(&self, gl: Gl<'_>) {
        gl.delete_framebuffer(self.framebuffer);
        gl.delete_texture(self.texture);
    }
}

/// Reads of texture `unit` come from `texture` from now on.
pub fn bind(gl: Gl<'_>, unit: u32, texture: glow::Texture) {
    gl.active_texture(glow::TEXTURE0 + unit);
    gl.bind_texture(glow::TEXTURE_2D, Some(texture));
}
