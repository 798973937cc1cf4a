//! A WebGL2 renderer of a fire, from particles to pixels.
//!
//! Particles are splatted as smooth kernels into fields (weight, temperature, soot or glow, and
//! smoke), so the picture shows continuous gas instead of dots. Noise warps and erodes the
//! fields. It rises with the classic model's flame and is advected by the combustion model's
//! gas. The fields emit light as a black body, bloom, and are tone mapped to premultiplied sRGB.
//!
//! A [`Renderer`] owns its handles and borrows the context in each call. Fires of one context
//! share [`SharedResources`]. Neither depends on a page or a user interface. A pass is a file in
//! `passes/` and its shaders.

mod advection;
mod backdrop;
mod blackbody;
mod bounds;
mod camera;
mod cie;
mod constants;
mod embers;
mod error;
mod format;
mod frame_uniforms;
mod gl;
#[cfg(test)]
#[path = "../build/glsl/mod.rs"]
mod glsl;
mod half;
mod history;
mod image;
mod instance;
mod kernel;
mod light;
mod noise;
mod palette;
mod particles;
mod pass;
mod passes;
mod program;
mod renderer;
mod resolution;
mod ring;
mod rise;
mod scale;
mod shaders;
mod shared;
mod slices;
mod solids;
mod surroundings;
mod target;
mod targets;
#[cfg(test)]
#[path = "../build/values.rs"]
mod values;
mod viewport;

pub use blackbody::{Chromaticity, NEUTRAL_KELVIN, chromaticity, linear_srgb, luminance};
pub use camera::{Camera, Fit};
pub use error::RenderError;
pub use format::TargetFormat;
pub use gl::Graphics;
pub use history::{History, Moment};
pub use image::memory;
pub use light::light;
pub use palette::{light_colour, pale};
pub use renderer::{Renderer, View};
pub use resolution::{ResolutionLimits, atlas_size};
pub use scale::Scale;
pub use shared::SharedResources;
pub use viewport::Viewport;

// Compiles the examples of the README as doc tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadMe;
