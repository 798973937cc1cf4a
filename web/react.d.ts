// Generated from the parameter table of hearth-core and the table of the element
// by `cargo xtask codegen`; edit crates/hearth-core/src/params.rs or
// crates/xtask/src/codegen/element.rs instead.

/**
 * `<hearth-fire>` in JSX, for React 19 and newer: `import 'hearth-fire/react'`
 * instead of `'hearth-fire'`, and attributes and events have their types.
 */

import type { DetailedHTMLProps, HTMLAttributes } from 'react';
import type {
  HearthChangeDetail,
  HearthErrorDetail,
  HearthFire,
  HearthQuality,
  HearthQualityDetail,
  HearthStats,
  PresetName,
} from './hearth-fire.js';

export * from './hearth-fire.js';

declare module 'react' {
  namespace JSX {
    interface IntrinsicElements {
      'hearth-fire': DetailedHTMLProps<HearthFireProps, HearthFire>;
    }
  }
}

/** Everything that `<hearth-fire>` takes in JSX. */
export type HearthFireProps = HearthFireAttributes &
  HearthFireListeners &
  Omit<HTMLAttributes<HearthFire>, keyof HearthFireAttributes | keyof HearthFireListeners>;

/** The attributes of `<hearth-fire>`; one that is taken away is back at its default. */
export interface HearthFireAttributes {
  /** The named set of values that the fire starts from. Changed later, it replaces every value. */
  preset?: PresetName | undefined;
  /** The address of a JSON file with settings, as `exportConfig()` gives them. */
  src?: string | undefined;
  /** How much work the fire may make itself; `auto`: as much as fits. */
  quality?: 'auto' | HearthQuality | undefined;
  /** The fire stands still while this is there. */
  paused?: boolean | undefined;
  /** `false`: the fire stands still until `play()`. */
  autoplay?: boolean | undefined;
  /** When the fire is loaded: `lazy`, when it comes near the window; `eager`, at once. */
  loading?: 'auto' | 'lazy' | 'eager' | undefined;
  /** The address of a picture that is shown until the fire burns, and where it cannot. */
  poster?: string | undefined;
  /** What a screen reader says of the fire; without it the fire is decoration. */
  alt?: string | undefined;
  /** Most pixels that the picture may have. */
  "max-pixels"?: number | string | undefined;
  /** Most pictures a second. */
  "fps-limit"?: number | string | undefined;
  /** Seconds of fire, 0 to 30, that a new fire burns before it is shown: 3 where the attribute has no value. The poster or the picture before stays meanwhile. */
  warm?: number | boolean | string | undefined;
  /** The fire takes pointers, which stir it; without this clicks go through it. */
  interactive?: boolean | undefined;
  /** What fingers do on an interactive fire, as CSS's `touch-action`; without it `pan-y`. */
  "touch-action"?: string | undefined;
  /** Shows the panel of sliders inside the element, or those of a list of parameters; its code is loaded only then. */
  controls?: boolean | string | undefined;
  /** `auto`: a still fire with a play button where the visitor wants less motion. */
  "reduced-motion"?: 'auto' | 'ignore' | undefined;
  /** Which equations move the particles. Classic: the paper's, in which hot particles are born, cool and die. Combustion: fuel enters the air, mixes with it and burns. Default "combustion". */
  model?: "classic" | "combustion" | undefined;
  /** Width of the simulated domain; the source stands in it where its place says. In the combustion model what leaves on one side comes back in on the other. [m] Default 1.2, from 0.1 to 6. */
  "domain-width"?: number | `${number}` | undefined;
  /** Height of the simulated domain; the picture fits it. [m] Default in combustion: 1.8, from 0.1 to 6. Default in classic: 1.5, from 0.1 to 6. */
  "domain-height"?: number | `${number}` | undefined;
  /** What happens at the left and the right edge: particles leave, are held back, or come back in on the other side. The floor holds them back, unless the edges are open; the top is always open. Default in classic: "open". */
  walls?: "open" | "solid" | "periodic" | undefined;
  /** Acceleration of gravity, as buoyancy feels it. [m/s²] Default 9.81, from 0 to 20. */
  gravity?: number | `${number}` | undefined;
  /** Temperature of the air around the fire. [K] Default 293, from 250 to 350. */
  "ambient-temperature"?: number | `${number}` | undefined;
  /** Density of the air around the fire. [kg/m³] Default 1.2, from 0.5 to 2. */
  "ambient-density"?: number | `${number}` | undefined;
  /** How much of the height, at the top and at the bottom, gas becomes fresh air again. 0 closes the domain upon itself; then no wind blows, and nothing is lifted: nothing would ever stop it. Default in combustion: 0.07, from 0 to 0.2. */
  seam?: number | `${number}` | undefined;
  /** Classic: most particles alive at one time. Combustion: into about how many particles air and gas are divided; more of them are finer, and slower. Default in combustion: 3000, from 200 to 100000. Default in classic: 1000, from 100 to 100000. */
  "max-particles"?: number | `${number}` | undefined;
  /** Smoothing length h: particles feel each other up to twice this distance. [m] Default in classic: 0.026, from 0.005 to 0.1. */
  "smoothing-radius"?: number | `${number}` | undefined;
  /** Smoothing length h in spacings of the particles: they feel each other up to twice this distance. More of it is smoother, and slower. Default in combustion: 1.5, from 1.3 to 2. */
  "smoothing-ratio"?: number | `${number}` | undefined;
  /** Mass of one particle, for each metre of depth. [kg/m] Default in classic: 0.00025, from 0.0001 to 0.002. */
  "particle-mass"?: number | `${number}` | undefined;
  /** Density at which the gas has no pressure. [kg/m³] Default in classic: 1, from 0.5 to 2. */
  "rest-density"?: number | `${number}` | undefined;
  /** Gas constant k of p = k (ρ − ρ₀), the square of the speed of sound: how hard compressed gas pushes apart. More of it widens the fire. [m²/s²] Default in classic: 0.6, from 0.05 to 6. */
  "gas-constant"?: number | `${number}` | undefined;
  /** Speed of sound in the simulated gas, far below the real one: how hard compressed gas pushes apart. More of it keeps the density more even and makes the steps shorter. It grows by itself for fires above 220 kW/m. [m/s] Default in combustion: 6, from 4 to 15. */
  stiffness?: number | `${number}` | undefined;
  /** Dynamic viscosity: how strongly neighbours share their motion. [Pa·s] Default in classic: 0.005, from 0 to 0.1. */
  viscosity?: number | `${number}` | undefined;
  /** Viscosity divided by density: how fast neighbours share their motion. [m²/s] Default in combustion: 0.0001, from 0 to 0.01. */
  "kinematic-viscosity"?: number | `${number}` | undefined;
  /** Viscosity between particles that approach each other and none else: it damps the noise of the particles. Default in combustion: 0.1, from 0.02 to 0.5. */
  "artificial-viscosity"?: number | `${number}` | undefined;
  /** How strongly whirls that are too small to be resolved mix motion, heat and gases: Smagorinsky's constant. Default in combustion: 0.2, from 0 to 0.4. */
  "eddy-viscosity"?: number | `${number}` | undefined;
  /** How fast heat, fuel, oxygen and soot spread by themselves, without any flow. [m²/s] Default in combustion: 0.0001, from 0 to 0.01. */
  diffusion?: number | `${number}` | undefined;
  /** How far hot gas takes more room: 1 is the ideal gas, 0 the paper's equation of state, in which only density makes pressure. Default in combustion: 0.5, from 0 to 1. */
  "gas-expansion"?: number | `${number}` | undefined;
  /** How strongly particles are moved from where they crowd to where they are sparse, so that they stay evenly spread. Default in combustion: 1, from 0.2 to 1. */
  shifting?: number | `${number}` | undefined;
  /** Classic: lift β of gas that is thinner than the air; more of it narrows the fire. Combustion: lift of gas that is hotter than the air; 1 is nature's. Default in combustion: 1, from 0 to 2. Default in classic: 0.12, from 0 to 1. */
  buoyancy?: number | `${number}` | undefined;
  /** Lift of gas that is hotter than the air. Default in classic: 0.2, from 0 to 1. */
  "thermal-buoyancy"?: number | `${number}` | undefined;
  /** Weight added to every particle, as if gravity counted a second time. [m/s²] Default in classic: 0, from 0 to 20. */
  "extra-weight"?: number | `${number}` | undefined;
  /** Speed at which lift and the resistance of the air, which this model leaves out otherwise, balance. [m/s] Default in classic: 2.5, from 0.5 to 3. */
  "terminal-speed"?: number | `${number}` | undefined;
  /** A net, not a law: no particle moves faster. [m/s] Default in classic: 4, from 4 to 8. */
  "speed-limit"?: number | `${number}` | undefined;
  /** Speed of the fresh air from left to right; below 0 it blows from right to left. [m/s] Default in combustion: 0, from -3 to 3. */
  wind?: number | `${number}` | undefined;
  /** Strength of a random field of drifting whirls that stirs the gas and compresses it nowhere. [m/s²] Default 0, from 0 to 10. */
  turbulence?: number | `${number}` | undefined;
  /** Size of the whirls that turbulence stirs. [m] Default 0.15, from 0.03 to 0.6. */
  "turbulence-scale"?: number | `${number}` | undefined;
  /** How strongly small whirls are kept spinning that would be smeared out otherwise. Default in combustion: 0, from 0 to 1. */
  "vorticity-confinement"?: number | `${number}` | undefined;
  /** Particles born each second, as long as the source has room and the number of particles allows it. [1/s] Default in classic: 1500, from 50 to 100000. */
  "emission-rate"?: number | `${number}` | undefined;
  /** Shortest life of a particle. [s] Default in classic: 0.3, from 0.1 to 3. */
  "lifetime-min"?: number | `${number}` | undefined;
  /** Longest life of a particle. A life below the shortest one counts as the shortest. [s] Default in classic: 1.2, from 0.1 to 3. */
  "lifetime-max"?: number | `${number}` | undefined;
  /** How much shorter particles live that are born towards the rim of the source, within the shortest and the longest life: it gives the fire its tip. Default in classic: 0.8, from 0 to 1. */
  taper?: number | `${number}` | undefined;
  /** Power of the burner: the heat of the fuel that it feeds, for each metre of depth, on top of what its gas carries by being hot; 0 turns it off. [kW/m] Default in combustion: 220, from 0 to 600. */
  "fuel-power"?: number | `${number}` | undefined;
  /** Upward speed of what leaves the source: of a particle at birth, or of the gas in the burner. [m/s] Default in combustion: 0.25, from 0 to 1.5. Default in classic: 1, from 0 to 3. */
  "emission-speed"?: number | `${number}` | undefined;
  /** Random part of the velocity at birth. Default in classic: 0.25, from 0 to 1. */
  "emission-spread"?: number | `${number}` | undefined;
  /** How unevenly the source burns: Perlin noise in place and time. Default in combustion: 0.2, from 0 to 1. Default in classic: 0.5, from 0 to 1. */
  "emission-noise"?: number | `${number}` | undefined;
  /** Width of the source; combustion: of the burner, which is at least four particles wide. [m] Default in combustion: 0.4, from 0.01 to 1. Default in classic: 0.36, from 0.05 to 0.6. */
  "source-width"?: number | `${number}` | undefined;
  /** Moves the fire to the right, below 0 to the left: place of the middle of the source, all of which stays inside the domain. [m] Default 0, from -3 to 3. */
  "source-x"?: number | `${number}` | undefined;
  /** Height of the source above the floor; combustion: of the burner, which stays above the seam. [m] Default in combustion: 0.25, from 0 to 1. Default in classic: 0, from 0 to 1. */
  "source-height"?: number | `${number}` | undefined;
  /** Temperature of a particle at birth. [K] Default in classic: 1900, from 1000 to 2500. */
  "maximum-temperature"?: number | `${number}` | undefined;
  /** How fast a particle cools towards the air. [K/s] Default in classic: 900, from 0 to 5000. */
  "cooling-rate"?: number | `${number}` | undefined;
  /** Temperature of the gas in the burner, which is always hot enough to burn. [K] Default in combustion: 700, from 500 to 1200. */
  "source-temperature"?: number | `${number}` | undefined;
  /** Oxygen that the fuel brings along: with 0 it burns only where it meets the air, hottest at the rim of the flame; 1 is as much as the air has. Default in combustion: 0.5, from 0 to 1. */
  "source-oxygen"?: number | `${number}` | undefined;
  /** Temperature above which fuel burns where there is oxygen. [K] Default in combustion: 450, from 400 to 900. */
  "ignition-temperature"?: number | `${number}` | undefined;
  /** How much hotter gas becomes where fuel and air burn up without a remainder. [K] Default in combustion: 1500, from 600 to 2500. */
  "flame-rise"?: number | `${number}` | undefined;
  /** Parts of air that one part of fuel needs to burn. Default in combustion: 1.5, from 0.5 to 6. */
  "air-demand"?: number | `${number}` | undefined;
  /** Time in which hot fuel with enough oxygen burns down to about a third. [s] Default in combustion: 0.08, from 0.02 to 0.5. */
  "burn-time"?: number | `${number}` | undefined;
  /** How fast gas and embers of 1500 K cool by what they radiate; that grows with the fourth power of the temperature. [K/s] Default in combustion: 500, from 0 to 2000. */
  "radiative-cooling"?: number | `${number}` | undefined;
  /** Time in which hot soot, which makes a flame glow, burns away to about a third. [s] Default in combustion: 0.25, from 0.05 to 2. */
  "soot-life"?: number | `${number}` | undefined;
  /** Time in which smoke, soot that has cooled, thins out to about a third. [s] Default in combustion: 1.5, from 0.1 to 10. */
  "smoke-life"?: number | `${number}` | undefined;
  /** Embers thrown each second: sparks that the flow carries off. [1/s] Default in combustion: 40, from 0 to 1000. */
  "ember-rate"?: number | `${number}` | undefined;
  /** Shortest life of an ember. [s] Default in combustion: 0.5, from 0.1 to 5. */
  "ember-life-min"?: number | `${number}` | undefined;
  /** Longest life of an ember. A life below the shortest one counts as the shortest. [s] Default in combustion: 2, from 0.1 to 5. */
  "ember-life-max"?: number | `${number}` | undefined;
  /** Size of an ember. [m] Default in combustion: 0.004, from 0.001 to 0.02. */
  "ember-size"?: number | `${number}` | undefined;
  /** Seconds of fire for each second of the clock: below 1 is slow motion. Default 1, from 0.1 to 2. */
  "time-scale"?: number | `${number}` | undefined;
  /** Length of one step; it is divided further where stability asks for it. [s] Default in classic: 0.004166667, from 0.002 to 0.017. */
  "time-step"?: number | `${number}` | undefined;
  /** Start of the random generator: the same seed gives the same fire. Default 1. */
  seed?: number | `${number}` | 'auto' | undefined;
  /** Equation 1 as printed: the kernel with the factor of three dimensions. Default in classic: false. */
  "printed-kernel"?: boolean | undefined;
  /** Equation 3 as printed: half the pressure force, not divided by the particle's own density. Default in classic: false. */
  "printed-pressure"?: boolean | undefined;
  /** Equation 4 as printed: viscosity by the kernel's own Laplacian, which changes sign. Default in classic: false. */
  "printed-viscosity"?: boolean | undefined;
  /** Equations 5 and 7 as printed: densities of force divided by the mass instead of the density, and no lift by temperature. Default in classic: false. */
  "printed-divisor"?: boolean | undefined;
  /** Equation 6 as printed: forward Euler, the position moves with the old velocity. Default in classic: false. */
  "printed-euler"?: boolean | undefined;
  /** What is shown: the fire; every particle; a quantity of the gas, with a bar that says which colour is how much; the number of neighbours; the hard round sprites of the paper; or sprites with a texture. In the classic model fuel is what is left of a particle's life, and soot what makes smoke of it. Default "fire". */
  "display-mode"?: "fire" | "particles" | "temperature" | "density" | "pressure" | "velocity" | "vorticity" | "fuel" | "soot" | "neighbours" | "paper" | "sprites" | undefined;
  /** What is drawn: fire and smoke, the fire alone, or the smoke alone. Default "both". */
  layers?: "both" | "fire" | "smoke" | undefined;
  /** Size at which a particle is drawn. [m] Default in classic: 0.04, from 0.01 to 0.1. */
  "particle-size"?: number | `${number}` | undefined;
  /** Brightness, in steps that each double it. [EV] Default 0, from -4 to 4. */
  exposure?: number | `${number}` | undefined;
  /** How much of a black body's enormous range of brightness is kept. Default 0.35, from 0.15 to 1. */
  "luminance-exponent"?: number | `${number}` | undefined;
  /** How strongly smoke hides what is behind it. Default 0.3, from 0 to 2. */
  "smoke-opacity"?: number | `${number}` | undefined;
  /** Glow around bright places. Default 0.15, from 0 to 0.6. */
  bloom?: number | `${number}` | undefined;
  /** Fine structure that rises with the flow. Default 1, from 0 to 2. */
  detail?: number | `${number}` | undefined;
  /** Colours of the fire: those of glowing soot, of gas, of copper or lithium salts, of a ghost, or from a cool colour to a hot one. Default "blackbody". */
  palette?: "blackbody" | "gas" | "copper" | "lithium" | "ghost" | "custom" | undefined;
  /** Colour of the coolest fire, where the palette is the custom one; transparent is black. Default "#8a12ff". */
  "cool-colour"?: string | undefined;
  /** Colour of the hottest fire, where the palette is the custom one; transparent is black. Default "#38e8ff". */
  "hot-colour"?: string | undefined;
  /** What the fire burns in front of, in place of the background: nothing, or a wall of bricks that it lights. Default "none". */
  backdrop?: "none" | "bricks" | undefined;
  /** How strongly hot gas makes the backdrop shimmer; a page cannot be made to. Default 0.3, from 0 to 1. */
  "heat-haze"?: number | `${number}` | undefined;
  /** What stands behind the fire: `transparent` or a colour. Default "transparent". */
  background?: string | undefined;
}

/** The events of `<hearth-fire>`. */
export interface HearthFireListeners {
  /** The fire burns. */
  onready?: ((event: CustomEvent<null>) => void) | undefined;
  /** It burns again. */
  onplay?: ((event: CustomEvent<null>) => void) | undefined;
  /** It stands still. */
  onpause?: ((event: CustomEvent<null>) => void) | undefined;
  /** A value changed, whoever changed it. */
  "onparams-change"?: ((event: CustomEvent<HearthChangeDetail>) => void) | undefined;
  /** The fire makes itself more or less work than before. */
  "onquality-change"?: ((event: CustomEvent<HearthQualityDetail>) => void) | undefined;
  /** What the fire says about itself, about four times a second. */
  onstats?: ((event: CustomEvent<HearthStats>) => void) | undefined;
  /** Something is wrong: a value that was refused, a file that did not arrive, a browser that cannot. */
  onerror?: ((event: CustomEvent<HearthErrorDetail>) => void) | undefined;
  /** The graphics context was lost and is back. */
  onrestored?: ((event: CustomEvent<null>) => void) | undefined;
}
