//! Hearth's panel: a control for every parameter of the fire.
//!
//! The panel is a wasm module of its own, loaded on request, so that a page without a panel
//! does not download it. It uses only the public API of the `<hearth-fire>` element and
//! does not depend on the engine.
//!
//! [`Panel`] is plain egui and runs anywhere: its views read a [`state::State`] and return
//! actions, and the panel applies these after each frame. `web` connects it to a canvas and
//! an element.

pub mod browser_text;
mod cost;
pub mod format;
mod panel;
pub mod search;
pub mod state;
pub mod system_font;
pub mod theme;
mod update;
mod view;
#[cfg(target_arch = "wasm32")]
pub mod web;

pub use panel::Panel;
