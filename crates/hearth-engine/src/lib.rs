//! The engine behind `<hearth-fire>`: calls and frames in, events and pictures out.
//!
//! One `Engine` draws any number of fires. Scripts reach it through calls (see
//! [`commands`]), and it answers with events (see `events`). Both are plain data, so the
//! engine runs on a page's main thread or in a worker behind the same interface. All fires
//! are drawn on one canvas, one after another (see `shared_canvas`).
//!
//! In a frame the clock tells how much fire is due, the simulation makes whole steps as
//! far as the frame's [`budget`] allows, and the renderer draws the result. Between two
//! calls a warm engine allocates nothing.

// Plain logic, which needs no browser and is tested without one.
pub mod budget;
pub mod commands;
pub mod config;
pub mod grain;
pub mod limits;
pub mod pointer;
pub mod quality;
pub mod requested;
pub mod stats;
pub mod warm;

// What touches the page.
#[cfg(target_arch = "wasm32")]
mod average;
#[cfg(target_arch = "wasm32")]
mod engine;
#[cfg(target_arch = "wasm32")]
pub mod events;
#[cfg(target_arch = "wasm32")]
mod fire;
#[cfg(target_arch = "wasm32")]
mod fire_frame;
#[cfg(target_arch = "wasm32")]
mod pass_times;
#[cfg(target_arch = "wasm32")]
mod pending;
#[cfg(target_arch = "wasm32")]
mod shared_canvas;
#[cfg(target_arch = "wasm32")]
mod wall_clock;
#[cfg(target_arch = "wasm32")]
mod webgl;

#[cfg(target_arch = "wasm32")]
pub use engine::Engine;

/// The allocator. It is 2 KB smaller than std's, and a burning fire allocates nothing.
#[cfg(target_arch = "wasm32")]
#[global_allocator]
static MEMORY: rlsf::SmallGlobalTlsf = rlsf::SmallGlobalTlsf::new();
