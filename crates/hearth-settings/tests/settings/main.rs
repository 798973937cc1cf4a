//! Settings: what changes them, and their projections.

mod changes;
mod children;
mod config;
mod harness;
mod ids;
mod other_children;
mod resolution;
mod sequences;
mod undo;
mod values;
