//! The boundary between JavaScript and wasm, shared by the engine and the library.
//!
//! A value that a page sends becomes an [`Untrusted`] value: a copy, of which nothing is
//! believed. A [`Check`] says what an argument must be. Whatever is refused becomes a
//! [`ValidationError`] with the id, the value, a message and the allowed range. Values of
//! parameters are checked by the table of `hearth-core` alone; [`settings`] applies them.

mod check;
mod error;
mod record;
pub mod settings;
mod untrusted;

pub use check::{Argument, Check, Form, Positive, Whole, Within};
pub use error::ValidationError;
pub use record::Record;
pub use untrusted::{Ids, Untrusted, Values};
