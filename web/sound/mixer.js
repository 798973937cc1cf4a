/**
 * The mix of all fires of a page: one `AudioContext`, which is made in a gesture and freed with the last fire.
 */

/** Time of every fade [s]. */
export const FADE_TIME = 0.03;

/** Most fires that sound at a time: the strongest. */
const LOUD_FIRES = 4;
/** By how much a stronger fire must exceed one that sounds to take its place. */
const STAYS = 1.3;
/** Up to here a sample stays as it is, so that a crack at full volume is whole; louder ones bend towards full scale. */
const LINEAR = 0.7;
/** The loudest sum of fires that is told apart, and samples of the curve for each unit of it. */
const LOUDEST = 4;
const RESOLUTION = 512;

/**
 * What the limiter makes of a sample: less than full scale.
 * @param {number} sample
 */
export function limited(sample) {
  const size = Math.abs(sample);
  const room = 0.99 - LINEAR;
  return size <= LINEAR ? sample : Math.sign(sample) * (LINEAR + room * Math.tanh((size - LINEAR) / room));
}

/** The curve of the limiter. */
const curve = () => {
  const half = LOUDEST * RESOLUTION;
  return Float32Array.from({ length: 2 * half + 1 }, (_, at) => limited((at - half) / RESOLUTION));
};

/** What a browser takes for a gesture that may start sound. */
const GESTURES = ['pointerup', 'keydown', 'click'];

/** @typedef {{strength: number, changed: () => void}} Member  A fire of the mix */

/** @type {Mixer | undefined} */
let present;

/** Whether this page has warned that its fires are silent. */
let warned = false;

/** Warns once that the fires of this page are silent. @param {string} why */
export function warnOfSilence(why) {
  if (!warned) console.warn(`<hearth-fire>: fires are silent: ${why}`);
  warned = true;
}

/** The mix of one page. */
class Mixer {
  /** @type {AudioContext | undefined} */
  context;
  /** What all fires sound into. @type {AudioNode | undefined} */
  input;
  /** Whether the browser has refused a context. */
  refused = false;
  /** @type {Set<Member>} */
  #members = new Set();
  #gestures = new AbortController();

  constructor() {
    const { signal } = this.#gestures;
    const resume = () => this.#resume();
    const again = () => this.context && this.#resume();
    for (const name of GESTURES) document.addEventListener(name, resume, { signal, capture: true, passive: true });
    // A call or another tab interrupts the context of a phone; it resumes with the page.
    document.addEventListener('visibilitychange', again, { signal });
  }

  /** Whether samples are heard. */
  get runs() {
    return this.context?.state === 'running';
  }

  /** @param {Member} member */
  add(member) {
    this.#members.add(member);
    if (navigator.userActivation?.hasBeenActive) this.#resume();
  }

  /** @param {Member} member */
  remove(member) {
    this.#members.delete(member);
    if (this.#members.size > 0) return;
    this.#gestures.abort();
    this.context?.close().catch(() => {});
    if (present === this) present = undefined;
  }

  /** Whether a fire is one of the strongest. @param {Member & {sounds: boolean}} member */
  hasRoomFor(member) {
    const stronger = [...this.#members].filter(
      (other) => other !== member && other.strength > member.strength * (member.sounds ? STAYS : 1 / STAYS),
    );
    return stronger.length < LOUD_FIRES;
  }

  /** Starts or resumes the context. A browser may refuse until the next gesture. */
  #resume() {
    if (document.hidden || this.runs) return;
    if (navigator.userActivation?.hasBeenActive === false) return;
    try {
      this.context ??= this.#start();
      this.refused = false;
    } catch (why) {
      // A page has too many contexts, for instance. The next gesture tries again.
      this.refused = true;
      warnOfSilence(/** @type {Error} */ (why).message);
      this.#tell();
    }
    this.context?.resume().catch(() => {});
  }

  #tell() {
    for (const member of this.#members) member.changed();
  }

  #start() {
    const { audioSession } = /** @type {{audioSession?: {type: string}}} */ (/** @type {unknown} */ (navigator));
    // A phone plays it beside other sounds, and its silent switch mutes it.
    if (audioSession) audioSession.type = 'ambient';
    const context = new AudioContext();
    // A compressor is no limiter: Firefox's makes a crack 0.4 times as loud.
    this.input = new GainNode(context, { gain: 1 / LOUDEST });
    this.input.connect(new WaveShaperNode(context, { curve: curve() })).connect(context.destination);
    context.addEventListener('statechange', () => {
      // The page or the browser has closed it: the next gesture makes another.
      if (context.state === 'closed') this.context = this.input = undefined;
      this.#tell();
    });
    return context;
  }
}

/** The mix of the page. */
export const mixer = () => (present ??= new Mixer());

/**
 * Fades a gain from its present value.
 * @param {GainNode} node
 * @param {number} to
 */
export function fade({ gain, context }, to) {
  const now = context.currentTime;
  const from = gain.value;
  gain.cancelScheduledValues(now);
  gain.setValueAtTime(from, now);
  gain.linearRampToValueAtTime(to, now + FADE_TIME);
}
