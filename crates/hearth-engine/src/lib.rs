//! The engine behind `<hearth-fire>`: canvases, the frame loop and messages.
//!
//! One `Engine` draws any number of fires. It is spoken to in messages only
//! (see [`message`]) and answers in messages only (see `outbox`), all of them
//! postable, so that it runs on a page's main thread or in a worker without a
//! change to anybody's API. All fires are drawn on one canvas, one after another
//! (see `shared_canvas`); its surroundings call it for each frame and take the pictures away.
//!
//! A frame goes one way: the clock says how much fire is due, the simulation makes
//! whole steps for it as far as the frame's [`budget`] allows, the renderer draws
//! what came of it. Between two messages nothing of it allocates once it is warm.

// Plain logic, which needs no browser and is tested without one.
pub mod budget;
pub mod config;
mod fields;
pub mod grain;
pub mod limits;
pub mod message;
pub mod quality;
pub mod raw;
pub mod scene;
pub mod view;
pub mod wanted;
pub mod warm;

// What touches the page.
#[cfg(target_arch = "wasm32")]
mod asked;
#[cfg(target_arch = "wasm32")]
mod average;
#[cfg(target_arch = "wasm32")]
mod engine;
#[cfg(target_arch = "wasm32")]
mod fire;
#[cfg(target_arch = "wasm32")]
mod fire_frame;
#[cfg(target_arch = "wasm32")]
mod host;
#[cfg(target_arch = "wasm32")]
pub mod outbox;
#[cfg(target_arch = "wasm32")]
mod pass_times;
#[cfg(target_arch = "wasm32")]
mod shared_canvas;
#[cfg(target_arch = "wasm32")]
mod webgl;

#[cfg(target_arch = "wasm32")]
pub use engine::Engine;

/// wasm's memory, as it is given out: std's own way of that is 2 KB more to download, and
/// a fire that burns asks for none.
#[cfg(target_arch = "wasm32")]
#[global_allocator]
static MEMORY: rlsf::SmallGlobalTlsf = rlsf::SmallGlobalTlsf::new();
