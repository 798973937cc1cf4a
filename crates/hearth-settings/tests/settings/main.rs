//! Settings: what changes them, and their projections.

mod changes;
mod children;
mod config;
mod harness;
mod other_children;
mod resolution;
mod sequences;
mod values;
