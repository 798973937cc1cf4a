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
mod lessons;
mod measures;
mod models;
mod open_air;
mod open_changes;
mod paper;
mod parameters;
mod plain;
mod scenes;
mod series;
mod simulation;
mod solid_heat;
mod solids;
mod source;
mod stored_fires;
mod thin_solids;
mod turbulence;
mod validation;
mod water;

/// A file that nothing names would compile nowhere and fail never.
#[test]
fn every_file_is_in_a_program() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let manifest = include_str!("../Cargo.toml");
    for entry in folder.read_dir().unwrap() {
        let path = entry.unwrap().path();
        let (name, file) = (path.file_stem().unwrap(), path.file_name().unwrap());
        let (name, file) = (name.to_str().unwrap(), file.to_str().unwrap());
        let is_module = include_str!("laws.rs").contains(&format!("\nmod {name};\n"));
        let is_program = manifest.contains(&format!("path = \"tests/{file}"));
        let is_rust = path.is_dir() || file.ends_with(".rs");
        assert!(!is_rust || is_module || is_program, "{file}");
    }
}
