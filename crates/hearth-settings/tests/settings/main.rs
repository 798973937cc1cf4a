//! Settings: what changes them, and their projections.

mod changes;
mod children;
mod config;
mod deltas;
mod harness;
mod resolution;
mod sequences;
mod values;
