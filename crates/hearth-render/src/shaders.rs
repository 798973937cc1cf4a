//! The shaders of `shaders/`, as `build.rs` compiles them: the source of both stages, the images
//! that they read, and a struct of uniforms.
//!
//! A uniform that is missing, unknown, or of another size than in the shader is a compile error.

#[cfg(test)]
mod rules;

use crate::image::Image;

/// The first lines of every shader. Phones round `mediump` to eleven bits, too few for
/// coordinates of the picture, and samplers are `lowp` by default.
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
    /// Source of the vertex shader without the header.
    pub vertex: &'static str,
    /// Source of the fragment shader without the header.
    pub fragment: &'static str,
    /// Names of the samplers in the source, in the order of their texture units, and their
    /// images.
    pub samplers: &'static [(&'static str, Image)],
    /// Length of the uniforms.
    pub floats: usize,
    /// Whether they are compiled when a frame first needs them.
    pub is_late: bool,
}

/// The uniforms of a pair of shaders.
pub trait Uniforms {
    /// The pair.
    const SHADER: Shader;

    /// Writes them in the layout of the shader.
    fn write(self, to: &mut [f32; FLOATS]);
}

include!(concat!(env!("OUT_DIR"), "/shaders.rs"));
