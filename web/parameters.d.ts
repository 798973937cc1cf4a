// Generated from the parameter table of hearth-core by `cargo xtask codegen`;
// edit crates/hearth-core/src/params.rs instead.

/** Which equations move the particles. */
export type ModelName = "classic";

/** The name of a preset. */
export type PresetName = "default" | "seed";

/** The value of every parameter, by its id. */
export interface HearthParameters {
  /** Width of the simulated domain. The source stands in the middle of its floor. [m] Default 1.2, from 0.1 to 6. */
  domain_width: number;
  /** Height of the simulated domain; the picture fits it. [m] Default 1.5, from 0.1 to 6. */
  domain_height: number;
  /** What happens at the left and the right edge: particles leave, are held back, or come back in on the other side. The floor holds them back, unless the edges are open; the top is always open. Default "open". */
  walls: "open" | "solid" | "periodic";
  /** Acceleration of gravity, as buoyancy feels it. [m/s²] Default 9.81, from 0 to 20. */
  gravity: number;
  /** Temperature of the air around the fire. [K] Default 293, from 250 to 350. */
  ambient_temperature: number;
  /** Density of the air around the fire. [kg/m³] Default 1.2, from 0.5 to 2. */
  ambient_density: number;
  /** Smoothing length h: particles feel each other up to twice this distance. [m] Default 0.026, from 0.005 to 0.1. */
  smoothing_radius: number;
  /** Mass of one particle, for each metre of depth. [kg/m] Default 0.00025, from 0.0001 to 0.002. */
  particle_mass: number;
  /** Density at which the gas has no pressure. [kg/m³] Default 1, from 0.5 to 2. */
  rest_density: number;
  /** Gas constant k of p = k (ρ − ρ₀), the square of the speed of sound: how hard compressed gas pushes apart. More of it widens the fire. [m²/s²] Default 0.6, from 0.05 to 6. */
  gas_constant: number;
  /** Dynamic viscosity: how strongly neighbours share their motion. [Pa·s] Default 0.005, from 0 to 0.1. */
  viscosity: number;
  /** Lift β of gas that is thinner than the air. More of it narrows the fire. Default 0.12, from 0 to 1. */
  buoyancy: number;
  /** Lift of gas that is hotter than the air. Default 0.2, from 0 to 1. */
  thermal_buoyancy: number;
  /** Weight added to every particle, as if gravity counted a second time. [m/s²] Default 0, from 0 to 20. */
  extra_weight: number;
  /** Speed at which lift and the resistance of the air, which this model leaves out otherwise, balance. [m/s] Default 2.5, from 0.5 to 3.5. */
  terminal_speed: number;
  /** A net, not a law: no particle moves faster. [m/s] Default 4, from 4 to 8. */
  speed_limit: number;
  /** Most particles alive at one time. Default 1000, from 100 to 100000. */
  max_particles: number;
  /** Particles born each second, as long as the source has room and the number of particles allows it. [1/s] Default 1500, from 50 to 100000. */
  emission_rate: number;
  /** Shortest life of a particle. [s] Default 0.3, from 0.1 to 3. */
  lifetime_min: number;
  /** Longest life of a particle. A life below the shortest one counts as the shortest. [s] Default 1.2, from 0.1 to 3. */
  lifetime_max: number;
  /** How much shorter particles live that are born towards the rim of the source, within the shortest and the longest life: it gives the fire its tip. Default 0.8, from 0 to 1. */
  taper: number;
  /** Upward speed at birth. [m/s] Default 1, from 0 to 3. */
  emission_speed: number;
  /** Random part of the velocity at birth. Default 0.25, from 0 to 1. */
  emission_spread: number;
  /** How unevenly the source burns: Perlin noise in place and time. Default 0.5, from 0 to 1. */
  emission_noise: number;
  /** Width of the source. [m] Default 0.36, from 0.05 to 0.6. */
  source_width: number;
  /** Height of the source above the floor. [m] Default 0, from 0 to 1. */
  source_height: number;
  /** Temperature of a particle at birth. [K] Default 1900, from 1000 to 2500. */
  maximum_temperature: number;
  /** How fast a particle cools towards the air. [K/s] Default 900, from 0 to 5000. */
  cooling_rate: number;
  /** Seconds of fire for each second of the clock: below 1 is slow motion. Default 1, from 0.1 to 2. */
  time_scale: number;
  /** Length of one step; it is divided further where stability asks for it. [s] Default 0.004166667, from 0.002 to 0.017. */
  time_step: number;
  /** Start of the random generator: the same seed gives the same fire. Default 1. */
  seed: number;
  /** Equation 1 as printed: the kernel with the factor of three dimensions. Default false. */
  printed_kernel: boolean;
  /** Equation 3 as printed: half the pressure force, not divided by the particle's own density. Default false. */
  printed_pressure: boolean;
  /** Equation 4 as printed: viscosity by the kernel's own Laplacian, which changes sign. Default false. */
  printed_viscosity: boolean;
  /** Equations 5 and 7 as printed: densities of force divided by the mass instead of the density, and no lift by temperature. Default false. */
  printed_divisor: boolean;
  /** Equation 6 as printed: forward Euler, the position moves with the old velocity. Default false. */
  printed_euler: boolean;
  /** What is drawn. Default "fire". */
  display_mode: "fire" | "paper";
  /** Size at which a particle is drawn. [m] Default 0.04, from 0.01 to 0.1. */
  particle_size: number;
  /** Brightness, in steps that each double it. [EV] Default 0, from -4 to 4. */
  exposure: number;
  /** How much of a black body's enormous range of brightness is kept. Default 0.35, from 0.15 to 1. */
  luminance_exponent: number;
  /** How strongly smoke hides what is behind it. Default 0.3, from 0 to 2. */
  smoke_opacity: number;
  /** Glow around bright places. Default 0.15, from 0 to 0.6. */
  bloom: number;
  /** Fine structure that rises with the flow. Default 1, from 0 to 2. */
  detail: number;
  /** What stands behind the fire: `transparent` or a colour. Default "transparent". */
  background: string;
}

/** The value of every parameter, as the element's properties name it. */
export interface HearthProperties {
  /** Width of the simulated domain. The source stands in the middle of its floor. [m] Default 1.2, from 0.1 to 6. */
  domainWidth: number;
  /** Height of the simulated domain; the picture fits it. [m] Default 1.5, from 0.1 to 6. */
  domainHeight: number;
  /** What happens at the left and the right edge: particles leave, are held back, or come back in on the other side. The floor holds them back, unless the edges are open; the top is always open. Default "open". */
  walls: "open" | "solid" | "periodic";
  /** Acceleration of gravity, as buoyancy feels it. [m/s²] Default 9.81, from 0 to 20. */
  gravity: number;
  /** Temperature of the air around the fire. [K] Default 293, from 250 to 350. */
  ambientTemperature: number;
  /** Density of the air around the fire. [kg/m³] Default 1.2, from 0.5 to 2. */
  ambientDensity: number;
  /** Smoothing length h: particles feel each other up to twice this distance. [m] Default 0.026, from 0.005 to 0.1. */
  smoothingRadius: number;
  /** Mass of one particle, for each metre of depth. [kg/m] Default 0.00025, from 0.0001 to 0.002. */
  particleMass: number;
  /** Density at which the gas has no pressure. [kg/m³] Default 1, from 0.5 to 2. */
  restDensity: number;
  /** Gas constant k of p = k (ρ − ρ₀), the square of the speed of sound: how hard compressed gas pushes apart. More of it widens the fire. [m²/s²] Default 0.6, from 0.05 to 6. */
  gasConstant: number;
  /** Dynamic viscosity: how strongly neighbours share their motion. [Pa·s] Default 0.005, from 0 to 0.1. */
  viscosity: number;
  /** Lift β of gas that is thinner than the air. More of it narrows the fire. Default 0.12, from 0 to 1. */
  buoyancy: number;
  /** Lift of gas that is hotter than the air. Default 0.2, from 0 to 1. */
  thermalBuoyancy: number;
  /** Weight added to every particle, as if gravity counted a second time. [m/s²] Default 0, from 0 to 20. */
  extraWeight: number;
  /** Speed at which lift and the resistance of the air, which this model leaves out otherwise, balance. [m/s] Default 2.5, from 0.5 to 3.5. */
  terminalSpeed: number;
  /** A net, not a law: no particle moves faster. [m/s] Default 4, from 4 to 8. */
  speedLimit: number;
  /** Most particles alive at one time. Default 1000, from 100 to 100000. */
  maxParticles: number;
  /** Particles born each second, as long as the source has room and the number of particles allows it. [1/s] Default 1500, from 50 to 100000. */
  emissionRate: number;
  /** Shortest life of a particle. [s] Default 0.3, from 0.1 to 3. */
  lifetimeMin: number;
  /** Longest life of a particle. A life below the shortest one counts as the shortest. [s] Default 1.2, from 0.1 to 3. */
  lifetimeMax: number;
  /** How much shorter particles live that are born towards the rim of the source, within the shortest and the longest life: it gives the fire its tip. Default 0.8, from 0 to 1. */
  taper: number;
  /** Upward speed at birth. [m/s] Default 1, from 0 to 3. */
  emissionSpeed: number;
  /** Random part of the velocity at birth. Default 0.25, from 0 to 1. */
  emissionSpread: number;
  /** How unevenly the source burns: Perlin noise in place and time. Default 0.5, from 0 to 1. */
  emissionNoise: number;
  /** Width of the source. [m] Default 0.36, from 0.05 to 0.6. */
  sourceWidth: number;
  /** Height of the source above the floor. [m] Default 0, from 0 to 1. */
  sourceHeight: number;
  /** Temperature of a particle at birth. [K] Default 1900, from 1000 to 2500. */
  maximumTemperature: number;
  /** How fast a particle cools towards the air. [K/s] Default 900, from 0 to 5000. */
  coolingRate: number;
  /** Seconds of fire for each second of the clock: below 1 is slow motion. Default 1, from 0.1 to 2. */
  timeScale: number;
  /** Length of one step; it is divided further where stability asks for it. [s] Default 0.004166667, from 0.002 to 0.017. */
  timeStep: number;
  /** Start of the random generator: the same seed gives the same fire. Default 1. */
  seed: number;
  /** Equation 1 as printed: the kernel with the factor of three dimensions. Default false. */
  printedKernel: boolean;
  /** Equation 3 as printed: half the pressure force, not divided by the particle's own density. Default false. */
  printedPressure: boolean;
  /** Equation 4 as printed: viscosity by the kernel's own Laplacian, which changes sign. Default false. */
  printedViscosity: boolean;
  /** Equations 5 and 7 as printed: densities of force divided by the mass instead of the density, and no lift by temperature. Default false. */
  printedDivisor: boolean;
  /** Equation 6 as printed: forward Euler, the position moves with the old velocity. Default false. */
  printedEuler: boolean;
  /** What is drawn. Default "fire". */
  displayMode: "fire" | "paper";
  /** Size at which a particle is drawn. [m] Default 0.04, from 0.01 to 0.1. */
  particleSize: number;
  /** Brightness, in steps that each double it. [EV] Default 0, from -4 to 4. */
  exposure: number;
  /** How much of a black body's enormous range of brightness is kept. Default 0.35, from 0.15 to 1. */
  luminanceExponent: number;
  /** How strongly smoke hides what is behind it. Default 0.3, from 0 to 2. */
  smokeOpacity: number;
  /** Glow around bright places. Default 0.15, from 0 to 0.6. */
  bloom: number;
  /** Fine structure that rises with the flow. Default 1, from 0 to 2. */
  detail: number;
  /** What stands behind the fire: `transparent` or a colour. Default "transparent". */
  background: string;
}

/** Any id of a parameter. */
export type ParameterId = keyof HearthParameters;

/** Default and range of a parameter in one model; only numbers have a range. */
export interface ParameterDomain {
  default: number | string | boolean;
  min?: number;
  max?: number;
}

/** What is known about a parameter; default and range are those of the default model. */
export interface Parameter extends ParameterDomain {
  id: ParameterId;
  /** The attribute of `<hearth-fire>`. */
  attribute: string;
  /** The property of `<hearth-fire>`. */
  property: keyof HearthProperties;
  label: string;
  group: string;
  /** Empty for a pure number. */
  unit: string;
  doc: string;
  kind: 'number' | 'integer' | 'choice' | 'flag' | 'colour' | 'seed';
  /** Numbers and integers: how a slider spreads the range. */
  scale?: 'linear' | 'log';
  /** Choices: every name. */
  choices?: string[];
  /** The models that use it. */
  models: ModelName[];
  domains: Partial<Record<ModelName, ParameterDomain>>;
}

/** A named set of values: the defaults, with these changed. */
export interface Preset {
  name: PresetName;
  label: string;
  values: Partial<HearthParameters>;
}

/** Every parameter, in the order in which a panel shows them. */
export declare const PARAMETERS: Parameter[];

/** Every preset, the default one first. */
export declare const PRESETS: Preset[];
