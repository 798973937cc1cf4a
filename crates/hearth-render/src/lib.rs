//! Draws a fire with WebGL2, from particles to pixels.
//!
//! Particles are splatted as smooth kernels into fields (weight, temperature,
//! soot or glow and smoke), so the picture shows continuous gas instead of
//! dots. The fields are warped and eroded by noise, which rises with the classic
//! model's flame and is carried along by the combustion model's gas; they shine
//! as a black body, bloom, and are tone mapped into premultiplied sRGB.
//!
//! A [`Renderer`] owns its handles and borrows the context in each call; fires of
//! one context share a [`Studio`]. Neither knows the page or any user interface.

mod blackbody;
mod camera;
mod cie;
mod drift;
mod error;
mod format;
mod gl;
mod layout;
mod noise;
mod palette;
mod particles;
mod passes;
mod program;
mod renderer;
mod scale;
#[cfg(test)]
mod shaders;
mod studio;
mod survey;
mod target;
mod targets;

pub use blackbody::{Chromaticity, chromaticity, linear_srgb, luminance};
pub use camera::{Camera, Fit};
pub use error::RenderError;
pub use format::TargetFormat;
pub use gl::Graphics;
pub use layout::Lines;
pub use renderer::{Carried, Motion, Renderer, View};
pub use studio::Studio;
