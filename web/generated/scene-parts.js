// Generated from the parameter table of hearth-core by `cargo xtask codegen`;
// edit crates/hearth-core/src/params/table.rs instead.

/** The scenes that need each part of the engine's wasm. @type {{[part: string]: string[]}} */
export const SCENES = {
  classic: ['classic', 'paper-buoyancy', 'paper-fire', 'paper-smoothing', 'paper-stiffness', 'paper-viscosity', 'seed'],
  bodies: ['burning-logs', 'curtains', 'house-of-cards', 'paper-boat', 'rope', 'wooden-word'],
};
