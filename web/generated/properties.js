// Generated from the parameter table of hearth-core by `cargo xtask codegen`;
// edit crates/hearth-core/src/params/table.rs instead.

/**
 * Each property of each kind of object: its domain, which is its default and, of a number, its range, in
 * every model or in those that use it; of a source, the parameter that it is of the first one.
 *
 * @typedef {[standard: any, min?: number, max?: number]} Domain
 * @typedef {{parameter?: string, every?: Domain, combustion?: Domain, classic?: Domain}} Property
 */

/** @type {{[kind: string]: {[name: string]: Property}}} */
export const PROPERTIES = {
  source: {
    name: {"every":[""]},
    enabled: {"parameter":"source_enabled","every":[true]},
    shape: {"parameter":"source_shape","every":["line"]},
    solid: {"parameter":"source_solid","every":[0,0,1000000]},
    x: {"parameter":"source_x","every":[0,-3,3]},
    y: {"parameter":"source_height","combustion":[0.25,0,6],"classic":[0,0,6]},
    angle: {"parameter":"source_angle","every":[0,-180,180]},
    width: {"parameter":"source_width","combustion":[0.4,0.01,6],"classic":[0.36,0.05,0.6]},
    power: {"parameter":"fuel_power","combustion":[220,0,3000]},
    rate: {"parameter":"emission_rate","classic":[1500,50,100000]},
    speed: {"parameter":"emission_speed","combustion":[0.6,0,1.5],"classic":[1,0,3]},
    spread: {"parameter":"emission_spread","classic":[0.25,0,1]},
    noise: {"parameter":"emission_noise","combustion":[0.2,0,1],"classic":[0.5,0,1]},
    temperature: {"parameter":"source_temperature","combustion":[700,500,1200]},
    oxygen: {"parameter":"source_oxygen","combustion":[0.5,0,1]},
    birth_temperature: {"parameter":"maximum_temperature","classic":[1900,1000,2500]},
    life_min: {"parameter":"lifetime_min","classic":[0.3,0.1,3]},
    life_max: {"parameter":"lifetime_max","classic":[1.2,0.1,3]},
    taper: {"parameter":"taper","classic":[0.8,0,1]},
  },
  solid: {
    name: {"every":[""]},
    enabled: {"every":[true]},
    shape: {"every":["circle"]},
    x: {"every":[0,-10,10]},
    y: {"every":[0.5,-10,10]},
    angle: {"every":[0,-360,360]},
    width: {"every":[0.2,0.002,10]},
    height: {"every":[0.1,0.002,10]},
    corner: {"every":[0,0,5]},
    points: {"every":["-0.1,-0.1 0.1,-0.1 0,0.1"]},
    mask: {"every":["16x16:7"]},
    material: {"every":["stone"]},
    plane: {"every":["within"]},
    thermal: {"every":["adiabatic"]},
    temperature: {"every":[293,250,2500]},
    heat_capacity: {"every":[100,10,5000]},
    fuel: {"every":["none"]},
    load: {"every":[2,0.05,200]},
    moisture: {"every":[8,0,100]},
    motion: {"every":["still"]},
    sway: {"every":[0.3,0,5]},
    heading: {"every":[0,-360,360]},
    period: {"every":[4,0.5,60]},
    spin: {"every":[45,-720,720]},
    density: {"every":[500,0.1,10000]},
    hangs_from: {"every":[0,0,1000000]},
    friction: {"every":[0.5,0,2]},
    restitution: {"every":[0.1,0,1]},
  },
};
