//! Settings of a Hearth fire from untrusted data: values and objects applied to a scene, and the settings file.
//!
//! Data of a page, a message or a file becomes an [`Untrusted`] value. The tables of `hearth-core` check it:
//! an invalid value is a [`ValidationError`] and changes nothing.
//!
//! ```
//! use hearth_settings::file::Config;
//! use hearth_settings::untrusted::Untrusted;
//!
//! let values = Untrusted::Object(vec![("fuel_power".into(), Untrusted::Number(-1.0))]);
//! let file = Untrusted::Object(vec![("values".into(), values)]);
//! let errors = Config::requested_by(&file).err().ok_or("accepted")?;
//! assert!(errors[0].message.contains("fuel_power = -1 is refused"));
//! # Ok::<(), &str>(())
//! ```

mod apply;
pub mod file;
mod requested;
pub mod untrusted;

pub use apply::{
    OBJECTS, document, objects, preset, set_valid, with_defaults, with_object, with_settings,
    with_values,
};
pub use requested::{COUNT, Requested, SPACING, adapt};
