//! Hearth's commands, run as `cargo xtask <command>`.
//!
//! Everything that is built, checked or served goes through here, so that the
//! one command of the README, a developer's machine and a build server do the
//! same thing. The parts are a library, so that tests reach them.

pub mod bench;
pub mod burning;
pub mod codegen;
pub mod command;
pub mod goldens;
pub mod links;
pub mod look;
pub mod marks;
mod npm;
pub mod package;
pub mod paths;
pub mod poster;
pub mod process;
pub mod report;
mod script;
pub mod serve;
pub mod showcase;
pub mod site;
pub mod size;
pub mod soak;
pub mod stages;
pub mod thumbnails;
pub mod tools;
pub mod validate;
