// Generated from the parameter table of hearth-core by `cargo xtask codegen`;
// edit crates/hearth-core/src/params.rs instead.

/** Which equations move the particles. */
export type ModelName = "classic" | "combustion";

/** The name of a preset. */
export type PresetName = "default" | "bonfire-in-wind" | "campfire" | "candle" | "fireside" | "forge" | "gas-burner" | "ghost-fire" | "match" | "smoke-stack" | "torch" | "wall-of-fire" | "classic" | "paper-buoyancy" | "paper-fire" | "paper-smoothing" | "paper-stiffness" | "seed";

/** The value of every parameter, by its id. */
export interface HearthParameters {
  /** Which equations move the particles. Classic: the paper's, in which hot particles are born, cool and die. Combustion: fuel enters the air, mixes with it and burns. Default "combustion". */
  model: "classic" | "combustion";
  /** Width of the simulated domain; the source stands in it where its place says. In the combustion model what leaves on one side comes back in on the other. [m] Default 1.2, from 0.1 to 6. */
  domain_width: number;
  /** Height of the simulated domain; the picture fits it. [m] Default in combustion: 1.8, from 0.1 to 6. Default in classic: 1.5, from 0.1 to 6. */
  domain_height: number;
  /** What happens at the left and the right edge: particles leave, are held back, or come back in on the other side. The floor holds them back, unless the edges are open; the top is always open. Default in classic: "open". */
  walls: "open" | "solid" | "periodic";
  /** Acceleration of gravity, as buoyancy feels it. [m/s²] Default 9.81, from 0 to 20. */
  gravity: number;
  /** Temperature of the air around the fire. [K] Default 293, from 250 to 350. */
  ambient_temperature: number;
  /** Density of the air around the fire. [kg/m³] Default 1.2, from 0.5 to 2. */
  ambient_density: number;
  /** How much of the height, at the top and at the bottom, gas becomes fresh air again. 0 closes the domain upon itself; then no wind blows, and nothing is lifted: nothing would ever stop it. Default in combustion: 0.07, from 0 to 0.2. */
  seam: number;
  /** Classic: most particles alive at one time. Combustion: into about how many particles air and gas are divided; more of them are finer, and slower. Default in combustion: 3000, from 200 to 100000. Default in classic: 1000, from 100 to 100000. */
  max_particles: number;
  /** Smoothing length h: particles feel each other up to twice this distance. [m] Default in classic: 0.026, from 0.005 to 0.1. */
  smoothing_radius: number;
  /** Smoothing length h in spacings of the particles: they feel each other up to twice this distance. More of it is smoother, and slower. Default in combustion: 1.5, from 1.3 to 2. */
  smoothing_ratio: number;
  /** Mass of one particle, for each metre of depth. [kg/m] Default in classic: 0.00025, from 0.0001 to 0.002. */
  particle_mass: number;
  /** Density at which the gas has no pressure. [kg/m³] Default in classic: 1, from 0.5 to 2. */
  rest_density: number;
  /** Gas constant k of p = k (ρ − ρ₀), the square of the speed of sound: how hard compressed gas pushes apart. More of it widens the fire. [m²/s²] Default in classic: 0.6, from 0.05 to 6. */
  gas_constant: number;
  /** Speed of sound in the simulated gas, far below the real one: how hard compressed gas pushes apart. More of it keeps the density more even and makes the steps shorter. It grows by itself for fires above 220 kW/m. [m/s] Default in combustion: 6, from 4 to 15. */
  stiffness: number;
  /** Dynamic viscosity: how strongly neighbours share their motion. [Pa·s] Default in classic: 0.005, from 0 to 0.1. */
  viscosity: number;
  /** Viscosity divided by density: how fast neighbours share their motion. [m²/s] Default in combustion: 0.0001, from 0 to 0.01. */
  kinematic_viscosity: number;
  /** Viscosity between particles that approach each other and none else: it damps the noise of the particles. Default in combustion: 0.1, from 0.02 to 0.5. */
  artificial_viscosity: number;
  /** How strongly whirls that are too small to be resolved mix motion, heat and gases: Smagorinsky's constant. Default in combustion: 0.2, from 0 to 0.4. */
  eddy_viscosity: number;
  /** How fast heat, fuel, oxygen and soot spread by themselves, without any flow. [m²/s] Default in combustion: 0.0001, from 0 to 0.01. */
  diffusion: number;
  /** How far hot gas takes more room: 1 is the ideal gas, 0 the paper's equation of state, in which only density makes pressure. Default in combustion: 0.5, from 0 to 1. */
  gas_expansion: number;
  /** How strongly particles are moved from where they crowd to where they are sparse, so that they stay evenly spread. Default in combustion: 1, from 0.2 to 1. */
  shifting: number;
  /** Classic: lift β of gas that is thinner than the air; more of it narrows the fire. Combustion: lift of gas that is hotter than the air; 1 is nature's. Default in combustion: 1, from 0 to 2. Default in classic: 0.12, from 0 to 1. */
  buoyancy: number;
  /** Lift of gas that is hotter than the air. Default in classic: 0.2, from 0 to 1. */
  thermal_buoyancy: number;
  /** Weight added to every particle, as if gravity counted a second time. [m/s²] Default in classic: 0, from 0 to 20. */
  extra_weight: number;
  /** Speed at which lift and the resistance of the air, which this model leaves out otherwise, balance. [m/s] Default in classic: 2.5, from 0.5 to 3. */
  terminal_speed: number;
  /** A net, not a law: no particle moves faster. [m/s] Default in classic: 4, from 4 to 8. */
  speed_limit: number;
  /** Speed of the fresh air from left to right; below 0 it blows from right to left. [m/s] Default in combustion: 0, from -3 to 3. */
  wind: number;
  /** Strength of a random field of drifting whirls that stirs the gas and compresses it nowhere. [m/s²] Default 0, from 0 to 10. */
  turbulence: number;
  /** Size of the whirls that turbulence stirs. [m] Default 0.15, from 0.03 to 0.6. */
  turbulence_scale: number;
  /** How strongly small whirls are kept spinning that would be smeared out otherwise. Default in combustion: 0, from 0 to 1. */
  vorticity_confinement: number;
  /** Particles born each second, as long as the source has room and the number of particles allows it. [1/s] Default in classic: 1500, from 50 to 100000. */
  emission_rate: number;
  /** Shortest life of a particle. [s] Default in classic: 0.3, from 0.1 to 3. */
  lifetime_min: number;
  /** Longest life of a particle. A life below the shortest one counts as the shortest. [s] Default in classic: 1.2, from 0.1 to 3. */
  lifetime_max: number;
  /** How much shorter particles live that are born towards the rim of the source, within the shortest and the longest life: it gives the fire its tip. Default in classic: 0.8, from 0 to 1. */
  taper: number;
  /** Power of the burner: the heat of the fuel that it feeds, for each metre of depth, on top of what its gas carries by being hot; 0 turns it off. [kW/m] Default in combustion: 220, from 0 to 600. */
  fuel_power: number;
  /** Upward speed of what leaves the source: of a particle at birth, or of the gas in the burner. [m/s] Default in combustion: 0.25, from 0 to 1.5. Default in classic: 1, from 0 to 3. */
  emission_speed: number;
  /** Random part of the velocity at birth. Default in classic: 0.25, from 0 to 1. */
  emission_spread: number;
  /** How unevenly the source burns: Perlin noise in place and time. Default in combustion: 0.2, from 0 to 1. Default in classic: 0.5, from 0 to 1. */
  emission_noise: number;
  /** Width of the source; combustion: of the burner, which is at least four particles wide. [m] Default in combustion: 0.4, from 0.01 to 1. Default in classic: 0.36, from 0.05 to 0.6. */
  source_width: number;
  /** Moves the fire to the right, below 0 to the left: place of the middle of the source, all of which stays inside the domain. [m] Default 0, from -3 to 3. */
  source_x: number;
  /** Height of the source above the floor; combustion: of the burner, which stays above the seam. [m] Default in combustion: 0.25, from 0 to 1. Default in classic: 0, from 0 to 1. */
  source_height: number;
  /** Temperature of a particle at birth. [K] Default in classic: 1900, from 1000 to 2500. */
  maximum_temperature: number;
  /** How fast a particle cools towards the air. [K/s] Default in classic: 900, from 0 to 5000. */
  cooling_rate: number;
  /** Temperature of the gas in the burner, which is always hot enough to burn. [K] Default in combustion: 700, from 500 to 1200. */
  source_temperature: number;
  /** Oxygen that the fuel brings along: with 0 it burns only where it meets the air, hottest at the rim of the flame; 1 is as much as the air has. Default in combustion: 0.5, from 0 to 1. */
  source_oxygen: number;
  /** Temperature above which fuel burns where there is oxygen. [K] Default in combustion: 450, from 400 to 900. */
  ignition_temperature: number;
  /** How much hotter gas becomes where fuel and air burn up without a remainder. [K] Default in combustion: 1500, from 600 to 2500. */
  flame_rise: number;
  /** Parts of air that one part of fuel needs to burn. Default in combustion: 1.5, from 0.5 to 6. */
  air_demand: number;
  /** Time in which hot fuel with enough oxygen burns down to about a third. [s] Default in combustion: 0.08, from 0.02 to 0.5. */
  burn_time: number;
  /** How fast gas and embers of 1500 K cool by what they radiate; that grows with the fourth power of the temperature. [K/s] Default in combustion: 500, from 0 to 2000. */
  radiative_cooling: number;
  /** Time in which hot soot, which makes a flame glow, burns away to about a third. [s] Default in combustion: 0.25, from 0.05 to 2. */
  soot_life: number;
  /** Time in which smoke, soot that has cooled, thins out to about a third. [s] Default in combustion: 1.5, from 0.1 to 10. */
  smoke_life: number;
  /** Embers thrown each second: sparks that the flow carries off. [1/s] Default in combustion: 40, from 0 to 1000. */
  ember_rate: number;
  /** Shortest life of an ember. [s] Default in combustion: 0.5, from 0.1 to 5. */
  ember_life_min: number;
  /** Longest life of an ember. A life below the shortest one counts as the shortest. [s] Default in combustion: 2, from 0.1 to 5. */
  ember_life_max: number;
  /** Size of an ember. [m] Default in combustion: 0.004, from 0.001 to 0.02. */
  ember_size: number;
  /** Seconds of fire for each second of the clock: below 1 is slow motion. Default 1, from 0.1 to 2. */
  time_scale: number;
  /** Length of one step; it is divided further where stability asks for it. [s] Default in classic: 0.004166667, from 0.002 to 0.017. */
  time_step: number;
  /** Start of the random generator: the same seed gives the same fire. Default 1. */
  seed: number;
  /** Equation 1 as printed: the kernel with the factor of three dimensions. Default in classic: false. */
  printed_kernel: boolean;
  /** Equation 3 as printed: half the pressure force, not divided by the particle's own density. Default in classic: false. */
  printed_pressure: boolean;
  /** Equation 4 as printed: viscosity by the kernel's own Laplacian, which changes sign. Default in classic: false. */
  printed_viscosity: boolean;
  /** Equations 5 and 7 as printed: densities of force divided by the mass instead of the density, and no lift by temperature. Default in classic: false. */
  printed_divisor: boolean;
  /** Equation 6 as printed: forward Euler, the position moves with the old velocity. Default in classic: false. */
  printed_euler: boolean;
  /** What is shown: the fire; every particle; a quantity of the gas, with a bar that says which colour is how much; the number of neighbours; the hard round sprites of the paper; or sprites with a texture. In the classic model fuel is what is left of a particle's life, and soot what makes smoke of it. Default "fire". */
  display_mode: "fire" | "particles" | "temperature" | "density" | "pressure" | "velocity" | "vorticity" | "fuel" | "soot" | "neighbours" | "paper" | "sprites";
  /** What is drawn: fire and smoke, the fire alone, or the smoke alone. Default "both". */
  layers: "both" | "fire" | "smoke";
  /** Size at which a particle is drawn. [m] Default in classic: 0.04, from 0.01 to 0.1. */
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
  /** Colours of the fire: those of glowing soot, of gas, of copper or lithium salts, of a ghost, or from a cool colour to a hot one. Default "blackbody". */
  palette: "blackbody" | "gas" | "copper" | "lithium" | "ghost" | "custom";
  /** Colour of the coolest fire, where the palette is the custom one; transparent is black. Default "#8a12ff". */
  cool_colour: string;
  /** Colour of the hottest fire, where the palette is the custom one; transparent is black. Default "#38e8ff". */
  hot_colour: string;
  /** What the fire burns in front of, in place of the background: nothing, or a wall of bricks that it lights. Default "none". */
  backdrop: "none" | "bricks";
  /** How strongly hot gas makes the backdrop shimmer; a page cannot be made to. Default 0.3, from 0 to 1. */
  heat_haze: number;
  /** What stands behind the fire: `transparent` or a colour. Default "transparent". */
  background: string;
}

/** The value of every parameter, as the element's properties name it. */
export interface HearthProperties {
  /** Which equations move the particles. Classic: the paper's, in which hot particles are born, cool and die. Combustion: fuel enters the air, mixes with it and burns. Default "combustion". */
  model: "classic" | "combustion";
  /** Width of the simulated domain; the source stands in it where its place says. In the combustion model what leaves on one side comes back in on the other. [m] Default 1.2, from 0.1 to 6. */
  domainWidth: number;
  /** Height of the simulated domain; the picture fits it. [m] Default in combustion: 1.8, from 0.1 to 6. Default in classic: 1.5, from 0.1 to 6. */
  domainHeight: number;
  /** What happens at the left and the right edge: particles leave, are held back, or come back in on the other side. The floor holds them back, unless the edges are open; the top is always open. Default in classic: "open". */
  walls: "open" | "solid" | "periodic";
  /** Acceleration of gravity, as buoyancy feels it. [m/s²] Default 9.81, from 0 to 20. */
  gravity: number;
  /** Temperature of the air around the fire. [K] Default 293, from 250 to 350. */
  ambientTemperature: number;
  /** Density of the air around the fire. [kg/m³] Default 1.2, from 0.5 to 2. */
  ambientDensity: number;
  /** How much of the height, at the top and at the bottom, gas becomes fresh air again. 0 closes the domain upon itself; then no wind blows, and nothing is lifted: nothing would ever stop it. Default in combustion: 0.07, from 0 to 0.2. */
  seam: number;
  /** Classic: most particles alive at one time. Combustion: into about how many particles air and gas are divided; more of them are finer, and slower. Default in combustion: 3000, from 200 to 100000. Default in classic: 1000, from 100 to 100000. */
  maxParticles: number;
  /** Smoothing length h: particles feel each other up to twice this distance. [m] Default in classic: 0.026, from 0.005 to 0.1. */
  smoothingRadius: number;
  /** Smoothing length h in spacings of the particles: they feel each other up to twice this distance. More of it is smoother, and slower. Default in combustion: 1.5, from 1.3 to 2. */
  smoothingRatio: number;
  /** Mass of one particle, for each metre of depth. [kg/m] Default in classic: 0.00025, from 0.0001 to 0.002. */
  particleMass: number;
  /** Density at which the gas has no pressure. [kg/m³] Default in classic: 1, from 0.5 to 2. */
  restDensity: number;
  /** Gas constant k of p = k (ρ − ρ₀), the square of the speed of sound: how hard compressed gas pushes apart. More of it widens the fire. [m²/s²] Default in classic: 0.6, from 0.05 to 6. */
  gasConstant: number;
  /** Speed of sound in the simulated gas, far below the real one: how hard compressed gas pushes apart. More of it keeps the density more even and makes the steps shorter. It grows by itself for fires above 220 kW/m. [m/s] Default in combustion: 6, from 4 to 15. */
  stiffness: number;
  /** Dynamic viscosity: how strongly neighbours share their motion. [Pa·s] Default in classic: 0.005, from 0 to 0.1. */
  viscosity: number;
  /** Viscosity divided by density: how fast neighbours share their motion. [m²/s] Default in combustion: 0.0001, from 0 to 0.01. */
  kinematicViscosity: number;
  /** Viscosity between particles that approach each other and none else: it damps the noise of the particles. Default in combustion: 0.1, from 0.02 to 0.5. */
  artificialViscosity: number;
  /** How strongly whirls that are too small to be resolved mix motion, heat and gases: Smagorinsky's constant. Default in combustion: 0.2, from 0 to 0.4. */
  eddyViscosity: number;
  /** How fast heat, fuel, oxygen and soot spread by themselves, without any flow. [m²/s] Default in combustion: 0.0001, from 0 to 0.01. */
  diffusion: number;
  /** How far hot gas takes more room: 1 is the ideal gas, 0 the paper's equation of state, in which only density makes pressure. Default in combustion: 0.5, from 0 to 1. */
  gasExpansion: number;
  /** How strongly particles are moved from where they crowd to where they are sparse, so that they stay evenly spread. Default in combustion: 1, from 0.2 to 1. */
  shifting: number;
  /** Classic: lift β of gas that is thinner than the air; more of it narrows the fire. Combustion: lift of gas that is hotter than the air; 1 is nature's. Default in combustion: 1, from 0 to 2. Default in classic: 0.12, from 0 to 1. */
  buoyancy: number;
  /** Lift of gas that is hotter than the air. Default in classic: 0.2, from 0 to 1. */
  thermalBuoyancy: number;
  /** Weight added to every particle, as if gravity counted a second time. [m/s²] Default in classic: 0, from 0 to 20. */
  extraWeight: number;
  /** Speed at which lift and the resistance of the air, which this model leaves out otherwise, balance. [m/s] Default in classic: 2.5, from 0.5 to 3. */
  terminalSpeed: number;
  /** A net, not a law: no particle moves faster. [m/s] Default in classic: 4, from 4 to 8. */
  speedLimit: number;
  /** Speed of the fresh air from left to right; below 0 it blows from right to left. [m/s] Default in combustion: 0, from -3 to 3. */
  wind: number;
  /** Strength of a random field of drifting whirls that stirs the gas and compresses it nowhere. [m/s²] Default 0, from 0 to 10. */
  turbulence: number;
  /** Size of the whirls that turbulence stirs. [m] Default 0.15, from 0.03 to 0.6. */
  turbulenceScale: number;
  /** How strongly small whirls are kept spinning that would be smeared out otherwise. Default in combustion: 0, from 0 to 1. */
  vorticityConfinement: number;
  /** Particles born each second, as long as the source has room and the number of particles allows it. [1/s] Default in classic: 1500, from 50 to 100000. */
  emissionRate: number;
  /** Shortest life of a particle. [s] Default in classic: 0.3, from 0.1 to 3. */
  lifetimeMin: number;
  /** Longest life of a particle. A life below the shortest one counts as the shortest. [s] Default in classic: 1.2, from 0.1 to 3. */
  lifetimeMax: number;
  /** How much shorter particles live that are born towards the rim of the source, within the shortest and the longest life: it gives the fire its tip. Default in classic: 0.8, from 0 to 1. */
  taper: number;
  /** Power of the burner: the heat of the fuel that it feeds, for each metre of depth, on top of what its gas carries by being hot; 0 turns it off. [kW/m] Default in combustion: 220, from 0 to 600. */
  fuelPower: number;
  /** Upward speed of what leaves the source: of a particle at birth, or of the gas in the burner. [m/s] Default in combustion: 0.25, from 0 to 1.5. Default in classic: 1, from 0 to 3. */
  emissionSpeed: number;
  /** Random part of the velocity at birth. Default in classic: 0.25, from 0 to 1. */
  emissionSpread: number;
  /** How unevenly the source burns: Perlin noise in place and time. Default in combustion: 0.2, from 0 to 1. Default in classic: 0.5, from 0 to 1. */
  emissionNoise: number;
  /** Width of the source; combustion: of the burner, which is at least four particles wide. [m] Default in combustion: 0.4, from 0.01 to 1. Default in classic: 0.36, from 0.05 to 0.6. */
  sourceWidth: number;
  /** Moves the fire to the right, below 0 to the left: place of the middle of the source, all of which stays inside the domain. [m] Default 0, from -3 to 3. */
  sourceX: number;
  /** Height of the source above the floor; combustion: of the burner, which stays above the seam. [m] Default in combustion: 0.25, from 0 to 1. Default in classic: 0, from 0 to 1. */
  sourceHeight: number;
  /** Temperature of a particle at birth. [K] Default in classic: 1900, from 1000 to 2500. */
  maximumTemperature: number;
  /** How fast a particle cools towards the air. [K/s] Default in classic: 900, from 0 to 5000. */
  coolingRate: number;
  /** Temperature of the gas in the burner, which is always hot enough to burn. [K] Default in combustion: 700, from 500 to 1200. */
  sourceTemperature: number;
  /** Oxygen that the fuel brings along: with 0 it burns only where it meets the air, hottest at the rim of the flame; 1 is as much as the air has. Default in combustion: 0.5, from 0 to 1. */
  sourceOxygen: number;
  /** Temperature above which fuel burns where there is oxygen. [K] Default in combustion: 450, from 400 to 900. */
  ignitionTemperature: number;
  /** How much hotter gas becomes where fuel and air burn up without a remainder. [K] Default in combustion: 1500, from 600 to 2500. */
  flameRise: number;
  /** Parts of air that one part of fuel needs to burn. Default in combustion: 1.5, from 0.5 to 6. */
  airDemand: number;
  /** Time in which hot fuel with enough oxygen burns down to about a third. [s] Default in combustion: 0.08, from 0.02 to 0.5. */
  burnTime: number;
  /** How fast gas and embers of 1500 K cool by what they radiate; that grows with the fourth power of the temperature. [K/s] Default in combustion: 500, from 0 to 2000. */
  radiativeCooling: number;
  /** Time in which hot soot, which makes a flame glow, burns away to about a third. [s] Default in combustion: 0.25, from 0.05 to 2. */
  sootLife: number;
  /** Time in which smoke, soot that has cooled, thins out to about a third. [s] Default in combustion: 1.5, from 0.1 to 10. */
  smokeLife: number;
  /** Embers thrown each second: sparks that the flow carries off. [1/s] Default in combustion: 40, from 0 to 1000. */
  emberRate: number;
  /** Shortest life of an ember. [s] Default in combustion: 0.5, from 0.1 to 5. */
  emberLifeMin: number;
  /** Longest life of an ember. A life below the shortest one counts as the shortest. [s] Default in combustion: 2, from 0.1 to 5. */
  emberLifeMax: number;
  /** Size of an ember. [m] Default in combustion: 0.004, from 0.001 to 0.02. */
  emberSize: number;
  /** Seconds of fire for each second of the clock: below 1 is slow motion. Default 1, from 0.1 to 2. */
  timeScale: number;
  /** Length of one step; it is divided further where stability asks for it. [s] Default in classic: 0.004166667, from 0.002 to 0.017. */
  timeStep: number;
  /** Start of the random generator: the same seed gives the same fire. Default 1. */
  seed: number;
  /** Equation 1 as printed: the kernel with the factor of three dimensions. Default in classic: false. */
  printedKernel: boolean;
  /** Equation 3 as printed: half the pressure force, not divided by the particle's own density. Default in classic: false. */
  printedPressure: boolean;
  /** Equation 4 as printed: viscosity by the kernel's own Laplacian, which changes sign. Default in classic: false. */
  printedViscosity: boolean;
  /** Equations 5 and 7 as printed: densities of force divided by the mass instead of the density, and no lift by temperature. Default in classic: false. */
  printedDivisor: boolean;
  /** Equation 6 as printed: forward Euler, the position moves with the old velocity. Default in classic: false. */
  printedEuler: boolean;
  /** What is shown: the fire; every particle; a quantity of the gas, with a bar that says which colour is how much; the number of neighbours; the hard round sprites of the paper; or sprites with a texture. In the classic model fuel is what is left of a particle's life, and soot what makes smoke of it. Default "fire". */
  displayMode: "fire" | "particles" | "temperature" | "density" | "pressure" | "velocity" | "vorticity" | "fuel" | "soot" | "neighbours" | "paper" | "sprites";
  /** What is drawn: fire and smoke, the fire alone, or the smoke alone. Default "both". */
  layers: "both" | "fire" | "smoke";
  /** Size at which a particle is drawn. [m] Default in classic: 0.04, from 0.01 to 0.1. */
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
  /** Colours of the fire: those of glowing soot, of gas, of copper or lithium salts, of a ghost, or from a cool colour to a hot one. Default "blackbody". */
  palette: "blackbody" | "gas" | "copper" | "lithium" | "ghost" | "custom";
  /** Colour of the coolest fire, where the palette is the custom one; transparent is black. Default "#8a12ff". */
  coolColour: string;
  /** Colour of the hottest fire, where the palette is the custom one; transparent is black. Default "#38e8ff". */
  hotColour: string;
  /** What the fire burns in front of, in place of the background: nothing, or a wall of bricks that it lights. Default "none". */
  backdrop: "none" | "bricks";
  /** How strongly hot gas makes the backdrop shimmer; a page cannot be made to. Default 0.3, from 0 to 1. */
  heatHaze: number;
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

/**
 * What is known about a parameter. Default and range are those of the default
 * model, or of the one that uses it; `domains` has those of each.
 */
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
  /**
   * The choices, by id, that must each have one of these names, or the value shows nowhere.
   * It can be set all the same.
   */
  when?: Partial<Record<ParameterId, string[]>>;
  /** The choices with whose names, all of them chosen together, it shows nowhere either. */
  unless?: Partial<Record<ParameterId, string[]>>;
}

/** A named set of values: the defaults, with these changed. */
export interface Preset {
  name: PresetName;
  label: string;
  /** What there is to see, in a sentence. */
  description: string;
  values: Partial<HearthParameters>;
}

/** Every parameter, in the order in which a panel shows them. */
export declare const PARAMETERS: Parameter[];

/** Every preset, the default one first. */
export declare const PRESETS: Preset[];

/** What the colours of a display mode measure, from `stats.scale[0]` to `stats.scale[1]`. */
export interface Quantity {
  /** Empty for a pure number. */
  unit: string;
  /** Whether it goes both ways from zero, which is then the middle of the colours. */
  signed: boolean;
  /** Whether it is a whole number. */
  whole: boolean;
}

/** Of each display mode that measures something, what. */
export declare const QUANTITIES: Partial<Record<HearthParameters['display_mode'], Quantity>>;
