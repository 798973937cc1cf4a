// Generated from the parameter table of hearth-core by `cargo xtask codegen`;
// edit crates/hearth-core/src/params/table.rs instead.

/** What the colours of a display mode measure; modes that show a fire are absent. */
export const QUANTITIES = {
  particles: {"unit":"K","signed":false,"whole":false},
  temperature: {"unit":"K","signed":false,"whole":false},
  density: {"unit":"kg/m³","signed":false,"whole":false},
  pressure: {"unit":"Pa","signed":true,"whole":false},
  velocity: {"unit":"m/s","signed":false,"whole":false},
  vorticity: {"unit":"1/s","signed":true,"whole":false},
  distance: {"unit":"m","signed":false,"whole":false},
  fuel: {"unit":"","signed":false,"whole":false},
  soot: {"unit":"","signed":false,"whole":false},
  neighbours: {"unit":"","signed":false,"whole":true},
};
