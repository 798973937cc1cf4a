//! Pictures of fires without a browser: the library of the command `hearth`.
//!
//! [`Offscreen`] is an OpenGL ES 3 context without a window, with a target that is read back. Any
//! [`Renderer`](hearth_render::Renderer) draws into it:
//!
//! ```
//! use hearth_cli::Offscreen;
//! use hearth_core::{Simulation, preset::Preset};
//! use hearth_render::{History, Renderer, View};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let mut fire = Simulation::new(Preset::all()[0].scene());
//! let mut history = History::default();
//! while fire.time() < 1.0 {
//!     fire.step();
//!     history.follow(&fire);
//! }
//! let mut instances = Vec::new();
//! fire.write_instances(&mut instances);
//!
//! let offscreen = Offscreen::new()?;
//! let gl = offscreen.gl();
//! let mut renderer = Renderer::new(gl)?;
//! renderer.set_output(Some(offscreen.target([640, 360])?));
//! renderer.upload(gl, fire.parameters().display_mode, &instances, &[]);
//! let view = View { width: 640, height: 360, time: fire.time(), ..View::default() };
//! renderer.paint(gl, &view, fire.scene(), &history)?;
//! let rgba = offscreen.pixels();
//! assert!(rgba.iter().any(|&byte| byte > 100));
//! # Ok(())
//! # }
//! ```

mod command;
#[cfg(fuzzing)]
pub mod decoders;
mod egl;
mod error;
mod film;
mod fire;
mod font;
mod json;
mod output;
mod painter;
mod picture;
mod scene;
mod sprites;

pub use command::run;
pub use egl::{Driver, Offscreen, OffscreenError, PACKAGES};
pub use error::Error;
pub use fire::Fire;
pub use painter::{Painter, PictureOptions, resources};
pub use picture::Picture;
