/**
 * The sound of one element: schedules the samples that the engine makes of its fire. This code is loaded with the first
 * `sound` above 0.
 */

import { FADE_TIME, fade, mixer, warnOfSilence } from './mixer.js';

/**
 * Samples that wait at first [s]. Where they end before others come, as on a machine whose frames are long, more of
 * them wait from then on, so many times more and up to a limit [s]; more than the sum of it and the reserve never do.
 */
const LEAD = 0.07;
const LATER = 1.5;
const MAX_LEAD = 0.25;
const RESERVE = 0.12;
/** Share of the last frame in the mean loudness. */
const NEWEST = 0.1;
/** How long before the end of the samples a fire that gives none fades [s]. */
const MARGIN = 0.04;

/** The sound of one element. */
export class Player {
  #session;
  /** @type {ReturnType<typeof mixer> | undefined} */
  #mixer;
  /** When the samples that are scheduled end, by the clock of the context [s]. */
  #end = 0;
  #lead = LEAD;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #starves;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #leaves;
  /** Whether it fades because no samples come. */
  #fades = false;
  /** What the engine posts: the arguments of `sound`; empty without samples. */
  #posts = '';
  /** Removes the button that waits for a gesture. @type {Promise<() => void> | undefined} */
  #button;
  /** The sound of this fire alone. @type {GainNode | null} */
  audio = null;
  /** What recorders get of it. @type {MediaStreamAudioDestinationNode | undefined} */
  #recorded;
  /** @type {'silent' | 'waiting' | 'playing'} */
  state = 'silent';
  /** Mean square of what is heard, by which the loud fires are chosen. */
  strength = 0;
  /** Whether it is one of the loud fires. */
  sounds = true;
  changed = () => this.update();

  /** @param {import('../element/session/session.js').FireSession} session */
  constructor(session) {
    this.#session = session;
    for (const name of ['pause', 'play'])
      session.fire.addEventListener(name, () => this.#fade(Number(name === 'play')));
    this.update();
  }

  /** The engine has a new fire, which posts no samples yet. */
  renew() {
    this.#posts = '';
    this.update();
  }

  /** Follows the attributes, the visitor's choice and the context. */
  update() {
    const { fire, live, muted } = this.#session;
    const wanted = live && fire.sound > 0 && !fire.muted;
    if (live) addEventListener(muted, this.changed);
    else removeEventListener(muted, this.changed);
    if (wanted && !globalThis.AudioContext) {
      warnOfSilence('this browser has no Web Audio.');
      return;
    }
    clearTimeout(this.#leaves);
    if (wanted) {
      if (!this.#mixer) {
        this.#mixer = mixer();
        this.#mixer.add(this);
      }
    } else if (this.#mixer) {
      // What is scheduled fades first.
      this.#fade(0);
      this.#leaves = setTimeout(() => this.#leave(), 1000 * (FADE_TIME + MARGIN));
    }
    if (this.audio && this.audio.context !== this.#mixer?.context) this.#cut();
    const plays = wanted && Boolean(this.#mixer?.runs);
    if (plays) this.#begin();
    const { roar, crackle, hiss } = fire;
    const rate = this.audio?.context.sampleRate;
    const posts = plays ? [rate, roar, crackle, hiss].join() : '';
    if (posts !== this.#posts) {
      this.#posts = posts;
      this.#session.send('sound', plays ? rate : undefined, roar, crackle, hiss);
    }
    this.#report(plays ? 'playing' : wanted && !this.#mixer?.refused ? 'waiting' : 'silent');
  }

  /** Connects it to the mix, and fades to its volume. */
  #begin() {
    const { context, input } = this.#mixer ?? {};
    if (!context || !input) return;
    if (!this.audio) {
      this.audio = new GainNode(context, { gain: 0 });
      this.audio.connect(input);
    }
    this.#fade(Number(!this.#session.fire.paused && this.sounds));
  }

  /** Fades to a share of the volume. @param {number} share */
  #fade(share) {
    // Equal steps of the slider are about equally loud.
    if (this.audio) fade(this.audio, share * this.#session.fire.sound ** 2);
  }

  #leave() {
    this.#cut();
    this.#mixer?.remove(this);
    this.#mixer = undefined;
  }

  /** Takes it out of the mix, or out of one that is closed. */
  #cut() {
    clearTimeout(this.#starves);
    this.audio?.disconnect();
    this.audio = null;
    this.#recorded = undefined;
  }

  /** @param {'silent' | 'waiting' | 'playing'} state */
  #report(state) {
    if (state === this.state) return;
    this.state = state;
    const { reports, view } = this.#session;
    if (state === 'waiting') {
      const button = reports
        .loads(import('./speaker.js'), 'The speaker button')
        .then(({ waitingButton }) => waitingButton(view));
      button.catch(() => {});
      this.#button = button;
    } else {
      this.#button?.then((remove) => remove()).catch(() => {});
      this.#button = undefined;
    }
    reports.emit('sound-change', { state });
  }

  /**
   * Schedules the samples of a frame after those that wait.
   * @param {Float32Array<ArrayBuffer>} samples of the left channel, then of the right one
   */
  receive(samples) {
    const { audio } = this;
    const length = samples.length / 2;
    if (!this.#posts || !audio || !this.#mixer || length < 1) return;
    const { context } = audio;
    const square = samples.reduce((sum, sample) => sum + sample * sample, 0) / length;
    this.strength += (square * this.#session.fire.sound ** 4 - this.strength) * NEWEST;
    const sounds = this.#mixer.hasRoomFor(this);
    if (sounds !== this.sounds) this.#fade(Number(sounds));
    this.sounds = sounds;
    const starved = this.#end < context.currentTime;
    // The clocks of frames and of samples drift by a second in a day.
    if (!sounds || this.#end > context.currentTime + this.#lead + RESERVE) return;
    if (starved) {
      // After a pause, nothing was late.
      if (this.#end > context.currentTime - 1) this.#lead = Math.min(LATER * this.#lead, MAX_LEAD);
      this.#end = context.currentTime + this.#lead;
    }
    if (starved || this.#fades) this.#fade(1);
    this.#fades = false;
    const buffer = new AudioBuffer({ length, numberOfChannels: 2, sampleRate: context.sampleRate });
    buffer.copyToChannel(samples.subarray(0, length), 0);
    buffer.copyToChannel(samples.subarray(length), 1);
    const source = new AudioBufferSourceNode(context, { buffer });
    source.connect(audio);
    source.start(this.#end);
    this.#end += length / context.sampleRate;
    clearTimeout(this.#starves);
    // A fire that gives no more samples fades before they end.
    const left = this.#end - context.currentTime - MARGIN;
    this.#starves = setTimeout(() => {
      this.#fades = true;
      this.#fade(0);
    }, 1000 * left);
  }

  /** The sound as a track for a recorder; undefined while there is none. */
  track() {
    if (!this.audio) return undefined;
    if (!this.#recorded) {
      this.#recorded = new MediaStreamAudioDestinationNode(/** @type {AudioContext} */ (this.audio.context));
      this.audio.connect(this.#recorded);
    }
    // A recorder that stops its track leaves those of others.
    return this.#recorded.stream.getAudioTracks()[0].clone();
  }
}
