//! The laws of the physics and what users rely on, natively.
//!
//! One program for all files: its tests keep every core busy, and it is linked once.
#![cfg(not(target_arch = "wasm32"))]

mod bodies;
mod burning_solids;
mod circles;
mod combustion;
mod conservation;
mod corners;
mod displays;
mod embers;
mod fuels;
mod fuzz;
mod hostile_objects;
mod measures;
mod models;
mod open_air;
mod open_changes;
mod paper;
mod parameters;
mod plain;
mod scenes;
mod simulation;
mod solid_heat;
mod solids;
mod source;
mod stored_fires;
mod thin_solids;
mod turbulence;
mod validation;
mod water;
