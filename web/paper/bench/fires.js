/**
 * The fires whose pictures and memory are measured: 600 × 600 pixels at medium quality.
 *
 * @typedef {import('./rows.js').Model} Model
 * @typedef {import('../../hearth-fire.js').HearthFire} HearthFire
 */

/** Side of a picture [px]. */
export const SIDE = 600;

/** A source finds room for so many particles in the usual domain, and for so many in the largest. */
const USUAL = 10_000;
const LARGEST = 30_000;

/** The distance of sources beside each other [m]. */
const APART = 1.2;

/** Steps between two looks at the number of particles. */
const FILL_STEPS = 48;
/** The share of the particles at which a fire is full: some die in each step, and others are born in the next. */
const FULL = 0.985;
/** Looks without growth after which a fire is full: a busy browser answers some before it has new statistics. */
const LOOKS_WITHOUT_GROWTH = 4;

/** Statistics, of four a second, that are passed over, and those whose median is the result. */
const WARM_STATS = 4;
const STATS = 8;

/**
 * Values of a classic fire with exactly so many particles in each step: births and lives are more than enough,
 * so that the largest number limits it.
 * @param {number} count
 */
function classicValues(count) {
  const wide = count > USUAL;
  return {
    'emission-rate': 100_000,
    'emission-speed': 3,
    'emission-noise': 0,
    'source-width': 0.6,
    // Of one length, lives would end in waves.
    'lifetime-min': wide ? 1 : 0.4,
    'lifetime-max': wide ? 3 : 1.2,
    taper: 0,
    'particle-mass': 0.0001,
    'rest-density': 2,
    'smoothing-radius': 0.012,
    ...(wide && { 'domain-width': 4, 'domain-height': 6 }),
  };
}

/**
 * Adds a paused fire with so many particles to `parent`.
 * @param {Element} parent
 * @param {Model} model
 * @param {number} count
 * @returns {HearthFire}
 */
export function addFire(parent, model, count) {
  const fire = document.createElement('hearth-fire');
  const values = {
    model,
    // A closed domain holds exactly so many.
    edges: 'periodic',
    [model === 'classic' ? 'max-particles' : 'particles']: count,
    'max-pixels': SIDE * SIDE,
    quality: 'medium',
    loading: 'eager',
    'reduced-motion': 'ignore',
    paused: '',
    alt: `A fire of ${count} particles`,
    ...(model === 'classic' ? classicValues(count) : {}),
  };
  for (const [name, value] of Object.entries(values)) fire.setAttribute(name, String(value));
  parent.append(fire);
  return /** @type {HearthFire} */ (fire);
}

/**
 * Steps a paused fire until its sources have filled it; two more than usual fill a very large one.
 * @param {HearthFire} fire
 * @param {number} count
 * @param {() => Promise<void>} pause
 */
export async function fill(fire, count, pause) {
  await fire.ready;
  if (fire.params.model === 'classic' && count > LARGEST) {
    const { x: _x, id: _id, ...first } = fire.objects[0];
    for (const x of [-APART, APART]) await fire.addObject({ ...first, x });
  }
  for (let most = 0, still = 0; most < FULL * count && still < LOOKS_WITHOUT_GROWTH; ) {
    await pause();
    await fire.step(FILL_STEPS);
    const alive = fire.stats?.particles ?? 0;
    still = alive > most ? 0 : still + 1;
    most = Math.max(most, alive);
  }
}

/**
 * Medians of the statistics of a playing fire.
 * @param {Element} parent
 * @param {Model} model
 * @param {number} count
 * @param {() => Promise<void>} pause
 * @param {AbortSignal} signal
 */
export async function pictures(parent, model, count, pause, signal) {
  const fire = addFire(parent, model, count);
  try {
    await fill(fire, count, pause);
    fire.play();
    /** @type {import('../../hearth-fire.js').HearthStats[]} */
    const all = [];
    while (all.length < WARM_STATS + STATS) all.push(await nextStats(fire, signal));
    const median = (/** @type {(stats: import('../../hearth-fire.js').HearthStats) => number} */ of) =>
      all
        .slice(WARM_STATS)
        .map(of)
        .sort((a, b) => a - b)[STATS >> 1];
    return {
      alive: median(({ particles }) => particles),
      pictureMs: median(({ drawMs }) => drawMs),
      uploadMs: median(({ stages }) => stages.upload),
      fps: median(({ fps }) => fps),
    };
  } finally {
    fire.remove();
  }
}

/** @param {HearthFire} fire @param {AbortSignal} signal @returns {Promise<import('../../hearth-fire.js').HearthStats>} */
function nextStats(fire, signal) {
  return new Promise((resolve, reject) => {
    signal.throwIfAborted();
    const cancel = () => reject(signal.reason);
    signal.addEventListener('abort', cancel, { once: true });
    fire.addEventListener(
      'stats',
      ({ detail }) => {
        signal.removeEventListener('abort', cancel);
        resolve(detail);
      },
      { once: true },
    );
  });
}
