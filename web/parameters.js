// Generated from the parameter table of hearth-core by `cargo xtask codegen`;
// edit crates/hearth-core/src/params/table.rs instead.

export { QUANTITIES } from './generated/quantities.js';
export { PARAMETERS, PRESETS } from './generated/table.js';
