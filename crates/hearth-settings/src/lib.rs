//! Settings of a Hearth fire from untrusted data: values and objects applied to a scene, and the settings file.
//!
//! Data of a page, a message or a file becomes an [`Untrusted`](untrusted::Untrusted) value. The tables of `hearth-core` check it:
//! an invalid value is a [`ValidationError`](untrusted::ValidationError) and changes nothing.
//!
//! ```
//! use hearth_settings::untrusted::Untrusted;
//! use hearth_settings::{Change, Settings};
//!
//! let values = Untrusted::Object(vec![("fuel_power".into(), Untrusted::Number(-1.0))]);
//! let change = Change::Set(values.fields());
//! let errors = Settings::default().after(&change).err().ok_or("accepted")?;
//! assert!(errors[0].message.contains("fuel_power = -1 is refused"));
//! # Ok::<(), &str>(())
//! ```

mod apply;
mod change;
mod children;
mod delta;
mod export;
pub mod file;
mod particles;
mod resolution;
mod settings;
pub mod untrusted;

pub use apply::{OBJECTS, objects, preset};
pub use change::Change;
pub use delta::{delta, objects_delta};
pub use export::{children, export, whole};
pub use resolution::StatedResolution;
pub use settings::Settings;
