//! The boundary between JavaScript and wasm, shared by the engine and the library.
//!
//! A value from a page becomes an [`Untrusted`](hearth_settings::untrusted::Untrusted) value, a copy, which
//! `hearth-settings` checks.

mod light;
pub mod memory;
pub mod panic;
pub mod parts;
mod record;
pub mod values;

pub use light::light;
pub use record::Record;
