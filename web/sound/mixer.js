/**
 * The mix of all fires of a page: one `AudioContext`, which is made in a gesture and freed with the last fire.
 */

/** Time of every fade [s]. */
export const FADE_TIME = 0.03;

/** Most fires that sound at a time: the strongest. */
const LOUD_FIRES = 4;
/** By how much a stronger fire must exceed one that sounds to take its place. */
const STAYS = 1.3;
/**
 * The limiter, which looks ahead [dB, s]: the cracks of a fire stay whole, and several fires stay below full scale. What the browser
 * adds to make up for it is taken off again.
 */
const LIMITER = { threshold: -3, knee: 0, ratio: 20, attack: 0.001, release: 0.15 };
const MAKE_UP = 10 ** ((0.6 * LIMITER.threshold * (1 - 1 / LIMITER.ratio)) / 20);

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
    this.input = new DynamicsCompressorNode(context, LIMITER);
    this.input.connect(new GainNode(context, { gain: MAKE_UP })).connect(context.destination);
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
