//! The views: each reads what it shows, paints it, and returns actions.

mod button;
mod choices;
mod colour;
mod control;
mod field;
pub mod header;
mod history;
mod icons;
pub mod layout;
mod objects;
pub mod output;
mod quality;
mod row;
pub mod rows;
mod search_field;
mod slider;
mod telemetry;
mod title;
mod tools;
mod variants;
