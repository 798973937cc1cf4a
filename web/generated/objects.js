// Generated from the parameter table of hearth-core by `cargo xtask codegen`;
// edit crates/hearth-core/src/params/table.rs instead.

/** Each property of a source, and the parameter that it is of the first one. */
export const SOURCE = {
  enabled: 'source_enabled',
  shape: 'source_shape',
  solid: 'source_solid',
  x: 'source_x',
  y: 'source_height',
  angle: 'source_angle',
  width: 'source_width',
  power: 'fuel_power',
  rate: 'emission_rate',
  speed: 'emission_speed',
  spread: 'emission_spread',
  noise: 'emission_noise',
  temperature: 'source_temperature',
  oxygen: 'source_oxygen',
  birth_temperature: 'maximum_temperature',
  life_min: 'lifetime_min',
  life_max: 'lifetime_max',
  taper: 'taper',
};
