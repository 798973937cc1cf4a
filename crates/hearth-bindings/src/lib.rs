//! The boundary between JavaScript and wasm, shared by the engine and the library.
//!
//! A value from a page becomes an [`Untrusted`] value, a copy. A [`Check`] defines the form of an
//! argument. An invalid value becomes a [`ValidationError`] with the id, the value, a message and
//! the allowed range. Only the table of `hearth-core` checks values of parameters; [`settings`]
//! applies them.

mod check;
mod error;
pub mod memory;
pub mod panic;
pub mod parts;
mod record;
pub mod settings;
mod untrusted;

pub use check::{Argument, Check, Form, Positive, Whole, Within};
pub use error::ValidationError;
pub use record::Record;
pub use untrusted::{Ids, Untrusted, Values};
