//! The engine of `<hearth-fire>`: calls and frames in, events and pictures out.
//!
//! One `Engine` simulates and draws any number of fires. Scripts send [`commands`], and the
//! engine posts `events`. Both are plain data, so the engine runs on the main thread or in a
//! worker behind one interface. All fires share one canvas (see `shared_canvas`).
//!
//! In each frame, the clock determines the due fire time, the simulation makes whole steps
//! within the frame's [budget](pacing::thread_budget), and the renderer draws the result. Frames of a running fire
//! allocate nothing.

// Logic that is tested without a browser.
pub mod change;
pub mod commands;
pub mod pacing;
pub mod pointer;
pub mod stats;

// Bindings to the page.
#[cfg(target_arch = "wasm32")]
mod engine;
#[cfg(target_arch = "wasm32")]
pub mod events;
#[cfg(target_arch = "wasm32")]
mod fire;
#[cfg(target_arch = "wasm32")]
mod fire_renderer;
#[cfg(target_arch = "wasm32")]
mod pass_times;
#[cfg(target_arch = "wasm32")]
mod shared_canvas;
#[cfg(target_arch = "wasm32")]
mod sound;
#[cfg(target_arch = "wasm32")]
mod wall_clock;
#[cfg(target_arch = "wasm32")]
mod webgl;

#[cfg(target_arch = "wasm32")]
pub use engine::Engine;

/// An allocator 2 KB smaller than that of std. Its speed does not matter: a running fire
/// allocates nothing.
#[cfg(target_arch = "wasm32")]
#[global_allocator]
static MEMORY: rlsf::SmallGlobalTlsf = rlsf::SmallGlobalTlsf::new();
