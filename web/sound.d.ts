/**
 * The types of `hearth-fire/sound`: the sound of a fire, computed from the series of its steps. The same series, seed
 * and calls give the same samples.
 */

/** Numbers of a step in a series. */
export const STEP_NUMBERS: number;

/** How loud each part of the sound is. At 1, the balance of roar, crackle and hiss is that of recorded fires. */
export interface SoundMix {
  /** Volume from 0 to 1; 1 without it. */
  volume?: number;
  /** How loud it roars, from 0 to 2; 1 without it. */
  roar?: number;
  /** How loud it crackles, from 0 to 2; 1 without it. */
  crackle?: number;
  /** How loud it hisses, from 0 to 2; 1 without it. */
  hiss?: number;
}

/** What a sound starts with. */
export interface SynthesisOptions extends SoundMix {
  /** Sample rate from 8,000 to 768,000 [Hz]; 48,000 without it. */
  rate?: number;
  /** Seed of the noise and the cracks, a whole number from 0 to 4294967295; 1 without it. */
  seed?: number;
  /** Distance of the edges of the picture from its middle [m], from which places are panned, from 0.001 to 1000; 1 without it. */
  halfWidth?: number;
}

/** The sound of one fire. */
export interface Synthesis {
  /** Seconds of the clock for which there are samples. */
  readonly ahead: number;
  /** Fades to another mix; what it does not have stays. */
  mix(mix: SoundMix): void;
  /** Takes the next steps of a series; `speed` is the seconds of fire in a second of the clock, from 0.01 to 100, 1 without it. */
  push(series: ArrayLike<number>, speed?: number): void;
  /** Drops the oldest steps beyond so many seconds of the clock. */
  trim(seconds: number): void;
  /** Fills both channels, of the same length. Where the series ends, the sound fades. */
  render(left: Float32Array, right: Float32Array): void;
}

/** Makes the sound of a fire, in the wasm of the simulations. Rejects with a `RangeError` for values out of range. */
export function createSynthesis(options?: SynthesisOptions): Promise<Synthesis>;
