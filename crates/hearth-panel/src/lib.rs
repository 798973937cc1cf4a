//! Hearth's panel: a slider for every parameter of the fire.
//!
//! A wasm module of its own, loaded on request, so that a page that shows no
//! panel pays nothing for it. It meets the fire only in the public API of the
//! `<hearth-fire>` element; it does not know the engine behind it.
//!
//! The panel itself ([`Panel`]) is plain egui and runs anywhere; `web`
//! connects it to a canvas and an element.

mod button;
mod choices;
mod colour;
mod control;
mod cost;
pub mod desk;
mod field;
pub mod fire;
pub mod format;
mod header;
mod history;
mod icons;
pub mod memory;
mod panel;
mod row;
pub mod search;
mod slider;
mod telemetry;
pub mod theme;
mod tools;
#[cfg(target_arch = "wasm32")]
pub mod web;

pub use panel::{Panel, QUALITY, SEARCH, SHARE, TOOLS};
