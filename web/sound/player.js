/**
 * The sound of one element: takes the series of its fire, computes samples and schedules them. This code is loaded
 * with the first `sound` above 0.
 */

import { fade, mixer, warnOfSilence } from './mixer.js';
import { FADE_TIME, STEP_NUMBERS, Synthesis } from './synthesis.js';

/** Samples that wait, at most and usually [s]. */
const MAX_BUFFER = 0.12;
const LEAD = 0.07;
/** How much faster or slower the series is played at most, so that so many wait. */
const MAX_CORRECTION = 0.1;
/** Share of the last frame in the mean speed and the mean power. */
const NEWEST = 0.1;
/** Longest frame [s]. */
const LONGEST_FRAME = 0.1;
/** How long before the end of the samples a fire that gives none fades [s]. */
const MARGIN = 0.03;

/** The sound of one element. */
export class Player {
  #session;
  /** @type {ReturnType<typeof mixer> | undefined} */
  #mixer;
  /** @type {Synthesis | undefined} */
  #synthesis;
  /** When the samples that are scheduled end, by the clock of the context [s]. */
  #end = 0;
  /** Mean seconds of fire and of the clock in a frame. */
  #fireTime = 0;
  #clockTime = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #starves;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #leaves;
  /** Whether the engine posts the series. */
  #posts = false;
  /** Removes the button that waits for a gesture. @type {Promise<() => void> | undefined} */
  #button;
  /** The sound of this fire alone. @type {GainNode | null} */
  audio = null;
  /** What recorders get of it. @type {MediaStreamAudioDestinationNode | undefined} */
  #recorded;
  /** @type {'silent' | 'waiting' | 'playing'} */
  state = 'silent';
  /** Mean power times the volume, by which the loud fires are chosen. */
  strength = 0;
  /** Whether it is one of the loud fires. */
  sounds = true;
  changed = () => this.update();

  /** @param {import('../element/session/session.js').FireSession} session */
  constructor(session) {
    this.#session = session;
    for (const name of ['pause', 'play'])
      session.fire.addEventListener(name, () => this.audio && fade(this.audio, Number(name === 'play')));
    this.update();
  }

  /** The engine has a new fire, which does not post its series yet. */
  renew() {
    this.#posts = false;
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
      if (this.audio) fade(this.audio, 0);
      this.#leaves = setTimeout(() => this.#leave(), 1000 * (FADE_TIME + MARGIN));
    }
    if (this.audio && this.audio.context !== this.#mixer?.context) this.#cut();
    const plays = wanted && Boolean(this.#mixer?.runs);
    if (plays) this.#begin();
    this.#synthesis?.mix(fire.sound, fire.crackle);
    if (plays !== this.#posts) {
      this.#posts = plays;
      this.#session.send('series', plays);
    }
    this.#report(plays ? 'playing' : wanted && !this.#mixer?.refused ? 'waiting' : 'silent');
  }

  /** Connects it to the mix. */
  #begin() {
    const { context, input } = this.#mixer ?? {};
    if (!context || !input) return;
    if (!this.audio) {
      this.audio = new GainNode(context);
      this.audio.connect(input);
    }
    if (this.#posts) return;
    fade(this.audio, this.#session.fire.paused ? 0 : 1);
    const { seed, domain_width: width } = this.#session.fire.params;
    this.#synthesis = new Synthesis({ rate: context.sampleRate, seed, halfWidth: 0.5 * width });
    [this.#fireTime, this.#clockTime, this.#end] = [0, 0, 0];
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
    this.#synthesis = this.#recorded = undefined;
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
   * Takes the steps of a frame.
   * @param {number} seconds of the clock since the last frame
   * @param {Float32Array} series
   */
  receive(seconds, series) {
    const synthesis = this.#synthesis;
    if (!synthesis || !this.audio || !this.#mixer) return;
    let [fireTime, energy] = [0, 0];
    for (let at = 0; at < series.length; at += STEP_NUMBERS) {
      fireTime += series[at];
      energy += series[at] * (series[at + 1] + series[at + 10]);
    }
    this.#fireTime += (fireTime - this.#fireTime) * NEWEST;
    this.#clockTime += (Math.min(seconds, LONGEST_FRAME) - this.#clockTime) * NEWEST;
    const { fire } = this.#session;
    this.strength += ((energy / fireTime) * fire.sound ** 2 - this.strength) * NEWEST;
    const sounds = this.#mixer.hasRoomFor(this);
    if (sounds !== this.sounds) fade(this.audio, Number(sounds));
    this.sounds = sounds;
    if (!sounds) return;
    const waits = Math.max(this.#end - this.audio.context.currentTime, 0);
    const behind = Math.max(-1, Math.min((waits - LEAD) / LEAD, 1));
    const speed = this.#clockTime > 0 ? this.#fireTime / this.#clockTime : fire.get('time_scale');
    synthesis.push(series, speed * (1 + MAX_CORRECTION * behind));
    synthesis.trim(MAX_BUFFER - waits);
    this.#schedule(synthesis.ahead);
    clearTimeout(this.#starves);
    const left = this.#end - this.audio.context.currentTime - MARGIN;
    // A fire that gives no more steps fades.
    this.#starves = setTimeout(() => this.#schedule(FADE_TIME), 1000 * Math.max(left, 0));
  }

  /** Schedules samples after those that wait. @param {number} seconds */
  #schedule(seconds) {
    const { audio } = this;
    if (!audio) return;
    const { context } = audio;
    const frames = Math.floor(seconds * context.sampleRate);
    if (frames < 1) return;
    const buffer = new AudioBuffer({ length: frames, numberOfChannels: 2, sampleRate: context.sampleRate });
    this.#synthesis?.render(buffer.getChannelData(0), buffer.getChannelData(1));
    if (this.#end < context.currentTime) this.#end = context.currentTime + LEAD;
    const source = new AudioBufferSourceNode(context, { buffer });
    source.connect(audio);
    source.start(this.#end);
    this.#end += frames / context.sampleRate;
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
