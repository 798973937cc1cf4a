// Generated from the class in web/hearth-fire.js, its types and the table of parameters by
// `cargo xtask codegen`; edit the JSDoc of the class or web/element/types.d.ts instead.

/**
 * `<hearth-fire>` in JSX, for React 19 and newer: `import 'hearth-fire/react'`
 * instead of `'hearth-fire'`, and attributes and events have their types.
 */

/// <reference path="./react-global.d.cts" />

import type {
  HearthChangeDetail,
  HearthErrorDetail,
  HearthFire,
  HearthHistoryDetail,
  HearthObject,
  HearthObjectsDetail,
  HearthQuality,
  HearthQualityDetail,
  HearthSolidElement,
  HearthSoundDetail,
  HearthSourceElement,
  HearthStats,
  PresetName,
} from './hearth-fire.js';

export * from './hearth-fire.js';

import React = globalThis.React;

declare module './react-global.cjs' {
  namespace JSX {
    interface IntrinsicElements {
      'hearth-fire': React.DetailedHTMLProps<HearthFireProps, HearthFire>;
      'hearth-source': React.DetailedHTMLProps<HearthSourceAttributes & React.HTMLAttributes<HearthSourceElement>, HearthSourceElement>;
      'hearth-solid': React.DetailedHTMLProps<HearthSolidAttributes & React.HTMLAttributes<HearthSolidElement>, HearthSolidElement>;
    }
  }
}

/** Everything that `<hearth-fire>` takes in JSX. */
export type HearthFireProps = HearthFireAttributes &
  HearthFireListeners &
  Omit<React.HTMLAttributes<HearthFire>, keyof HearthFireAttributes | keyof HearthFireListeners>;

/** The attributes of `<hearth-fire>`; one that is taken away is back at its default. */
export interface HearthFireAttributes {
  /** The named set of values that the fire starts from. A later change replaces every value. */
  preset?: PresetName | null | undefined;
  /** Copies of the objects of the fire, each with its kind, its id and its properties. Setting the list replaces all objects. The attribute holds them as JSON; without it the fire has one source, which the parameters describe. */
  objects?: Required<HearthObject>[] | null | undefined;
  /** The level of detail of simulation and picture; `auto` follows the speed of the device. */
  quality?: 'auto' | HearthQuality | null | undefined;
  /** Whether the fire is paused. */
  paused?: boolean | null | undefined;
  /** `false`: the fire is paused until `play()`. */
  autoplay?: boolean | null | undefined;
  /** The URL of a JSON file with settings, as `exportConfig()` returns them; empty without one. A fire begins without a file that takes longer than two seconds, and takes it over when it arrives. */
  src?: string | null | undefined;
  /** When the fire is loaded: `auto`, at once if it is visible, else when the page has loaded; `lazy`, when it comes near the window; `eager`, at once. */
  loading?: 'auto' | 'lazy' | 'eager' | null | undefined;
  /** The URL of an image that is shown until the fire burns, and in browsers that cannot show it. */
  poster?: string | null | undefined;
  /** The description for screen readers; without one the fire is decoration. */
  alt?: string | null | undefined;
  /** The maximum number of pixels of the picture, from 1024 to 16777216; if empty, that of a 720p, 1080p or 1440p screen, by quality. */
  'max-pixels'?: number | string | null | undefined;
  /** The maximum frames per second, from 10 to 240; if empty, those of the display. */
  'fps-limit'?: number | string | null | undefined;
  /** Simulated seconds, 0 to 30, before the first frame of a new fire; 3 if the attribute has no value. The poster or the last frame stays meanwhile. */
  warm?: number | boolean | string | null | undefined;
  /** The fire reacts to pointers: they stir it, a click emits sparks, a drag moves its source. Otherwise clicks pass through it. */
  interactive?: boolean | null | undefined;
  /** How the domain fits the picture: `height` and `width` match that side, `contain` shows the whole domain, `cover` fills the picture with it. */
  fit?: 'height' | 'contain' | 'cover' | 'width' | null | undefined;
  /** Where the domain lies in the picture, in the keywords of CSS's `object-position`: `left`, `center` or `right`, and `top`, `center` or `bottom`. The default is `center bottom`. */
  align?: string | null | undefined;
  /** How much the picture is enlarged, from 1 to 10. It changes the view, not the fire. Gestures of an interactive fire change it too. */
  zoom?: number | null | undefined;
  /** Which part of the enlarged picture is seen: two numbers from 0 to 1, its position from the left and from below. The default is `0.5 0.5`, the middle. */
  pan?: string | null | undefined;
  /** The volume of the fire's sound, from 0 to 1; 0 is silent. It begins with the visitor's first click, tap or key on the page. Its code is loaded on request. */
  sound?: number | null | undefined;
  /** How loud the fire roars, from 0 to 2. At 1, the balance of roar, crackle and hiss is that of recorded fires. */
  roar?: number | null | undefined;
  /** How loud the fire crackles, from 0 to 2. */
  crackle?: number | null | undefined;
  /** How loud the fire hisses, from 0 to 2. */
  hiss?: number | null | undefined;
  /** What touches of an interactive fire do to the page, as CSS's `touch-action`. The default is `pan-y`. */
  'touch-action'?: string | null | undefined;
  /** Shows the panel of sliders inside the element, for all parameters or for a list of them. Its code is loaded on request. */
  controls?: boolean | string | null | undefined;
  /** `auto`: visitors who prefer reduced motion get a paused fire with a play button. */
  'reduced-motion'?: 'auto' | 'ignore' | null | undefined;
  /** Another kind of fire. Classic: the paper's equations, in which hot particles are born, cool and die. Combustion: fuel enters the air, mixes with it and burns. Default "combustion". */
  model?: "classic" | "combustion" | null | undefined;
  /** A taller, brighter flame. Power of the burner per metre of depth: the heat of combustion of its fuel, without the heat of its hot gas. 0 turns it off. [kW/m] Default in combustion: 220, from 0 to 600. */
  'fuel-power'?: number | `${number}` | null | undefined;
  /** A denser, brighter flame. Particles born per second, limited by the space at the source and by the number of particles. [1/s] Default in classic: 1500, from 50 to 100000. */
  'emission-rate'?: number | `${number}` | null | undefined;
  /** A wider fire. Width of the source. In the combustion model it is at least four particles. [m] Default in combustion: 0.4, from 0.01 to 1. Default in classic: 0.36, from 0.05 to 0.6. */
  'source-width'?: number | `${number}` | null | undefined;
  /** A taller flame. Longest life of a particle, at least the shortest life. [s] Default in classic: 1.2, from 0.1 to 3. */
  'lifetime-max'?: number | `${number}` | null | undefined;
  /** A livelier, wilder flame. Acceleration by a random field of drifting eddies, which does not compress the gas. [m/s²] Default 0, from 0 to 10. */
  turbulence?: number | `${number}` | null | undefined;
  /** A flame that leans to the right, or below 0 to the left. Speed of the fresh air from left to right. [m/s] Default in combustion: 0, from -3 to 3. */
  wind?: number | `${number}` | null | undefined;
  /** Other colours of the fire: those of glowing soot, of gas, of copper or lithium salts, of a ghost, or your own from a cool colour to a hot one. Default "blackbody". */
  palette?: "blackbody" | "gas" | "copper" | "lithium" | "ghost" | "custom" | null | undefined;
  /** A brighter picture. Exposure in stops, each of which doubles the light. [EV] Default 0, from -4 to 4. */
  exposure?: number | `${number}` | null | undefined;
  /** A wider shine around bright places. Share of the light that a lens scatters. Default 0.15, from 0 to 0.6. */
  bloom?: number | `${number}` | null | undefined;
  /** Thicker smoke. Opacity of the smoke. Default 0.3, from 0 to 2. */
  'smoke-opacity'?: number | `${number}` | null | undefined;
  /** More sparks. Embers emitted per second. The flow carries them. [1/s] Default in combustion: 40, from 0 to 1000. */
  'ember-rate'?: number | `${number}` | null | undefined;
  /** A wall behind the fire, in place of the background. The fire lights it. Default "none". */
  backdrop?: "none" | "bricks" | null | undefined;
  /** A ground under the fire, which lights it. Solids cast shadows on it. Over a transparent background, only its light and its shadows are drawn. Default "none". */
  ground?: "none" | "stone" | "earth" | "sand" | "snow" | null | undefined;
  /** A faster fire; below 1 slow motion. Seconds of fire for each second of the clock. Default 1, from 0.1 to 2. */
  'time-scale'?: number | `${number}` | null | undefined;
  /** A source that burns. One that is off emits nothing and keeps its values. So does one on a solid that is off. Default true. */
  'source-enabled'?: boolean | null | undefined;
  /** A fire on a line, or on the surface of a solid. Line: the source is straight. Solid: the whole outline of a solid burns, wherever the solid is. Default "line". */
  'source-shape'?: "line" | "solid" | null | undefined;
  /** A fire on another solid. Id of the solid whose surface is the source. If no solid has it, the source is a line. Default 0, from 0 to 1000000. */
  'source-solid'?: number | `${number}` | null | undefined;
  /** A fire farther to the right, or below 0 to the left. Position of the middle of the source, which stays inside the domain. [m] Default 0, from -3 to 3. */
  'source-x'?: number | `${number}` | null | undefined;
  /** A flame that starts higher above the floor. Height of the source. In the combustion model it stays above the seam. [m] Default in combustion: 0.25, from 0 to 6. Default in classic: 0, from 0 to 6. */
  'source-height'?: number | `${number}` | null | undefined;
  /** A flame that leaves its source to the side. Angle of the width of the source from the horizontal, counterclockwise; what it emits leaves it at right angles. [°] Default 0, from -180 to 180. */
  'source-angle'?: number | `${number}` | null | undefined;
  /** A flame that shoots up from its source. Speed of a particle at birth, or of the gas in the burner; upward unless the source is turned. A particle leaves a solid at right angles. In the combustion model, a solid has none: it supplies no gas. [m/s] Default in combustion: 0.25, from 0 to 1.5. Default in classic: 1, from 0 to 3. */
  'emission-speed'?: number | `${number}` | null | undefined;
  /** A frayed flame that sprays to the sides. Random part of the velocity at birth. Default in classic: 0.25, from 0 to 1. */
  'emission-spread'?: number | `${number}` | null | undefined;
  /** An uneven flame that flares up here and there. How unevenly the source burns: Perlin noise in place and time. Default in combustion: 0.2, from 0 to 1. Default in classic: 0.5, from 0 to 1. */
  'emission-noise'?: number | `${number}` | null | undefined;
  /** A flame that ends in a point. How much shorter the lives of particles from the rim of the source are, within the shortest and the longest life. Default in classic: 0.8, from 0 to 1. */
  taper?: number | `${number}` | null | undefined;
  /** A fuller flame, up to its top. Shortest life of a particle. [s] Default in classic: 0.3, from 0.1 to 3. */
  'lifetime-min'?: number | `${number}` | null | undefined;
  /** A whiter flame. Temperature of a particle at birth. [K] Default in classic: 1900, from 1000 to 2500. */
  'maximum-temperature'?: number | `${number}` | null | undefined;
  /** A shorter flame with a redder top. How fast a particle cools towards the air. [K/s] Default in classic: 900, from 0 to 5000. */
  'cooling-rate'?: number | `${number}` | null | undefined;
  /** A hotter, whiter flame. Rise of the temperature if all fuel and all air burn. [K] Default in combustion: 1500, from 600 to 2500. */
  'flame-rise'?: number | `${number}` | null | undefined;
  /** A slower fire, whose flame begins higher. Time in which hot fuel with enough oxygen burns down to about a third. [s] Default in combustion: 0.08, from 0.02 to 0.5. */
  'burn-time'?: number | `${number}` | null | undefined;
  /** A taller flame, because its fuel rises farther to find air. Parts of air that burn one part of fuel. Default in combustion: 1.5, from 0.5 to 6. */
  'air-demand'?: number | `${number}` | null | undefined;
  /** A longer glow above the flame. Time in which hot soot, the source of the glow, burns away to about a third. [s] Default in combustion: 0.25, from 0.05 to 2. */
  'soot-life'?: number | `${number}` | null | undefined;
  /** A shorter flame that fades to red sooner. How fast gas and embers of 1500 K cool by radiation, which grows with the fourth power of the temperature. [K/s] Default in combustion: 500, from 0 to 2000. */
  'radiative-cooling'?: number | `${number}` | null | undefined;
  /** A flame that burns evenly down to its root; with 0 it is brightest at its rim. Oxygen in the fuel, relative to air. Default in combustion: 0.5, from 0 to 1. */
  'source-oxygen'?: number | `${number}` | null | undefined;
  /** A brighter root of the flame. Temperature of the gas in the burner, which is always above the ignition temperature. [K] Default in combustion: 700, from 500 to 1200. */
  'source-temperature'?: number | `${number}` | null | undefined;
  /** A flame that tears off and goes out more easily. Temperature above which fuel burns where there is oxygen. [K] Default in combustion: 450, from 400 to 900. */
  'ignition-temperature'?: number | `${number}` | null | undefined;
  /** Another view of the same gas: the fire; every particle; a quantity of the gas, with a colour bar; the number of neighbours; the hard round sprites of the paper; or sprites with a texture. In the classic model, fuel is the remaining life of a particle, and soot is its smoke. Default "fire". */
  'display-mode'?: "fire" | "particles" | "temperature" | "density" | "pressure" | "velocity" | "vorticity" | "distance" | "fuel" | "soot" | "neighbours" | "paper" | "sprites" | null | undefined;
  /** Fire and smoke, the fire alone, or the smoke alone. The visible layers. Default "both". */
  layers?: "both" | "fire" | "smoke" | null | undefined;
  /** A deeper fire with more tongues. Number of slices: moments of the fire's past that are drawn behind the present one. Low quality shows three. Default in combustion: 5, from 1 to 5. */
  depth?: number | `${number}` | null | undefined;
  /** A bright rim around a darker middle, as of a candle. Share of the light that is seen through a flame that is round about its axis; 0 is a plane flame. Default in combustion: 0, from 0 to 1. */
  roundness?: number | `${number}` | null | undefined;
  /** Finer tongues and wisps. Strength of the fine structure that moves with the gas. Default 1, from 0 to 2. */
  detail?: number | `${number}` | null | undefined;
  /** More contrast between bright and dim parts of the fire. Exponent that compresses the brightness of a black body. Default in combustion: 0.6, from 0.15 to 1. Default in classic: 0.35, from 0.15 to 1. */
  'luminance-exponent'?: number | `${number}` | null | undefined;
  /** Larger, softer particles. Drawn size of a particle. [m] Default in classic: 0.04, from 0.0025 to 0.1. */
  'particle-size'?: number | `${number}` | null | undefined;
  /** Colour of the coolest fire in the custom palette; transparent is black. Default "#8a12ff". */
  'cool-colour'?: string | null | undefined;
  /** Colour of the hottest fire in the custom palette; transparent is black. Default "#38e8ff". */
  'hot-colour'?: string | null | undefined;
  /** Colour behind the fire; with `transparent` the page shows through. Default "transparent". */
  background?: string | null | undefined;
  /** A backdrop that shimmers behind the flame. How strongly hot gas refracts the view of the backdrop. The page behind the element is not refracted. Default 0.3, from 0 to 1. */
  'heat-haze'?: number | `${number}` | null | undefined;
  /** Larger, slower swings of the flame. Size of the eddies of the turbulence. [m] Default 0.15, from 0.03 to 0.6. */
  'turbulence-scale'?: number | `${number}` | null | undefined;
  /** More curls at the edges of the flame. How strongly small eddies keep the rotation that the computation would dissipate. Default in combustion: 0, from 0 to 1. */
  'vorticity-confinement'?: number | `${number}` | null | undefined;
  /** A flame that rises faster. Classic: buoyancy β of gas that is thinner than the air; more of it narrows the fire. Combustion: buoyancy of hot gas; 1 is the physical value. Default in combustion: 1, from 0 to 2. Default in classic: 0.12, from 0 to 1. */
  buoyancy?: number | `${number}` | null | undefined;
  /** A flame whose hot parts rise faster. Buoyancy of gas that is hotter than the air. Default in classic: 0.2, from 0 to 1. */
  'thermal-buoyancy'?: number | `${number}` | null | undefined;
  /** A taller, quicker flame. Speed at which buoyancy and the drag of the air balance. [m/s] Default in classic: 2.5, from 0.5 to 3. */
  'terminal-speed'?: number | `${number}` | null | undefined;
  /** A lazier flame. Additional downward acceleration of every particle. [m/s²] Default in classic: 0, from 0 to 20. */
  'extra-weight'?: number | `${number}` | null | undefined;
  /** A flame that rises faster and flickers more. Gravitational acceleration in the buoyancy; 0 is a fire in free fall. [m/s²] Default 9.81, from 0 to 20. */
  gravity?: number | `${number}` | null | undefined;
  /** A fire that rises a little more slowly. Temperature of the air around the fire. [K] Default 293, from 250 to 350. */
  'ambient-temperature'?: number | `${number}` | null | undefined;
  /** Classic: a fire that rises a little faster. Combustion: a smaller fire, because it heats more air. Density of the air around the fire. [kg/m³] Default 1.2, from 0.5 to 2. */
  'ambient-density'?: number | `${number}` | null | undefined;
  /** Larger sparks. Size of an ember. [m] Default in combustion: 0.004, from 0.001 to 0.02. */
  'ember-size'?: number | `${number}` | null | undefined;
  /** Sparks that all fly far. Shortest life of an ember. [s] Default in combustion: 0.5, from 0.1 to 5. */
  'ember-life-min'?: number | `${number}` | null | undefined;
  /** Sparks of which some fly far. Longest life of an ember, at least the shortest life. [s] Default in combustion: 2, from 0.1 to 5. */
  'ember-life-max'?: number | `${number}` | null | undefined;
  /** Smoke that reaches higher. Time in which smoke, which is cold soot, decays to about a third. [s] Default in combustion: 1.5, from 0.1 to 10. */
  'smoke-life'?: number | `${number}` | null | undefined;
  /** More space beside the fire, in a wider view. Width of the domain, which the picture fits. Open edges: gas is simulated beyond it, too. [m] Default 1.2, from 0.1 to 6. */
  'domain-width'?: number | `${number}` | null | undefined;
  /** More space above the fire, in a wider view. Height of the domain, which the picture fits. Open edges: gas is simulated beyond it, too. [m] Default in combustion: 1.8, from 0.1 to 6. Default in classic: 1.5, from 0.1 to 6. */
  'domain-height'?: number | `${number}` | null | undefined;
  /** Open sides, walls, or periodic sides. Particles at the left and the right edge leave, are stopped, or enter on the other side. The floor stops them, unless the sides are open; the top is always open. Default in classic: "open". */
  walls?: "open" | "solid" | "periodic" | null | undefined;
  /** A fire in the open, or in a closed box. Open: air surrounds the fire, smoke leaves, and fresh air enters. Periodic: gas that leaves on one side of the domain enters on the other. Default in combustion: "open". */
  edges?: "open" | "periodic" | null | undefined;
  /** A fire that stands on a floor, or one that draws air from below. A solid floor is at the lower edge of the domain. Default in combustion: "none". */
  floor?: "none" | "solid" | null | undefined;
  /** A fire that fades at the top and the bottom of the picture. Share of the height, at either end, in which gas becomes fresh air again. With 0 the domain is periodic without fresh air, and has neither wind nor buoyancy, because nothing would stop the gas. Default in combustion: 0.07, from 0 to 0.2. */
  seam?: number | `${number}` | null | undefined;
  /** Another variation of the same fire. Seed of the random generator: the same seed gives the same fire. Default 1. */
  seed?: number | `${number}` | 'auto' | null | undefined;
  /** The same fire at lower cost and accuracy. Length of one step, which is divided further for stability. [s] Default in classic: 0.004166667, from 0.002 to 0.017. */
  'time-step'?: number | `${number}` | null | undefined;
  /** A coarser fire that takes less work. Distance of neighbouring particles in air. Until it is set, it follows the domain, the number of particles and the quality. [m] Default in combustion: 0.0268, from 0.0003 to 0.5. */
  spacing?: number | `${number}` | null | undefined;
  /** A finer fire that takes more work. Number of particles that would fill the domain. Until it is set, it follows the scene, the `spacing` and the quality. Default in combustion: 3000, from 200 to 100000. */
  particles?: number | `${number}` | null | undefined;
  /** A fire that may grow larger. Largest number of particles, with open edges or in the classic model. The highest air sleeps beyond it; until it is set, there is room for twice the domain. Default in combustion: 6000, from 200 to 100000. Default in classic: 1000, from 100 to 100000. */
  'max-particles'?: number | `${number}` | null | undefined;
  /** A smoother, wider fire that takes more work. Smoothing length h: particles interact up to twice this distance. [m] Default in classic: 0.026, from 0.005 to 0.1. */
  'smoothing-radius'?: number | `${number}` | null | undefined;
  /** A smoother fire that takes more work. Smoothing length h in spacings of the particles, which interact up to twice this distance. Default in combustion: 1.5, from 1.3 to 2. */
  'smoothing-ratio'?: number | `${number}` | null | undefined;
  /** A wider, coarser fire. Mass of one particle per metre of depth. [kg/m] Default in classic: 0.00025, from 0.0001 to 0.002. */
  'particle-mass'?: number | `${number}` | null | undefined;
  /** A narrower fire. Density at which the gas has no pressure. [kg/m³] Default in classic: 1, from 0.5 to 2. */
  'rest-density'?: number | `${number}` | null | undefined;
  /** A wider fire. Gas constant k of p = k (ρ − ρ₀), the square of the speed of sound: how strongly compressed gas expands. [m²/s²] Default in classic: 0.6, from 0.05 to 6. */
  'gas-constant'?: number | `${number}` | null | undefined;
  /** A more even fire that takes more work. Speed of sound in the simulated gas, far below the real one. A higher speed gives a more uniform density and shorter steps. It increases automatically for fires above 220 kW/m. [m/s] Default in combustion: 6, from 4 to 15. */
  stiffness?: number | `${number}` | null | undefined;
  /** A calmer flame. Dynamic viscosity. [Pa·s] Default in classic: 0.005, from 0 to 0.1. */
  viscosity?: number | `${number}` | null | undefined;
  /** A calmer, smoother flame. Kinematic viscosity: viscosity divided by density. [m²/s] Default in combustion: 0.0001, from 0 to 0.01. */
  'kinematic-viscosity'?: number | `${number}` | null | undefined;
  /** A calmer flame with fewer small curls. Viscosity between approaching particles only, which damps the noise of the particles. Default in combustion: 0.1, from 0.02 to 0.5. */
  'artificial-viscosity'?: number | `${number}` | null | undefined;
  /** A softer flame without small curls. How strongly unresolved eddies mix momentum, heat and gases: Smagorinsky's constant. Default in combustion: 0.2, from 0 to 0.4. */
  'eddy-viscosity'?: number | `${number}` | null | undefined;
  /** A compact flame that no hot rolls leave. Size C of the eddies into which rolls break up, in the length D* of the fire: how strongly rolls mix momentum, heat and gases. Default in combustion: 0.085, from 0 to 0.2. */
  'roll-mixing'?: number | `${number}` | null | undefined;
  /** A softer, blurred flame. Diffusivity of heat, fuel, oxygen and soot. [m²/s] Default in combustion: 0.0001, from 0 to 0.01. */
  diffusion?: number | `${number}` | null | undefined;
  /** A wider, fuller flame. Exponent of the thermal expansion: 1 is the ideal gas, 0 the paper's equation of state, in which pressure depends on density only. Default in combustion: 0.5, from 0 to 1. */
  'gas-expansion'?: number | `${number}` | null | undefined;
  /** A picture without gaps and clumps. How strongly particles are shifted from dense to sparse regions, so that they stay evenly distributed. Default in combustion: 1, from 0.2 to 1. */
  shifting?: number | `${number}` | null | undefined;
  /** Faster particles, which only an extreme fire needs. Largest speed of a particle. [m/s] Default in classic: 5, from 4 to 8. */
  'speed-limit'?: number | `${number}` | null | undefined;
  /** The paper's fire, with equation 1 as printed: the kernel with the factor of three dimensions. Default in classic: false. */
  'printed-kernel'?: boolean | null | undefined;
  /** The paper's fire, with equation 3 as printed: half the pressure force, not divided by the particle's own density. Default in classic: false. */
  'printed-pressure'?: boolean | null | undefined;
  /** The paper's fire, with equation 4 as printed: viscosity by the kernel's own Laplacian, which changes sign. Default in classic: false. */
  'printed-viscosity'?: boolean | null | undefined;
  /** The paper's fire, with equations 5 and 7 as printed: force densities divided by the mass instead of the density, and no thermal buoyancy. Default in classic: false. */
  'printed-divisor'?: boolean | null | undefined;
  /** The paper's fire, with equation 6 as printed: forward Euler, the position moves with the old velocity. Default in classic: false. */
  'printed-euler'?: boolean | null | undefined;
}

/** The events of `<hearth-fire>`. */
export interface HearthFireListeners {
  /** The fire is shown or, out of sight, can be drawn. */
  onready?: ((event: CustomEvent<null>) => void) | null | undefined;
  /** The fire plays again. */
  onplay?: ((event: CustomEvent<null>) => void) | null | undefined;
  /** The fire is paused. */
  onpause?: ((event: CustomEvent<null>) => void) | null | undefined;
  /** A parameter has changed, from any source. */
  'onparams-change'?: ((event: CustomEvent<HearthChangeDetail>) => void) | null | undefined;
  /** An object was added, changed or removed. */
  'onobjects-change'?: ((event: CustomEvent<HearthObjectsDetail>) => void) | null | undefined;
  /** A step was made, undone or redone. */
  'onhistory-change'?: ((event: CustomEvent<HearthHistoryDetail>) => void) | null | undefined;
  /** The quality has changed, to fit the speed of the device or on request. */
  'onquality-change'?: ((event: CustomEvent<HearthQualityDetail>) => void) | null | undefined;
  /** The sound plays, waits for a gesture of the visitor, or has ended. */
  'onsound-change'?: ((event: CustomEvent<HearthSoundDetail>) => void) | null | undefined;
  /** Measurements of the fire, about four times a second. */
  onstats?: ((event: CustomEvent<HearthStats>) => void) | null | undefined;
  /** A value is refused, a file could not be loaded, the fire has stopped, or the browser cannot show it. */
  onerror?: ((event: CustomEvent<HearthErrorDetail>) => void) | null | undefined;
  /** The fire is back after its graphics context was lost or its engine has stopped. */
  onrestored?: ((event: CustomEvent<null>) => void) | null | undefined;
}

/** The attributes of `<hearth-source>`; one that is taken away is back at its default. */
export interface HearthSourceAttributes {
  /** The element of the page whose border box it has, as `#` and an id. */
  of?: `#${string}` | null | undefined;
  /** An object that lists show under a name. Several objects may have the same. It is a line of at most 64 characters. Default "". */
  name?: string | null | undefined;
  /** A source that burns. One that is off emits nothing and keeps its values. So does one on a solid that is off. Default true. */
  enabled?: boolean | null | undefined;
  /** A fire on a line, or on the surface of a solid. Line: the source is straight. Solid: the whole outline of a solid burns, wherever the solid is. Default "line". */
  shape?: "line" | "solid" | null | undefined;
  /** A fire on another solid. Id of the solid whose surface is the source. If no solid has it, the source is a line. Default 0, from 0 to 1000000. */
  solid?: number | `#${string}` | `${number}` | null | undefined;
  /** A fire farther to the right, or below 0 to the left. Position of the middle of the source, which stays inside the domain. [m] Default 0, from -3 to 3. */
  x?: number | `${number}` | null | undefined;
  /** A flame that starts higher above the floor. Height of the source. In the combustion model it stays above the seam. [m] Default in combustion: 0.25, from 0 to 6. Default in classic: 0, from 0 to 6. */
  y?: number | `${number}` | null | undefined;
  /** A flame that leaves its source to the side. Angle of the width of the source from the horizontal, counterclockwise; what it emits leaves it at right angles. [°] Default 0, from -180 to 180. */
  angle?: number | `${number}` | null | undefined;
  /** A wider fire. Width of the source. In the combustion model it is at least four particles. [m] Default in combustion: 0.4, from 0.01 to 1. Default in classic: 0.36, from 0.05 to 0.6. */
  width?: number | `${number}` | null | undefined;
  /** A taller, brighter flame. Power of the burner per metre of depth: the heat of combustion of its fuel, without the heat of its hot gas. 0 turns it off. [kW/m] Default in combustion: 220, from 0 to 600. */
  power?: number | `${number}` | null | undefined;
  /** A denser, brighter flame. Particles born per second, limited by the space at the source and by the number of particles. [1/s] Default in classic: 1500, from 50 to 100000. */
  rate?: number | `${number}` | null | undefined;
  /** A flame that shoots up from its source. Speed of a particle at birth, or of the gas in the burner; upward unless the source is turned. A particle leaves a solid at right angles. In the combustion model, a solid has none: it supplies no gas. [m/s] Default in combustion: 0.25, from 0 to 1.5. Default in classic: 1, from 0 to 3. */
  speed?: number | `${number}` | null | undefined;
  /** A frayed flame that sprays to the sides. Random part of the velocity at birth. Default in classic: 0.25, from 0 to 1. */
  spread?: number | `${number}` | null | undefined;
  /** An uneven flame that flares up here and there. How unevenly the source burns: Perlin noise in place and time. Default in combustion: 0.2, from 0 to 1. Default in classic: 0.5, from 0 to 1. */
  noise?: number | `${number}` | null | undefined;
  /** A brighter root of the flame. Temperature of the gas in the burner, which is always above the ignition temperature. [K] Default in combustion: 700, from 500 to 1200. */
  temperature?: number | `${number}` | null | undefined;
  /** A flame that burns evenly down to its root; with 0 it is brightest at its rim. Oxygen in the fuel, relative to air. Default in combustion: 0.5, from 0 to 1. */
  oxygen?: number | `${number}` | null | undefined;
  /** A whiter flame. Temperature of a particle at birth. [K] Default in classic: 1900, from 1000 to 2500. */
  'birth-temperature'?: number | `${number}` | null | undefined;
  /** A fuller flame, up to its top. Shortest life of a particle. [s] Default in classic: 0.3, from 0.1 to 3. */
  'life-min'?: number | `${number}` | null | undefined;
  /** A taller flame. Longest life of a particle, at least the shortest life. [s] Default in classic: 1.2, from 0.1 to 3. */
  'life-max'?: number | `${number}` | null | undefined;
  /** A flame that ends in a point. How much shorter the lives of particles from the rim of the source are, within the shortest and the longest life. Default in classic: 0.8, from 0 to 1. */
  taper?: number | `${number}` | null | undefined;
}

/** The attributes of `<hearth-solid>`; one that is taken away is back at its default. */
export interface HearthSolidAttributes {
  /** The element of the page whose border box it has, or of an image what is opaque in it, as `#` and an id. */
  of?: `#${string}` | null | undefined;
  /** With `of`: it has the shape of the glyphs of that element. */
  'of-text'?: boolean | null | undefined;
  /** An object that lists show under a name. Several objects may have the same. It is a line of at most 64 characters. Default "". */
  name?: string | null | undefined;
  /** A solid that is there. One that is off neither acts nor is drawn, and keeps its values. Default true. */
  enabled?: boolean | null | undefined;
  /** A disc, a rectangle, a line, a polygon, a bent line or a picture. Shape of the solid. Default "circle". */
  shape?: "circle" | "box" | "line" | "polygon" | "stroke" | "mask" | null | undefined;
  /** A solid farther to the right, or below 0 to the left. Position of its centre. [m] Default 0, from -10 to 10. */
  x?: number | `${number}` | null | undefined;
  /** A solid that is higher. Height of its centre above the lower edge of the domain. [m] Default 0.5, from -10 to 10. */
  y?: number | `${number}` | null | undefined;
  /** A solid that is turned. Angle of its width from the horizontal, counterclockwise. [°] Default 0, from -360 to 360. */
  angle?: number | `${number}` | null | undefined;
  /** A larger solid. Diameter of a circle, width of a box or a mask, length of a line. [m] Default 0.2, from 0.002 to 10. */
  width?: number | `${number}` | null | undefined;
  /** A thicker solid. Height of a box or a mask, thickness of a line or a stroke. A stroke is at least as thick as an eightieth of its extent. [m] Default 0.1, from 0.002 to 10. */
  height?: number | `${number}` | null | undefined;
  /** A rounder box. Radius of its corners, at most half of its smaller side. [m] Default 0, from 0 to 5. */
  corner?: number | `${number}` | null | undefined;
  /** A solid of any outline. Corners of a polygon or of a stroke, as pairs of numbers in metres from the centre. A polygon is closed, and what its outline winds around is solid; a stroke is open and has round ends. [m] Default "-0.1,-0.1 0.1,-0.1 0,0.1". */
  points?: string | null | undefined;
  /** A solid in the shape of a picture. Opacity of the pixels of a mask, which `hearth-fire/mask` makes from a text, a path or an image. Default "16x16:7". */
  mask?: string | null | undefined;
  /** A surface of stone, wood, iron and so on. Material that is drawn; `none` is invisible. Default "stone". */
  material?: "stone" | "wood" | "iron" | "brick" | "coal" | "wax" | "glass" | "none" | null | undefined;
  /** A solid before the fire, which hides the flame behind it. Solids later in the list are before earlier ones. Default false. */
  front?: boolean | null | undefined;
  /** A surface that heats or cools the gas. Adiabatic: no heat passes. Fixed: it keeps its temperature. Conducting: the gas and radiation heat and cool the solid, which has one temperature throughout. Default "adiabatic". */
  thermal?: "adiabatic" | "fixed" | "conducting" | null | undefined;
  /** A hotter surface. Temperature of the surface, at first where it conducts heat. [K] Default 293, from 250 to 2500. */
  temperature?: number | `${number}` | null | undefined;
  /** A solid that heats and cools more slowly. Heat capacity by volume; that of stone and iron is 2000 to 3500. [kJ/(m³·K)] Default 100, from 10 to 5000. */
  'heat-capacity'?: number | `${number}` | null | undefined;
  /** A solid that burns where it is hot enough, until nothing is left. Each part has its own temperature; `thermal` has no effect. In the classic model it does not burn. Default "none". */
  fuel?: "none" | "wood" | "paper" | "coal" | "wax" | "cloth" | null | undefined;
  /** A fire that lasts longer and spreads more slowly. Dry mass of the fuel by area of the solid. [kg/m²] Default 2, from 0.05 to 200. */
  load?: number | `${number}` | null | undefined;
  /** A fuel that catches fire later. Mass of the water as a share of that of the dry fuel. [%] Default 8, from 0 to 100. */
  moisture?: number | `${number}` | null | undefined;
  /** A solid that moves by itself, and pushes the gas. Sway: to and fro along a line. Spin: around its place. Free: it starts at its place and falls, rests on other solids and is pushed by the gas. No part of it is faster than 3 m/s, but for a free solid that hits another or hangs. With a fuel it breaks where it has burnt through, while there are fewer than 64 solids. Default "still". */
  motion?: "still" | "sway" | "spin" | "free" | null | undefined;
  /** A solid that moves farther. Distance of its turning points from its place. [m] Default 0.3, from 0 to 5. */
  sway?: number | `${number}` | null | undefined;
  /** A motion along another line. Angle from the horizontal at which it starts, counterclockwise. [°] Default 0, from -360 to 360. */
  heading?: number | `${number}` | null | undefined;
  /** A slower motion. Time of one motion to and fro. [s] Default 4, from 0.5 to 60. */
  period?: number | `${number}` | null | undefined;
  /** A solid that turns faster counterclockwise or, below 0, clockwise. [°/s] Default 45, from -720 to 720. */
  spin?: number | `${number}` | null | undefined;
  /** A heavier solid. Its mass follows from its area; burnt material has no mass. That of wood is about 500. None is lighter than the gas beside it. [kg/m³] Default 500, from 0.1 to 10000. */
  density?: number | `${number}` | null | undefined;
  /** A solid that hangs. Id of the solid from which it hangs, by the highest of the middles of its sides. Where either burns through, it lets go. If no other solid has the id, it falls. Default 0, from 0 to 1000000. */
  'hangs-from'?: number | `${number}` | null | undefined;
  /** A rougher solid. Tangent of the angle at which it begins to slide on a fixed solid. Default 0.5, from 0 to 2. */
  friction?: number | `${number}` | null | undefined;
  /** A solid that bounces higher. Share of the speed of an impact with which it leaves. Default 0.1, from 0 to 1. */
  restitution?: number | `${number}` | null | undefined;
}
