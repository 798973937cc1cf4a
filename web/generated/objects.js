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
<<<<<<< HEAD
=======

/** The presets with more objects than a source, and how many objects they have.
 * @type {{[preset: string]: number}} */
export const WITH_OBJECTS = {"bonfire-in-wind":6,"burning-logs":8,"burning-word":2,"campfire":7,"candle":3,"curtains":28,"fireplace":14,"fireside":5,"forge":11,"gas-burner":11,"house-of-cards":16,"match":3,"paper-boat":2,"ring-of-fire":13,"rope":18,"sheltered-candle":4,"smoke-stack":2,"torch":3,"wall-of-fire":6,"wooden-word":2};
>>>>>>> d996619f (Light smoke as far as it covers; give the gas burner five nozzles)
