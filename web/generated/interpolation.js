// Generated from the parameter table of hearth-core by `cargo xtask codegen`;
// edit crates/hearth-core/src/params/table.rs instead.

/** The parameters whose equal steps are equal ratios. */
export const LOGARITHMIC = ["emission_rate","time_scale","burn_time","soot_life","particle_size","turbulence_scale","ember_size","smoke_life","domain_width","domain_height","time_step","spacing","smoothing_radius","particle_mass","gas_constant","stiffness"];

/** The parameters whose values are whole numbers. */
export const WHOLE = ["source_solid","depth","seed","particles","max_particles"];
