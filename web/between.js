// Generated from the parameter table of hearth-core by `cargo xtask codegen`;
// edit crates/hearth-core/src/params.rs instead.

/** The parameters of which equal steps are equal ratios. */
export const LOGARITHMIC = ["domain_width", "domain_height", "smoothing_radius", "particle_mass", "gas_constant", "stiffness", "turbulence_scale", "emission_rate", "burn_time", "soot_life", "smoke_life", "ember_size", "time_scale", "time_step", "particle_size"];

/** Those whose values are whole. */
export const WHOLE = ["max_particles", "seed"];
