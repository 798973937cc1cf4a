/** Fires of exactly so many particles, one at a time, with their pictures a second. */

import { addFire, fill } from '../bench/fires.js';
import { make, shown } from './cells.js';

/** @typedef {import('../../hearth-fire.js').HearthStats} HearthStats */

/** The numbers of particles: the paper's, and twenty times as many. */
const COUNTS = [5000, 100_000];
const [LEAST, MOST] = [200, 100_000];

/** The numbers that an address names, as `?n=300,600`. @param {string} search */
export function countsOf(search) {
  const named = (new URLSearchParams(search).get('n') ?? '').split(',').map(Number);
  const counts = named.filter((count) => Number.isInteger(count) && count >= LEAST && count <= MOST);
  return counts.length > 0 ? counts : COUNTS;
}

/** The rows of statistics. @type {[string, string, (stats: HearthStats) => string][]} */
const NUMBERS = [
  ['fps', 'FPS', ({ fps }) => fps.toFixed(0)],
  ['particles', 'Particles', ({ particles }) => particles.toLocaleString('en')],
  ['step', 'Step', ({ stepMs }) => `${shown(stepMs)} ms`],
  ['speed', 'Speed', ({ timeScale }) => `${Math.round(100 * timeScale)} % of real time`],
];

/** What puts out the fire that burns. */
let putOut = () => {};

/** @param {HTMLElement} parent @param {number} count @param {(error: unknown) => void} warn */
function addCount(parent, count, warn) {
  const words = `${count.toLocaleString('en')} particles`;
  const button = make('button', { type: 'button' }, `Burn ${words}`);
  const stage = make('div', { className: 'stage' }, button);
  const status = make('p', {});
  status.setAttribute('role', 'status');
  const cells = NUMBERS.map(([name]) => {
    const cell = make('dd', {}, '–');
    cell.dataset.number = name;
    return cell;
  });
  const numbers = make('dl', {}, ...NUMBERS.map(([, term], at) => make('div', {}, make('dt', {}, term), cells[at])));
  const stop = make('button', { type: 'button', hidden: true }, 'Put out');
  parent.append(make('figure', {}, stage, make('figcaption', {}, make('p', {}, words), numbers, status, stop)));

  async function burn() {
    putOut();
    const controller = new AbortController();
    const { signal } = controller;
    button.remove();
    const fire = addFire(stage, 'classic', count);
    stop.hidden = false;
    putOut = () => {
      controller.abort();
      fire.remove();
      stage.append(button);
      stop.hidden = true;
      status.textContent = '';
      putOut = () => {};
    };
    stop.focus();
    try {
      await fill(fire, count, async () => {
        await new Promise((resolve) => setTimeout(resolve));
        signal.throwIfAborted();
        status.textContent = `Filling: ${(fire.stats?.particles ?? 0).toLocaleString('en')} particles …`;
      });
      signal.throwIfAborted();
      status.textContent = '';
      fire.addEventListener('stats', ({ detail }) => {
        for (const [at, [, , of]] of NUMBERS.entries()) cells[at].textContent = of(detail);
      });
      await fire.play();
    } catch (error) {
      if (signal.aborted) return;
      putOut();
      warn(error);
    }
  }

  button.addEventListener('click', burn);
  stop.addEventListener('click', () => {
    putOut();
    button.focus();
  });
}

/** @param {HTMLElement} parent @param {string} search @param {(error: unknown) => void} warn */
export function addCounts(parent, search, warn) {
  for (const count of countsOf(search)) addCount(parent, count, warn);
}
