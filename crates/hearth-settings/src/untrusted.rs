//! Untrusted values: data of a page, a message or a file, before it is checked.
//!
//! A reader of JavaScript or JSON makes a tree of it. A [`Check`] defines the form of an
//! argument. An invalid value becomes a [`ValidationError`] with the id, the value, a message and
//! the allowed range. Only the tables of parameters and objects check their values; this crate applies them.

mod check;
mod error;
mod value;

pub use check::{Argument, Check, Form, Positive, Whole, Within};
pub use error::ValidationError;
pub use value::{MAX_BYTES, MAX_DEPTH, MAX_LENGTH, MAX_TEXT_BYTES, Untrusted, Values};
