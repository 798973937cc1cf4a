/**
 * The loop of a fire as its statistics report it: the stages of a step, the upload, the passes of a picture, with
 * their times.
 */

import { make, shown } from './cells.js';

/** @typedef {import('../../hearth-fire.js').HearthStats} HearthStats */

/** The stage that is part of a picture. */
const UPLOAD = 'upload';

/** What happens in each stage and pass, by its name in the statistics, for the two models. */
export const TEXTS = {
  classic: {
    sort: 'Particles are born, and sorted into cells',
    density: 'Each finds its neighbours and its density (the paper’s step 1)',
    forces: 'Pressure and viscosity between neighbours (step 2)',
    integrate: 'Buoyancy and drag; new velocities and positions; cooling and death (steps 3 to 5)',
    upload: 'What the picture needs goes to the graphics card',
    paper: 'Discs, as the paper draws them (step 6)',
  },
  combustion: {
    sort: 'The gas is sorted into cells',
    density: 'Each particle finds its neighbours and its volume',
    forces: 'Pressure, viscosity, diffusion, buoyancy and turbulence',
    integrate: 'Fuel burns, soot glows and cools; velocities, positions, sources',
    upload: 'What the picture needs goes to the graphics card',
    slices: 'Particles become fields, which carry noise and shine as a black body, one moment behind another',
    ember: 'Sparks',
    bloom_downsample: 'The glow, blurred in ever wider copies',
    bloom_upsample: 'The copies of the glow, joined',
    smoke_light: 'The light on smoke, through the smoke between',
    tone_map: 'The tone map',
    composite: 'The picture, over the background',
  },
};

/** One row: its name, what it does, its time. @param {string} name @param {string} text */
function row(name, text) {
  const time = make('span', { className: 'time' });
  const item = make('li', {}, make('code', {}, name), ` ${text} `, time);
  item.dataset.name = name;
  return { item, time };
}

/**
 * Keeps a list up to date with a fire's statistics.
 * @param {HTMLElement} parent
 * @param {HTMLElement} fire
 * @param {keyof typeof TEXTS} model
 */
export function showLoop(parent, fire, model) {
  /** @type {{[name: string]: string}} */
  const texts = TEXTS[model];
  let names = '';
  /** @type {Map<string, ReturnType<typeof row>>} */
  let rows = new Map();
  const [step, picture, again] = ['Each step', 'Each picture', ''].map((text) => make('p', {}, text));

  /** @param {string[]} stages @param {string[]} passes */
  function build(stages, passes) {
    rows = new Map([...stages, ...passes].map((name) => [name, row(name, texts[name] ?? '')]));
    const list = (/** @type {string[]} */ of) => make('ol', {}, ...of.map((name) => rows.get(name)?.item ?? ''));
    const ofStep = stages.filter((name) => name !== UPLOAD);
    const ofPicture = [...stages.filter((name) => name === UPLOAD), ...passes];
    parent.replaceChildren(make('div', { className: 'steps' }, step, list(ofStep)), picture, list(ofPicture), again);
  }

  fire.addEventListener('stats', (/** @type {any} */ event) => {
    /** @type {HearthStats} */
    const { stages, passes, stepsPerFrame, fps, passTimer } = event.detail;
    const [ofStages, ofPasses] = [Object.keys(stages), Object.keys(passes)];
    const now = [...ofStages, '', ...ofPasses].join();
    if (now !== names) build(ofStages, ofPasses);
    names = now;
    const times = Object.entries({ ...stages, ...passes });
    const most = Math.max(...times.map(([, time]) => time), Number.MIN_VALUE);
    for (const [name, time] of times) {
      const row = rows.get(name);
      if (!row) continue;
      row.time.textContent = `${time < 0.01 ? '< 0.01' : shown(time)} ms`;
      row.item.style.setProperty('--share', String(time / most));
    }
    step.textContent = `Each step: ${shown(stepsPerFrame)} a picture`;
    picture.textContent = `Each picture: passes by their time ${passTimer === 'gpu' ? 'on the graphics card' : 'until they are submitted'}`;
    again.textContent = `And again: ${shown(fps)} pictures a second`;
  });
}
