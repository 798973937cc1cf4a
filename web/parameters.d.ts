// Generated from the parameter table of hearth-core by `cargo xtask codegen`;
// edit crates/hearth-core/src/params/table.rs instead.

/** Which equations move the particles. */
export type ModelName = "classic" | "combustion";

/** The name of a preset. */
export type PresetName = "default" | "bonfire-in-wind" | "burning-logs" | "burning-word" | "campfire" | "candle" | "curtains" | "fireplace" | "fireside" | "forge" | "gas-burner" | "ghost-fire" | "house-of-cards" | "match" | "paper-boat" | "ring-of-fire" | "rope" | "sheltered-candle" | "smoke-stack" | "torch" | "wall-of-fire" | "wooden-word" | "classic" | "paper-buoyancy" | "paper-fire" | "paper-smoothing" | "paper-stiffness" | "paper-viscosity" | "seed";

/** The value of every parameter, by its id. */
export interface HearthParameters {
  /** Another kind of fire. Combustion: fuel enters the air, mixes with it and burns. Classic: the paper's equations, in which hot particles are born, cool and die, and no solid burns. Default "combustion". */
  model: "classic" | "combustion";
  /** A taller, brighter flame. Power of the burner per metre of depth: the heat of combustion of its fuel, without the heat of its hot gas. 0 turns it off. [kW/m] Default in combustion: 220, from 0 to 3000. */
  fuel_power: number;
  /** A denser, brighter flame. Particles born per second, limited by the space at the source and by the number of particles. [1/s] Default in classic: 1500, from 50 to 100000. */
  emission_rate: number;
  /** A wider fire. Width of the source. In the combustion model it is at least four particles. [m] Default in combustion: 0.4, from 0.01 to 6. Default in classic: 0.36, from 0.05 to 0.6. */
  source_width: number;
  /** A taller flame. Longest life of a particle, at least the shortest life. [s] Default in classic: 1.2, from 0.1 to 3. */
  lifetime_max: number;
  /** A livelier, wilder flame. Acceleration by a random field of drifting eddies, which does not compress the gas. [m/s²] Default 0, from 0 to 10. */
  turbulence: number;
  /** A flame that leans to the right, or below 0 to the left. Speed of the fresh air from left to right. [m/s] Default in combustion: 0, from -3 to 3. */
  wind: number;
  /** Other colours of the fire: those of glowing soot, of gas, of copper or lithium salts, of a ghost, or your own from a cool colour to a hot one. Default "blackbody". */
  palette: "blackbody" | "gas" | "copper" | "lithium" | "ghost" | "custom";
  /** A brighter picture. Exposure in stops, each of which doubles the light. [EV] Default 0, from -4 to 4. */
  exposure: number;
  /** A wider shine around bright places. Share of the light that a lens scatters. Default 0.15, from 0 to 0.6. */
  bloom: number;
  /** Thicker smoke. Opacity of the smoke. Default 0.3, from 0 to 2. */
  smoke_opacity: number;
  /** More sparks. Embers emitted per second. The flow carries them. [1/s] Default in combustion: 40, from 0 to 1000. */
  ember_rate: number;
  /** A wall behind the fire, with its floor, in place of the background. The fire lights it. None: the page shows through. Default "none". */
  backdrop: "none" | "bricks";
  /** A ground under the fire, which lights it. Solids cast shadows on it. Over a transparent background, only its light and its shadows are drawn. None: no ground or, before a wall, the stone floor of that. Default "none". */
  ground: "none" | "stone" | "earth" | "sand" | "snow";
  /** A faster fire; below 1 slow motion. Seconds of fire for each second of the clock. Default 1, from 0.1 to 2. */
  time_scale: number;
  /** A source that burns. One that is off emits nothing and keeps its values. So does one on a solid that is off. Default true. */
  source_enabled: boolean;
  /** A fire on a line, or on the surface of a solid. Line: the source is straight. Solid: the whole outline of a solid burns, wherever the solid is. Default "line". */
  source_shape: "line" | "solid";
  /** A fire on another solid. Id of the solid whose surface is the source. If no solid has it, the source is a line. Default 0, from 0 to 1000000. */
  source_solid: number;
  /** A fire farther to the right, or below 0 to the left. Position of the middle of the source, which stays inside the domain. [m] Default 0, from -3 to 3. */
  source_x: number;
  /** A flame that starts higher above the floor. Height of the source. In the combustion model it stays above the seam. [m] Default in combustion: 0.25, from 0 to 6. Default in classic: 0, from 0 to 6. */
  source_height: number;
  /** A flame that leaves its source to the side. Angle of the width of the source from the horizontal, counterclockwise; what it emits leaves it at right angles. [°] Default 0, from -180 to 180. */
  source_angle: number;
  /** A flame that shoots up from its source. Speed of a particle at birth, or of the gas in the burner; upward unless the source is turned. A particle leaves a solid at right angles. In the combustion model, a solid has none: it supplies no gas. [m/s] Default in combustion: 0.6, from 0 to 1.5. Default in classic: 1, from 0 to 3. */
  emission_speed: number;
  /** A frayed flame that sprays to the sides. Random part of the velocity at birth. Default in classic: 0.25, from 0 to 1. */
  emission_spread: number;
  /** An uneven flame that flares up here and there. How unevenly the source burns: Perlin noise in place and time. Default in combustion: 0.2, from 0 to 1. Default in classic: 0.5, from 0 to 1. */
  emission_noise: number;
  /** A flame that ends in a point. How much shorter the lives of particles from the rim of the source are, within the shortest and the longest life. Default in classic: 0.8, from 0 to 1. */
  taper: number;
  /** A fuller flame, up to its top. Shortest life of a particle. [s] Default in classic: 0.3, from 0.1 to 3. */
  lifetime_min: number;
  /** A whiter flame. Temperature of a particle at birth. [K] Default in classic: 1900, from 1000 to 2500. */
  maximum_temperature: number;
  /** A shorter flame with a redder top. How fast a particle cools towards the air. [K/s] Default in classic: 900, from 0 to 5000. */
  cooling_rate: number;
  /** A hotter, whiter flame. Rise of the temperature if all fuel and all air burn. [K] Default in combustion: 1500, from 600 to 2500. */
  flame_rise: number;
  /** A slower fire, whose flame begins higher. Time in which hot fuel with enough oxygen burns down to about a third. [s] Default in combustion: 0.08, from 0.02 to 0.5. */
  burn_time: number;
  /** A taller flame, because its fuel rises farther to find air. Parts of air that burn one part of fuel. Default in combustion: 1.5, from 0.5 to 6. */
  air_demand: number;
  /** A longer glow above the flame. Time in which hot soot, the source of the glow, burns away to about a third. [s] Default in combustion: 0.25, from 0.05 to 2. */
  soot_life: number;
  /** A shorter flame that fades to red sooner. How fast gas and embers of 1500 K cool by radiation, which grows with the fourth power of the temperature. [K/s] Default in combustion: 500, from 0 to 2000. */
  radiative_cooling: number;
  /** A flame that burns evenly down to its root; with 0 it is brightest at its rim. Oxygen in the fuel, relative to air. Default in combustion: 0.5, from 0 to 1. */
  source_oxygen: number;
  /** A brighter root of the flame. Temperature of the gas in the burner, which is always above the ignition temperature. [K] Default in combustion: 700, from 500 to 1200. */
  source_temperature: number;
  /** A flame that tears off and goes out more easily. Temperature above which fuel burns where there is oxygen. [K] Default in combustion: 450, from 400 to 900. */
  ignition_temperature: number;
  /** Another view of the same gas: the fire; every particle; a quantity of the gas, with a colour bar; the number of neighbours; the hard round sprites of the paper; or sprites with a texture. In the classic model, fuel is the remaining life of a particle, and soot is its smoke. Default "fire". */
  display_mode: "fire" | "particles" | "temperature" | "density" | "pressure" | "velocity" | "vorticity" | "distance" | "fuel" | "soot" | "neighbours" | "paper" | "sprites";
  /** Fire and smoke, the fire alone, or the smoke alone. The visible layers. Default "both". */
  layers: "both" | "fire" | "smoke";
  /** A deeper fire with more tongues. Number of slices: moments of the fire's past that are drawn behind the present one. Low quality shows three. Default in combustion: 5, from 1 to 5. */
  depth: number;
  /** A bright rim around a darker middle, as of a candle. Share of the light that is seen through a flame that is round about its axis; 0 is a plane flame. Default in combustion: 0, from 0 to 1. */
  roundness: number;
  /** Finer tongues and wisps. Strength of the fine structure that moves with the gas. Default 1, from 0 to 2. */
  detail: number;
  /** More contrast between bright and dim parts of the fire. Exponent that compresses the brightness of a black body. Default in combustion: 0.6, from 0.15 to 1. Default in classic: 0.35, from 0.15 to 1. */
  luminance_exponent: number;
  /** Larger, softer particles. Drawn size of a particle. [m] Default in classic: 0.04, from 0.0025 to 0.1. */
  particle_size: number;
  /** Colour of the coolest fire in the custom palette; transparent is black. Default "#8a12ff". */
  cool_colour: string;
  /** Colour of the hottest fire in the custom palette; transparent is black. Default "#38e8ff". */
  hot_colour: string;
  /** Colour behind the fire; with `transparent` the page shows through. Default "transparent". */
  background: string;
  /** A whiter, less red fire, and light of it. Temperature of the black body that the camera shows as white; at 6500 the fire has its physical hues. Other palettes keep theirs. [K] Default 3200, from 2000 to 6500. */
  white_balance: number;
  /** Solids in their own colours, as in a lit room or on a white page. White light of the surroundings on solids, wall and ground. Default 0, from 0 to 1. */
  ambient_light: number;
  /** A backdrop that shimmers behind the flame. How strongly hot gas refracts the view of the backdrop. The page behind the element is not refracted. Default 0.3, from 0 to 1. */
  heat_haze: number;
  /** Larger, slower swings of the flame. Size of the eddies of the turbulence. [m] Default 0.15, from 0.03 to 0.6. */
  turbulence_scale: number;
  /** More curls at the edges of the flame. How strongly small eddies keep the rotation that the computation would dissipate. Default in combustion: 0, from 0 to 1. */
  vorticity_confinement: number;
  /** A flame that rises faster. Classic: buoyancy β of gas that is thinner than the air; more of it narrows the fire. Combustion: buoyancy of hot gas; 1 is the physical value. Default in combustion: 1, from 0 to 2. Default in classic: 0.12, from 0 to 1. */
  buoyancy: number;
  /** A flame whose hot parts rise faster. Buoyancy of gas that is hotter than the air. Default in classic: 0.2, from 0 to 1. */
  thermal_buoyancy: number;
  /** A taller, quicker flame. Speed at which buoyancy and the drag of the air balance. [m/s] Default in classic: 2.5, from 0.5 to 3. */
  terminal_speed: number;
  /** A lazier flame. Additional downward acceleration of every particle. [m/s²] Default in classic: 0, from 0 to 20. */
  extra_weight: number;
  /** A flame that rises faster and flickers more. Gravitational acceleration in the buoyancy; 0 is a fire in free fall. [m/s²] Default 9.81, from 0 to 20. */
  gravity: number;
  /** A fire that rises a little more slowly. Temperature of the air around the fire. [K] Default 293, from 250 to 350. */
  ambient_temperature: number;
  /** Classic: a fire that rises a little faster. Combustion: a smaller fire, because it heats more air. Density of the air around the fire. [kg/m³] Default 1.2, from 0.5 to 2. */
  ambient_density: number;
  /** Larger sparks. Size of an ember. [m] Default in combustion: 0.004, from 0.001 to 0.02. */
  ember_size: number;
  /** Sparks that all fly far. Shortest life of an ember. [s] Default in combustion: 0.5, from 0.1 to 5. */
  ember_life_min: number;
  /** Sparks of which some fly far. Longest life of an ember, at least the shortest life. [s] Default in combustion: 2, from 0.1 to 5. */
  ember_life_max: number;
  /** Smoke that reaches higher. Time in which smoke, which is cold soot, decays to about a third. [s] Default in combustion: 1.5, from 0.1 to 10. */
  smoke_life: number;
  /** More space beside the fire, in a wider view. Width of the domain, which the picture fits. Open edges: gas is simulated beyond it, too. [m] Default 1.2, from 0.1 to 6. */
  domain_width: number;
  /** More space above the fire, in a wider view. Height of the domain, which the picture fits. Open edges: gas is simulated beyond it, too. [m] Default in combustion: 1.8, from 0.1 to 6. Default in classic: 1.5, from 0.1 to 6. */
  domain_height: number;
  /** Open sides, walls, or periodic sides. Particles at the left and the right edge leave, are stopped, or enter on the other side. The floor stops them, unless the sides are open; the top is always open. Default in classic: "open". */
  walls: "open" | "solid" | "periodic";
  /** A fire in the open, or in a closed box. Open: air surrounds the fire, smoke leaves, and fresh air enters. Periodic: gas that leaves on one side of the domain enters on the other. Default in combustion: "open". */
  edges: "open" | "periodic";
  /** A fire that stands on a floor, or one that draws air from below. A solid floor is at the lower edge of the domain. Default in combustion: "none". */
  floor: "none" | "solid";
  /** A fire that fades at the top and the bottom of the picture. Share of the height, at either end, in which gas becomes fresh air again. With 0 the domain is periodic without fresh air, and has neither wind nor buoyancy, because nothing would stop the gas. Default in combustion: 0.07, from 0 to 0.2. */
  seam: number;
  /** Another variation of the same fire. Seed of the random generator: the same seed gives the same fire. Default 1. */
  seed: number;
  /** The same fire at lower cost and accuracy. Length of one step, which is divided further for stability. [s] Default in classic: 0.004166667, from 0.002 to 0.017. */
  time_step: number;
  /** A coarser fire that takes less work. Distance of neighbouring particles in air. Until it is set, it follows the domain, the number of particles and the quality. [m] Default in combustion: 0.0268, from 0.0003 to 0.5. */
  spacing: number;
  /** A finer fire that takes more work. Number of particles that would fill the domain. Until it is set, it follows the scene, the `spacing` and the quality. Default in combustion: 3000, from 200 to 100000. */
  particles: number;
  /** A fire that may grow larger. Largest number of particles, with open edges or in the classic model. The highest air sleeps beyond it; until it is set, there is room for twice the domain. Default in combustion: 6000, from 200 to 100000. Default in classic: 1000, from 100 to 100000. */
  max_particles: number;
  /** A smoother, wider fire that takes more work. Smoothing length h: particles interact up to twice this distance. [m] Default in classic: 0.026, from 0.005 to 0.1. */
  smoothing_radius: number;
  /** A smoother fire that takes more work. Smoothing length h in spacings of the particles, which interact up to twice this distance. Default in combustion: 1.5, from 1.3 to 2. */
  smoothing_ratio: number;
  /** A wider, coarser fire. Mass of one particle per metre of depth. [kg/m] Default in classic: 0.00025, from 0.0001 to 0.002. */
  particle_mass: number;
  /** A narrower fire. Density at which the gas has no pressure. [kg/m³] Default in classic: 1, from 0.5 to 2. */
  rest_density: number;
  /** A wider fire. Gas constant k of p = k (ρ − ρ₀), the square of the speed of sound: how strongly compressed gas expands. [m²/s²] Default in classic: 0.6, from 0.05 to 6. */
  gas_constant: number;
  /** A more even fire that takes more work. Speed of sound in the simulated gas, far below the real one. A higher speed gives a more uniform density and shorter steps. It increases automatically for fires above 220 kW/m. [m/s] Default in combustion: 6, from 4 to 15. */
  stiffness: number;
  /** A calmer flame. Dynamic viscosity. [Pa·s] Default in classic: 0.005, from 0 to 0.1. */
  viscosity: number;
  /** A calmer, smoother flame. Kinematic viscosity: viscosity divided by density. [m²/s] Default in combustion: 0.0001, from 0 to 0.01. */
  kinematic_viscosity: number;
  /** A calmer flame with fewer small curls. Viscosity between approaching particles only, which damps the noise of the particles. Default in combustion: 0.1, from 0.02 to 0.5. */
  artificial_viscosity: number;
  /** A softer flame without small curls. How strongly unresolved eddies mix momentum, heat and gases: Smagorinsky's constant. Default in combustion: 0.2, from 0 to 0.4. */
  eddy_viscosity: number;
  /** A compact flame that no hot rolls leave. Size C of the eddies into which rolls break up, in the length D* of the fire: how strongly rolls mix momentum, heat and gases. Default in combustion: 0.085, from 0 to 0.2. */
  roll_mixing: number;
  /** A softer, blurred flame. Diffusivity of heat, fuel, oxygen and soot. [m²/s] Default in combustion: 0.0001, from 0 to 0.01. */
  diffusion: number;
  /** A wider, fuller flame. Exponent of the thermal expansion: 1 is the ideal gas, 0 the paper's equation of state, in which pressure depends on density only. Default in combustion: 0.5, from 0 to 1. */
  gas_expansion: number;
  /** A picture without gaps and clumps. How strongly particles are shifted from dense to sparse regions, so that they stay evenly distributed. Default in combustion: 1, from 0.2 to 1. */
  shifting: number;
  /** Faster particles, which only an extreme fire needs. Largest speed of a particle. [m/s] Default in classic: 5, from 4 to 8. */
  speed_limit: number;
  /** The paper's fire, with equation 1 as printed: the kernel with the factor of three dimensions. Default in classic: false. */
  printed_kernel: boolean;
  /** The paper's fire, with equation 3 as printed: half the pressure force, not divided by the particle's own density. Default in classic: false. */
  printed_pressure: boolean;
  /** The paper's fire, with equation 4 as printed: viscosity by the kernel's own Laplacian, which changes sign. Default in classic: false. */
  printed_viscosity: boolean;
  /** The paper's fire, with equations 5 and 7 as printed: force densities divided by the mass instead of the density, and no thermal buoyancy. Default in classic: false. */
  printed_divisor: boolean;
  /** The paper's fire, with equation 6 as printed: forward Euler, the position moves with the old velocity. Default in classic: false. */
  printed_euler: boolean;
}

/** The value of every parameter, as the element's properties name it. */
export interface HearthProperties {
  /** Another kind of fire. Combustion: fuel enters the air, mixes with it and burns. Classic: the paper's equations, in which hot particles are born, cool and die, and no solid burns. Default "combustion". */
  model: "classic" | "combustion";
  /** A taller, brighter flame. Power of the burner per metre of depth: the heat of combustion of its fuel, without the heat of its hot gas. 0 turns it off. [kW/m] Default in combustion: 220, from 0 to 3000. */
  fuelPower: number;
  /** A denser, brighter flame. Particles born per second, limited by the space at the source and by the number of particles. [1/s] Default in classic: 1500, from 50 to 100000. */
  emissionRate: number;
  /** A wider fire. Width of the source. In the combustion model it is at least four particles. [m] Default in combustion: 0.4, from 0.01 to 6. Default in classic: 0.36, from 0.05 to 0.6. */
  sourceWidth: number;
  /** A taller flame. Longest life of a particle, at least the shortest life. [s] Default in classic: 1.2, from 0.1 to 3. */
  lifetimeMax: number;
  /** A livelier, wilder flame. Acceleration by a random field of drifting eddies, which does not compress the gas. [m/s²] Default 0, from 0 to 10. */
  turbulence: number;
  /** A flame that leans to the right, or below 0 to the left. Speed of the fresh air from left to right. [m/s] Default in combustion: 0, from -3 to 3. */
  wind: number;
  /** Other colours of the fire: those of glowing soot, of gas, of copper or lithium salts, of a ghost, or your own from a cool colour to a hot one. Default "blackbody". */
  palette: "blackbody" | "gas" | "copper" | "lithium" | "ghost" | "custom";
  /** A brighter picture. Exposure in stops, each of which doubles the light. [EV] Default 0, from -4 to 4. */
  exposure: number;
  /** A wider shine around bright places. Share of the light that a lens scatters. Default 0.15, from 0 to 0.6. */
  bloom: number;
  /** Thicker smoke. Opacity of the smoke. Default 0.3, from 0 to 2. */
  smokeOpacity: number;
  /** More sparks. Embers emitted per second. The flow carries them. [1/s] Default in combustion: 40, from 0 to 1000. */
  emberRate: number;
  /** A wall behind the fire, with its floor, in place of the background. The fire lights it. None: the page shows through. Default "none". */
  backdrop: "none" | "bricks";
  /** A ground under the fire, which lights it. Solids cast shadows on it. Over a transparent background, only its light and its shadows are drawn. None: no ground or, before a wall, the stone floor of that. Default "none". */
  ground: "none" | "stone" | "earth" | "sand" | "snow";
  /** A faster fire; below 1 slow motion. Seconds of fire for each second of the clock. Default 1, from 0.1 to 2. */
  timeScale: number;
  /** A source that burns. One that is off emits nothing and keeps its values. So does one on a solid that is off. Default true. */
  sourceEnabled: boolean;
  /** A fire on a line, or on the surface of a solid. Line: the source is straight. Solid: the whole outline of a solid burns, wherever the solid is. Default "line". */
  sourceShape: "line" | "solid";
  /** A fire on another solid. Id of the solid whose surface is the source. If no solid has it, the source is a line. Default 0, from 0 to 1000000. */
  sourceSolid: number;
  /** A fire farther to the right, or below 0 to the left. Position of the middle of the source, which stays inside the domain. [m] Default 0, from -3 to 3. */
  sourceX: number;
  /** A flame that starts higher above the floor. Height of the source. In the combustion model it stays above the seam. [m] Default in combustion: 0.25, from 0 to 6. Default in classic: 0, from 0 to 6. */
  sourceHeight: number;
  /** A flame that leaves its source to the side. Angle of the width of the source from the horizontal, counterclockwise; what it emits leaves it at right angles. [°] Default 0, from -180 to 180. */
  sourceAngle: number;
  /** A flame that shoots up from its source. Speed of a particle at birth, or of the gas in the burner; upward unless the source is turned. A particle leaves a solid at right angles. In the combustion model, a solid has none: it supplies no gas. [m/s] Default in combustion: 0.6, from 0 to 1.5. Default in classic: 1, from 0 to 3. */
  emissionSpeed: number;
  /** A frayed flame that sprays to the sides. Random part of the velocity at birth. Default in classic: 0.25, from 0 to 1. */
  emissionSpread: number;
  /** An uneven flame that flares up here and there. How unevenly the source burns: Perlin noise in place and time. Default in combustion: 0.2, from 0 to 1. Default in classic: 0.5, from 0 to 1. */
  emissionNoise: number;
  /** A flame that ends in a point. How much shorter the lives of particles from the rim of the source are, within the shortest and the longest life. Default in classic: 0.8, from 0 to 1. */
  taper: number;
  /** A fuller flame, up to its top. Shortest life of a particle. [s] Default in classic: 0.3, from 0.1 to 3. */
  lifetimeMin: number;
  /** A whiter flame. Temperature of a particle at birth. [K] Default in classic: 1900, from 1000 to 2500. */
  maximumTemperature: number;
  /** A shorter flame with a redder top. How fast a particle cools towards the air. [K/s] Default in classic: 900, from 0 to 5000. */
  coolingRate: number;
  /** A hotter, whiter flame. Rise of the temperature if all fuel and all air burn. [K] Default in combustion: 1500, from 600 to 2500. */
  flameRise: number;
  /** A slower fire, whose flame begins higher. Time in which hot fuel with enough oxygen burns down to about a third. [s] Default in combustion: 0.08, from 0.02 to 0.5. */
  burnTime: number;
  /** A taller flame, because its fuel rises farther to find air. Parts of air that burn one part of fuel. Default in combustion: 1.5, from 0.5 to 6. */
  airDemand: number;
  /** A longer glow above the flame. Time in which hot soot, the source of the glow, burns away to about a third. [s] Default in combustion: 0.25, from 0.05 to 2. */
  sootLife: number;
  /** A shorter flame that fades to red sooner. How fast gas and embers of 1500 K cool by radiation, which grows with the fourth power of the temperature. [K/s] Default in combustion: 500, from 0 to 2000. */
  radiativeCooling: number;
  /** A flame that burns evenly down to its root; with 0 it is brightest at its rim. Oxygen in the fuel, relative to air. Default in combustion: 0.5, from 0 to 1. */
  sourceOxygen: number;
  /** A brighter root of the flame. Temperature of the gas in the burner, which is always above the ignition temperature. [K] Default in combustion: 700, from 500 to 1200. */
  sourceTemperature: number;
  /** A flame that tears off and goes out more easily. Temperature above which fuel burns where there is oxygen. [K] Default in combustion: 450, from 400 to 900. */
  ignitionTemperature: number;
  /** Another view of the same gas: the fire; every particle; a quantity of the gas, with a colour bar; the number of neighbours; the hard round sprites of the paper; or sprites with a texture. In the classic model, fuel is the remaining life of a particle, and soot is its smoke. Default "fire". */
  displayMode: "fire" | "particles" | "temperature" | "density" | "pressure" | "velocity" | "vorticity" | "distance" | "fuel" | "soot" | "neighbours" | "paper" | "sprites";
  /** Fire and smoke, the fire alone, or the smoke alone. The visible layers. Default "both". */
  layers: "both" | "fire" | "smoke";
  /** A deeper fire with more tongues. Number of slices: moments of the fire's past that are drawn behind the present one. Low quality shows three. Default in combustion: 5, from 1 to 5. */
  depth: number;
  /** A bright rim around a darker middle, as of a candle. Share of the light that is seen through a flame that is round about its axis; 0 is a plane flame. Default in combustion: 0, from 0 to 1. */
  roundness: number;
  /** Finer tongues and wisps. Strength of the fine structure that moves with the gas. Default 1, from 0 to 2. */
  detail: number;
  /** More contrast between bright and dim parts of the fire. Exponent that compresses the brightness of a black body. Default in combustion: 0.6, from 0.15 to 1. Default in classic: 0.35, from 0.15 to 1. */
  luminanceExponent: number;
  /** Larger, softer particles. Drawn size of a particle. [m] Default in classic: 0.04, from 0.0025 to 0.1. */
  particleSize: number;
  /** Colour of the coolest fire in the custom palette; transparent is black. Default "#8a12ff". */
  coolColour: string;
  /** Colour of the hottest fire in the custom palette; transparent is black. Default "#38e8ff". */
  hotColour: string;
  /** Colour behind the fire; with `transparent` the page shows through. Default "transparent". */
  background: string;
  /** A whiter, less red fire, and light of it. Temperature of the black body that the camera shows as white; at 6500 the fire has its physical hues. Other palettes keep theirs. [K] Default 3200, from 2000 to 6500. */
  whiteBalance: number;
  /** Solids in their own colours, as in a lit room or on a white page. White light of the surroundings on solids, wall and ground. Default 0, from 0 to 1. */
  ambientLight: number;
  /** A backdrop that shimmers behind the flame. How strongly hot gas refracts the view of the backdrop. The page behind the element is not refracted. Default 0.3, from 0 to 1. */
  heatHaze: number;
  /** Larger, slower swings of the flame. Size of the eddies of the turbulence. [m] Default 0.15, from 0.03 to 0.6. */
  turbulenceScale: number;
  /** More curls at the edges of the flame. How strongly small eddies keep the rotation that the computation would dissipate. Default in combustion: 0, from 0 to 1. */
  vorticityConfinement: number;
  /** A flame that rises faster. Classic: buoyancy β of gas that is thinner than the air; more of it narrows the fire. Combustion: buoyancy of hot gas; 1 is the physical value. Default in combustion: 1, from 0 to 2. Default in classic: 0.12, from 0 to 1. */
  buoyancy: number;
  /** A flame whose hot parts rise faster. Buoyancy of gas that is hotter than the air. Default in classic: 0.2, from 0 to 1. */
  thermalBuoyancy: number;
  /** A taller, quicker flame. Speed at which buoyancy and the drag of the air balance. [m/s] Default in classic: 2.5, from 0.5 to 3. */
  terminalSpeed: number;
  /** A lazier flame. Additional downward acceleration of every particle. [m/s²] Default in classic: 0, from 0 to 20. */
  extraWeight: number;
  /** A flame that rises faster and flickers more. Gravitational acceleration in the buoyancy; 0 is a fire in free fall. [m/s²] Default 9.81, from 0 to 20. */
  gravity: number;
  /** A fire that rises a little more slowly. Temperature of the air around the fire. [K] Default 293, from 250 to 350. */
  ambientTemperature: number;
  /** Classic: a fire that rises a little faster. Combustion: a smaller fire, because it heats more air. Density of the air around the fire. [kg/m³] Default 1.2, from 0.5 to 2. */
  ambientDensity: number;
  /** Larger sparks. Size of an ember. [m] Default in combustion: 0.004, from 0.001 to 0.02. */
  emberSize: number;
  /** Sparks that all fly far. Shortest life of an ember. [s] Default in combustion: 0.5, from 0.1 to 5. */
  emberLifeMin: number;
  /** Sparks of which some fly far. Longest life of an ember, at least the shortest life. [s] Default in combustion: 2, from 0.1 to 5. */
  emberLifeMax: number;
  /** Smoke that reaches higher. Time in which smoke, which is cold soot, decays to about a third. [s] Default in combustion: 1.5, from 0.1 to 10. */
  smokeLife: number;
  /** More space beside the fire, in a wider view. Width of the domain, which the picture fits. Open edges: gas is simulated beyond it, too. [m] Default 1.2, from 0.1 to 6. */
  domainWidth: number;
  /** More space above the fire, in a wider view. Height of the domain, which the picture fits. Open edges: gas is simulated beyond it, too. [m] Default in combustion: 1.8, from 0.1 to 6. Default in classic: 1.5, from 0.1 to 6. */
  domainHeight: number;
  /** Open sides, walls, or periodic sides. Particles at the left and the right edge leave, are stopped, or enter on the other side. The floor stops them, unless the sides are open; the top is always open. Default in classic: "open". */
  walls: "open" | "solid" | "periodic";
  /** A fire in the open, or in a closed box. Open: air surrounds the fire, smoke leaves, and fresh air enters. Periodic: gas that leaves on one side of the domain enters on the other. Default in combustion: "open". */
  edges: "open" | "periodic";
  /** A fire that stands on a floor, or one that draws air from below. A solid floor is at the lower edge of the domain. Default in combustion: "none". */
  floor: "none" | "solid";
  /** A fire that fades at the top and the bottom of the picture. Share of the height, at either end, in which gas becomes fresh air again. With 0 the domain is periodic without fresh air, and has neither wind nor buoyancy, because nothing would stop the gas. Default in combustion: 0.07, from 0 to 0.2. */
  seam: number;
  /** Another variation of the same fire. Seed of the random generator: the same seed gives the same fire. Default 1. */
  seed: number;
  /** The same fire at lower cost and accuracy. Length of one step, which is divided further for stability. [s] Default in classic: 0.004166667, from 0.002 to 0.017. */
  timeStep: number;
  /** A coarser fire that takes less work. Distance of neighbouring particles in air. Until it is set, it follows the domain, the number of particles and the quality. [m] Default in combustion: 0.0268, from 0.0003 to 0.5. */
  spacing: number;
  /** A finer fire that takes more work. Number of particles that would fill the domain. Until it is set, it follows the scene, the `spacing` and the quality. Default in combustion: 3000, from 200 to 100000. */
  particles: number;
  /** A fire that may grow larger. Largest number of particles, with open edges or in the classic model. The highest air sleeps beyond it; until it is set, there is room for twice the domain. Default in combustion: 6000, from 200 to 100000. Default in classic: 1000, from 100 to 100000. */
  maxParticles: number;
  /** A smoother, wider fire that takes more work. Smoothing length h: particles interact up to twice this distance. [m] Default in classic: 0.026, from 0.005 to 0.1. */
  smoothingRadius: number;
  /** A smoother fire that takes more work. Smoothing length h in spacings of the particles, which interact up to twice this distance. Default in combustion: 1.5, from 1.3 to 2. */
  smoothingRatio: number;
  /** A wider, coarser fire. Mass of one particle per metre of depth. [kg/m] Default in classic: 0.00025, from 0.0001 to 0.002. */
  particleMass: number;
  /** A narrower fire. Density at which the gas has no pressure. [kg/m³] Default in classic: 1, from 0.5 to 2. */
  restDensity: number;
  /** A wider fire. Gas constant k of p = k (ρ − ρ₀), the square of the speed of sound: how strongly compressed gas expands. [m²/s²] Default in classic: 0.6, from 0.05 to 6. */
  gasConstant: number;
  /** A more even fire that takes more work. Speed of sound in the simulated gas, far below the real one. A higher speed gives a more uniform density and shorter steps. It increases automatically for fires above 220 kW/m. [m/s] Default in combustion: 6, from 4 to 15. */
  stiffness: number;
  /** A calmer flame. Dynamic viscosity. [Pa·s] Default in classic: 0.005, from 0 to 0.1. */
  viscosity: number;
  /** A calmer, smoother flame. Kinematic viscosity: viscosity divided by density. [m²/s] Default in combustion: 0.0001, from 0 to 0.01. */
  kinematicViscosity: number;
  /** A calmer flame with fewer small curls. Viscosity between approaching particles only, which damps the noise of the particles. Default in combustion: 0.1, from 0.02 to 0.5. */
  artificialViscosity: number;
  /** A softer flame without small curls. How strongly unresolved eddies mix momentum, heat and gases: Smagorinsky's constant. Default in combustion: 0.2, from 0 to 0.4. */
  eddyViscosity: number;
  /** A compact flame that no hot rolls leave. Size C of the eddies into which rolls break up, in the length D* of the fire: how strongly rolls mix momentum, heat and gases. Default in combustion: 0.085, from 0 to 0.2. */
  rollMixing: number;
  /** A softer, blurred flame. Diffusivity of heat, fuel, oxygen and soot. [m²/s] Default in combustion: 0.0001, from 0 to 0.01. */
  diffusion: number;
  /** A wider, fuller flame. Exponent of the thermal expansion: 1 is the ideal gas, 0 the paper's equation of state, in which pressure depends on density only. Default in combustion: 0.5, from 0 to 1. */
  gasExpansion: number;
  /** A picture without gaps and clumps. How strongly particles are shifted from dense to sparse regions, so that they stay evenly distributed. Default in combustion: 1, from 0.2 to 1. */
  shifting: number;
  /** Faster particles, which only an extreme fire needs. Largest speed of a particle. [m/s] Default in classic: 5, from 4 to 8. */
  speedLimit: number;
  /** The paper's fire, with equation 1 as printed: the kernel with the factor of three dimensions. Default in classic: false. */
  printedKernel: boolean;
  /** The paper's fire, with equation 3 as printed: half the pressure force, not divided by the particle's own density. Default in classic: false. */
  printedPressure: boolean;
  /** The paper's fire, with equation 4 as printed: viscosity by the kernel's own Laplacian, which changes sign. Default in classic: false. */
  printedViscosity: boolean;
  /** The paper's fire, with equations 5 and 7 as printed: force densities divided by the mass instead of the density, and no thermal buoyancy. Default in classic: false. */
  printedDivisor: boolean;
  /** The paper's fire, with equation 6 as printed: forward Euler, the position moves with the old velocity. Default in classic: false. */
  printedEuler: boolean;
}

/** Where fuel comes into the air, or where the classic model's particles are born. */
export interface HearthSource {
  kind: "source";
  /** A whole number from 1, unique in its scene; without one it gets the next. */
  id?: number;
  /** An object that lists show under a name. Several objects may have the same. It is a line of at most 64 characters. Default "". */
  name?: string;
  /** A source that burns. One that is off emits nothing and keeps its values. So does one on a solid that is off. Default true. */
  enabled?: boolean;
  /** A fire on a line, or on the surface of a solid. Line: the source is straight. Solid: the whole outline of a solid burns, wherever the solid is. Default "line". */
  shape?: "line" | "solid";
  /** A fire on another solid. Id of the solid whose surface is the source. If no solid has it, the source is a line. Default 0, from 0 to 1000000. */
  solid?: number;
  /** A fire farther to the right, or below 0 to the left. Position of the middle of the source, which stays inside the domain. [m] Default 0, from -3 to 3. */
  x?: number;
  /** A flame that starts higher above the floor. Height of the source. In the combustion model it stays above the seam. [m] Default in combustion: 0.25, from 0 to 6. Default in classic: 0, from 0 to 6. */
  y?: number;
  /** A flame that leaves its source to the side. Angle of the width of the source from the horizontal, counterclockwise; what it emits leaves it at right angles. [°] Default 0, from -180 to 180. */
  angle?: number;
  /** A wider fire. Width of the source. In the combustion model it is at least four particles. [m] Default in combustion: 0.4, from 0.01 to 6. Default in classic: 0.36, from 0.05 to 0.6. */
  width?: number;
  /** A taller, brighter flame. Power of the burner per metre of depth: the heat of combustion of its fuel, without the heat of its hot gas. 0 turns it off. [kW/m] Default in combustion: 220, from 0 to 3000. */
  power?: number;
  /** A denser, brighter flame. Particles born per second, limited by the space at the source and by the number of particles. [1/s] Default in classic: 1500, from 50 to 100000. */
  rate?: number;
  /** A flame that shoots up from its source. Speed of a particle at birth, or of the gas in the burner; upward unless the source is turned. A particle leaves a solid at right angles. In the combustion model, a solid has none: it supplies no gas. [m/s] Default in combustion: 0.6, from 0 to 1.5. Default in classic: 1, from 0 to 3. */
  speed?: number;
  /** A frayed flame that sprays to the sides. Random part of the velocity at birth. Default in classic: 0.25, from 0 to 1. */
  spread?: number;
  /** An uneven flame that flares up here and there. How unevenly the source burns: Perlin noise in place and time. Default in combustion: 0.2, from 0 to 1. Default in classic: 0.5, from 0 to 1. */
  noise?: number;
  /** A brighter root of the flame. Temperature of the gas in the burner, which is always above the ignition temperature. [K] Default in combustion: 700, from 500 to 1200. */
  temperature?: number;
  /** A flame that burns evenly down to its root; with 0 it is brightest at its rim. Oxygen in the fuel, relative to air. Default in combustion: 0.5, from 0 to 1. */
  oxygen?: number;
  /** A whiter flame. Temperature of a particle at birth. [K] Default in classic: 1900, from 1000 to 2500. */
  birth_temperature?: number;
  /** A fuller flame, up to its top. Shortest life of a particle. [s] Default in classic: 0.3, from 0.1 to 3. */
  life_min?: number;
  /** A taller flame. Longest life of a particle, at least the shortest life. [s] Default in classic: 1.2, from 0.1 to 3. */
  life_max?: number;
  /** A flame that ends in a point. How much shorter the lives of particles from the rim of the source are, within the shortest and the longest life. Default in classic: 0.8, from 0 to 1. */
  taper?: number;
}

/** A body that gas flows around and does not enter. */
export interface HearthSolid {
  kind: "solid";
  /** A whole number from 1, unique in its scene; without one it gets the next. */
  id?: number;
  /** An object that lists show under a name. Several objects may have the same. It is a line of at most 64 characters. Default "". */
  name?: string;
  /** A solid that is there. One that is off neither acts nor is drawn, and keeps its values. Default true. */
  enabled?: boolean;
  /** A disc, a rectangle, a line, a polygon, a bent line or a picture. Shape of the solid. Default "circle". */
  shape?: "circle" | "box" | "line" | "polygon" | "stroke" | "mask";
  /** A solid farther to the right, or below 0 to the left. Position of its centre. [m] Default 0, from -10 to 10. */
  x?: number;
  /** A solid that is higher. Height of its centre above the lower edge of the domain. [m] Default 0.5, from -10 to 10. */
  y?: number;
  /** A solid that is turned. Angle of its width from the horizontal, counterclockwise. [°] Default 0, from -360 to 360. */
  angle?: number;
  /** A larger solid. Diameter of a circle, width of a box or a mask, length of a line. [m] Default 0.2, from 0.002 to 10. */
  width?: number;
  /** A thicker solid. Height of a box or a mask, thickness of a line or a stroke. A stroke is at least as thick as an eightieth of its extent. [m] Default 0.1, from 0.002 to 10. */
  height?: number;
  /** A rounder box. Radius of its corners, at most half of its smaller side. [m] Default 0, from 0 to 5. */
  corner?: number;
  /** A solid of any outline. Corners of a polygon or of a stroke, as pairs of numbers in metres from the centre. A polygon is closed, and what its outline winds around is solid; a stroke is open and has round ends. [m] Default "-0.1,-0.1 0.1,-0.1 0,0.1". */
  points?: string | readonly (readonly [number, number])[];
  /** A solid in the shape of a picture. Opacity of the pixels of a mask, which `hearth-fire/mask` makes from a text, a path or an image. Default "16x16:7". */
  mask?: string;
  /** A surface of stone, wood, iron and so on. Material that is drawn; `none` is invisible. Default "stone". */
  material?: "stone" | "wood" | "iron" | "brick" | "coal" | "wax" | "glass" | "cloth" | "none";
  /** A solid behind, within or before the fire. Gas flows around what is within it, and in every plane around a solid that has fuel, moves freely or carries a source; it passes the others, which are lit. One that is before the fire hides it. Solids later in the list are before earlier ones. Default "within". */
  plane?: "behind" | "within" | "before";
  /** A surface that heats or cools the gas. Adiabatic: no heat passes. Fixed: it keeps its temperature. Conducting: the gas and radiation heat and cool the solid, which has one temperature throughout. Default "adiabatic". */
  thermal?: "adiabatic" | "fixed" | "conducting";
  /** A hotter surface. Temperature of the surface, at first where it conducts heat. [K] Default 293, from 250 to 2500. */
  temperature?: number;
  /** A solid that heats and cools more slowly. Heat capacity by volume; that of stone and iron is 2000 to 3500. [kJ/(m³·K)] Default 100, from 10 to 5000. */
  heat_capacity?: number;
  /** A solid that burns where it is hot enough, until nothing is left. Each part has its own temperature; `thermal` has no effect. In the classic model it does not burn. Default "none". */
  fuel?: "none" | "wood" | "paper" | "coal" | "wax" | "cloth";
  /** A fire that lasts longer and spreads more slowly. Dry mass of the fuel by area of the solid. [kg/m²] Default 2, from 0.05 to 200. */
  load?: number;
  /** A fuel that catches fire later. Mass of the water as a share of that of the dry fuel. [%] Default 8, from 0 to 100. */
  moisture?: number;
  /** A solid that moves by itself, and pushes the gas. Sway: to and fro along a line. Spin: around its place. Free: it starts at its place and falls, rests on other solids and is pushed by the gas. No part of it is faster than 3 m/s, but for a free solid that hits another or hangs. With a fuel it breaks where it has burnt through, while there are fewer than 64 solids. Default "still". */
  motion?: "still" | "sway" | "spin" | "free";
  /** A solid that moves farther. Distance of its turning points from its place. [m] Default 0.3, from 0 to 5. */
  sway?: number;
  /** A motion along another line. Angle from the horizontal at which it starts, counterclockwise. [°] Default 0, from -360 to 360. */
  heading?: number;
  /** A slower motion. Time of one motion to and fro. [s] Default 4, from 0.5 to 60. */
  period?: number;
  /** A solid that turns faster counterclockwise or, below 0, clockwise. [°/s] Default 45, from -720 to 720. */
  spin?: number;
  /** A heavier solid. Its mass follows from its area; burnt material has no mass. That of wood is about 500. None is lighter than the gas beside it. [kg/m³] Default 500, from 0.1 to 10000. */
  density?: number;
  /** A solid that hangs. Id of the solid from which it hangs, by the highest of the middles of its sides. Where either burns through, it lets go. If no other solid has the id, it falls. Default 0, from 0 to 1000000. */
  hangs_from?: number;
  /** A rougher solid. Tangent of the angle at which it begins to slide on a fixed solid. Default 0.5, from 0 to 2. */
  friction?: number;
  /** A solid that bounces higher. Share of the speed of an impact with which it leaves. Default 0.1, from 0 to 1. */
  restitution?: number;
}

/** An object of a scene. */
export type HearthObject = HearthSource | HearthSolid;

/** Any id of a parameter. */
export type ParameterId = keyof HearthParameters;

/** Values to set: `undefined` states nothing, `null` restores the default. */
export type HearthValues = { [Id in ParameterId]?: HearthParameters[Id] | null | undefined } & {
  objects?: HearthObject[] | null | undefined;
};

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

/** What a fire reports about itself, about four times a second: see crates/hearth-engine/src/stats.rs. */
export interface HearthStats {
  /** Pictures per second. */
  fps: number;
  /** Number of particles. */
  particles: number;
  /** Share of the air around the fire that is left out, because `max_particles` are reached. */
  asleep: number;
  /** Number of particles removed because solids left no room, since the fire began. */
  removed: number;
  /** Number of glowing embers. */
  embers: number;
  /** Age of the fire [s]. */
  time: number;
  /** Power of the combustion [kW/m]; 0 in the classic model. */
  power: number;
  /** Colour of the light as a whole, as `#rrggbb`: of its palette, to the camera's white balance. */
  glow: string;
  /** Fuel that is left in solids, as a share; 0 without any. */
  fuelLeft: number;
  /** Whether solids with fuel burn: `burning` if one does. Otherwise `no-oxygen` or `out`, if one went out because it lacked oxygen or heat; `unlit`; `burnt`, if nothing is left; empty without fuel. */
  fuel: string;
  /** Real-time factor: seconds of fire per second of the clock, averaged over a second. */
  timeScale: number;
  /** Whether the fire fell behind the clock in the last second, so that the page stays responsive. */
  slowed: boolean;
  /** Simulation steps per picture. */
  stepsPerFrame: number;
  /** Length of a step [s of fire]. */
  stepLength: number;
  /** Number of substeps that the last step needed to be stable. */
  substeps: number;
  /** Time of a step on the processor [ms]. */
  stepMs: number;
  /** Time of drawing a picture on the processor [ms]. */
  drawMs: number;
  /** Time per frame of each stage [ms]: `sort`, `density`, `forces` and `integrate` of all steps, whose sum is `stepMs` × `stepsPerFrame`, and `upload`, which is part of `drawMs`. Averages over more than a hundred steps hide the coarse clocks of browsers. */
  stages: Record<'sort' | 'density' | 'forces' | 'integrate' | 'upload', number>;
  /** Time of each render pass [ms], by name, in drawing order. */
  passes: Record<string, number>;
  /** What `passes` measures: `gpu`, time on the graphics card, of all passes of a picture after the results of the one before; `submit`, time of submitting the pass, if the browser offers no timer query. */
  passTimer: 'gpu' | 'submit' | '';
  /** Number of slices of the last picture: fewer than `depth` at low quality, while slices fade in, and where many fires share their memory. */
  slices: number;
  /** The current level of quality. */
  quality: 'low' | 'medium' | 'high';
  /** The reason of that level. */
  qualityReason: string;
  /** What limits the number of particles: `quality low`, `quality medium`, `quality high`, `size` or, where more would take too long, `speed`; else empty. */
  limit: string;
  /** Mean number of neighbours of a particle. */
  neighbours: number;
  /** Quantities of the first and last colour, such as `[0, 2000]`, in the unit of the shown quantity; `null` if `display_mode` shows none. */
  scale: [min: number, max: number] | null;
  /** Number of particles at the speed limit. */
  atSpeedLimit: number;
  /** Whether the fire is paused. */
  paused: boolean;
  /** Format of the render targets. */
  targetFormat: string;
  /** Where the engine runs: `worker` or `main`. */
  engine: 'worker' | 'main';
}
