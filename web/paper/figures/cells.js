/** Fires beside each other, with their captions and their numbers. */

import { PARAMETERS } from '../../parameters.js';
import { valueIn } from './comparisons.js';
import { measure } from './measure.js';
import { POSITIONS, positionOf, valueAt } from './range.js';

/** @typedef {import('./comparisons.js').Cell} Cell */

/**
 * The numbers of a fire: term, unit, and units a metre where it is a length.
 * @type {[keyof import('./shape.js').Shape, string, string, number][]}
 */
const NUMBERS = [
  ['width', 'Width', ' m', 1],
  ['height', 'Height', ' m', 1],
  ['neighbours', 'Neighbours', '', 1],
  ['nearest', 'Nearest', ' mm', 1000],
];

/** Two significant digits, and no fraction from 100 on. @param {number} number */
export const shown = (number) => (number >= 100 ? number.toFixed(0) : number.toPrecision(2));

/**
 * @param {string} name
 * @param {{[property: string]: any}} [properties]
 * @param {(Node | string)[]} children
 * @returns {any}
 */
export function make(name, properties = {}, ...children) {
  const element = document.createElement(name);
  Object.assign(element, properties);
  element.append(...children);
  return element;
}

/** @param {string} id */
function parameterOf(id) {
  const parameter = /** @type {any} */ (PARAMETERS.find((entry) => entry.id === id));
  return { label: parameter.label, unit: parameter.unit && ` ${parameter.unit}`, log: parameter.scale === 'log' };
}

/** The measurement that runs, and the next ones. @type {Promise<unknown>} */
let last = Promise.resolve();

/**
 * Measures one fire after another, so that the page stays responsive.
 * @template T
 * @param {() => Promise<T>} act
 * @returns {Promise<T>}
 */
function afterOthers(act) {
  const result = last.then(act);
  last = result.catch(() => {});
  return result;
}

/** Lets the page draw. @param {AbortSignal} signal */
const pauseUnless = (signal) => async () => {
  await new Promise((resolve) => setTimeout(resolve));
  signal.throwIfAborted();
};

/**
 * Adds a fire to `parent`, and returns how to measure it.
 * @param {HTMLElement} parent
 * @param {Cell} cell
 * @param {(error: unknown) => void} warn
 * @returns {() => void}
 */
export function addCell(parent, cell, warn) {
  const values = { ...cell.values };
  const fire = document.createElement('hearth-fire');
  for (const [id, value] of Object.entries({ preset: cell.preset, loading: 'lazy', ...values })) {
    fire.setAttribute(id.replaceAll('_', '-'), String(value));
  }
  const cells = NUMBERS.map(() => make('dd', {}, '…'));
  const numbers = make(
    'dl',
    {},
    ...NUMBERS.map(([name, term], at) => {
      cells[at].dataset.number = name;
      return make('div', {}, make('dt', {}, term), cells[at]);
    }),
  );
  const caption = make('figcaption', {}, captionOf());
  if (cell.measured !== false) caption.append(numbers);
  parent.append(make('figure', {}, fire, caption));

  let controller = new AbortController();
  async function show() {
    controller.abort();
    controller = new AbortController();
    const { signal } = controller;
    for (const cell of cells) cell.textContent = '…';
    try {
      const shape = await afterOthers(async () => {
        signal.throwIfAborted();
        return measure(cell.preset, { ...values }, pauseUnless(signal));
      });
      for (const [at, [name, , unit, scale]] of NUMBERS.entries()) {
        cells[at].textContent = `${shown(scale * shape[name])}${unit}`;
      }
    } catch (error) {
      if (!signal.aborted) warn(error);
    }
  }

  /** The caption: words, a value, or a slider for it. */
  function captionOf() {
    const { parameter, words = '', from } = cell;
    if (!parameter) {
      fire.setAttribute('alt', `Fire: ${words}`);
      return make('p', {}, words);
    }
    const { label, unit, log } = parameterOf(parameter);
    const to = valueIn(cell.preset, parameter);
    const amount = () => `${values[parameter] ?? to}${unit}`;
    const describe = () => fire.setAttribute('alt', `Fire: ${label.toLowerCase()} ${amount()}${words && `, ${words}`}`);
    describe();
    if (from === undefined) return make('p', {}, `${label} ${amount()}${words && `, ${words}`}`);
    const value = make('span', {}, amount());
    const slider = make('input', {
      type: 'range',
      min: '0',
      max: String(POSITIONS),
      value: String(positionOf(values[parameter], from, to, log)),
    });
    slider.ariaValueText = amount();
    slider.addEventListener('input', () => {
      values[parameter] = valueAt(Number(slider.value), from, to, log);
      value.textContent = amount();
      slider.ariaValueText = amount();
      describe();
      fire.setAttribute(parameter.replaceAll('_', '-'), String(values[parameter]));
      show();
    });
    return make('label', {}, `${label} `, value, slider);
  }

  return () => {
    if (cell.measured !== false) show();
  };
}
