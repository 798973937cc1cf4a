//! The parameters: one table, and everything that follows from it.
//!
//! [`PARAMETERS`] states each parameter once, in `params/table.rs`. From the table come the
//! structs, the defaults, the one validator ([`Parameters::set`]), the sliders, the
//! attributes, URL and JSON keys, the TypeScript types and `docs/parameters.md`. [`SOLID`] states the
//! properties of a solid in the same way.

mod check;
mod choices;
mod decimal;
mod declare;
mod entry;
mod outline;
mod property;
mod quantity;
mod resolution;
mod set;
mod slot;
mod table;
mod tables;
#[cfg(test)]
mod tests;
mod value;

pub(crate) use check::nearest;
pub use choices::{
    Backdrop, Choice, DisplayMode, Edges, Floor, Fuel, Ground, Layers, Material, Model, Motion,
    Palette, Plane, Shape, SourceShape, Thermal, Walls,
};
pub use entry::{Condition, Description, Domain, Kind, Role, Scale, conditions_text};
pub use outline::{Mask, Points};
pub use property::Property;
pub use quantity::Quantity;
pub use resolution::IN_DOMAIN;
pub use set::Parameters;
pub(crate) use set::model_first;
pub use table::{DESCRIPTIONS, PARAMETERS, Param, Physics, Source, Values};
pub(crate) use tables::Table;
pub use tables::name::{COMMON, Name};
pub(crate) use tables::solid::SOLID_NAMES;
pub use tables::solid::{SOLID, Solid};
pub use value::{AnyValue, Colour, Input, ParamError, ParamErrorKind, Value, printable, quoted};
