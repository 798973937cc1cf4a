//! The shaders of `shaders/`, as `build.rs` compiles them: the text of both stages, the images
//! that they read, and a struct of uniforms for each.
//!
//! A field that a shader does not declare, or that has another number of components there,
//! does not compile; nor does a field that is left out.

#[cfg(test)]
mod rules;

use crate::image::Image;

/// What every shader starts with: one version, one precision. Phones round `mediump` to eleven
/// bits, too few for a place in the picture, and a sampler is `lowp` by default.
pub const HEADER: &str = "#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
";

/// Name of the array that holds all uniforms of a program.
pub const UNIFORMS: &str = "U";

/// A compiled pair of shaders.
pub struct Source {
    /// Name of its files.
    pub name: &'static str,
    /// Text of the vertex shader, without the header.
    pub vertex: &'static str,
    /// Text of the fragment shader, without the header.
    pub fragment: &'static str,
    /// Samplers as the text names them, in the order of their texture units, and the image that
    /// each reads.
    pub samplers: &'static [(&'static str, Image)],
    /// Length of its uniforms.
    pub floats: usize,
}

/// The uniforms of a pair of shaders.
pub trait Uniforms {
    /// The pair.
    const SHADER: Shader;

    /// Writes them as the shader reads them.
    fn write(self, to: &mut [f32; FLOATS]);
}

include!(concat!(env!("OUT_DIR"), "/shaders.rs"));
