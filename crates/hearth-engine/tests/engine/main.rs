//! The engine without a browser: commands, settings, and how much work a fire does.

mod commands;
mod config;
mod harness;
mod pacing;
mod requested;
mod resolution;
mod values;
