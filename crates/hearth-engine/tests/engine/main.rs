//! The engine without a browser: commands, settings, and how much work a fire does.

mod commands;
mod harness;
mod pacing;
mod start;
