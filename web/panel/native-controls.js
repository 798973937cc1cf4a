/**
 * Native controls with labels, one for each kind of value.
 */

import { element } from '../element/controls/icon-button.js';

/** The number of presses of an arrow key that cross a logarithmic range. */
const LOG_STEPS = 100;

/** The steps of a slider per key. @type {{[key: string]: number | undefined}} */
const STEPS = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 };

/**
 * @typedef {import('../parameters.js').HearthParameters[import('../parameters.js').ParameterId]} Value
 * @typedef {import('../parameters.js').ParameterDomain} Domain
 * @typedef {Pick<import('../editing/objects.js').Entry, 'label' | 'unit' | 'kind' | 'scale' | 'choices'>} Parameter
 * @typedef {(value: Value | undefined, domain: Domain) => void} Show shows a value in a control
 */

/** The number of controls so far, which makes their ids. */
let controls = 0;

/**
 * The labelled list of qualities.
 *
 * @param {HTMLElement} root
 * @param {(name: string) => void} set
 */
export function addQuality(root, set) {
  controls += 1;
  const id = `hearth-controls-${controls}`;
  const control = element('select', { id, 'data-action': 'quality' });
  list({ choices: ['auto', 'low', 'medium', 'high'] }, control, (name) => set(String(name)));
  root.append(element('div', { class: 'row' }, element('label', { for: id }, 'Quality'), control));
  return control;
}

/**
 * The labelled control of a parameter or a property.
 *
 * @param {Parameter} parameter
 * @param {(value: Value) => void} set
 */
export function makeControl(parameter, set) {
  controls += 1;
  const id = `hearth-controls-${controls}`;
  const described = { id, 'aria-describedby': `${id}-note` };
  const input = element('input', described);
  const select = element('select', described);
  const control = parameter.kind === 'choice' ? select : input;
  // The reason why the parameter has no effect at present.
  const note = element('small', { id: `${id}-note` });
  // The unit is part of a slider's value.
  const row = element('div', { class: 'row' }, element('label', { for: id }, parameter.label), control, note);
  return { row, control, note, show: bind() };

  /** Sets up the control for the kind of its parameter. @returns {Show} */
  function bind() {
    switch (parameter.kind) {
      case 'choice':
        return list(parameter, select, set);
      case 'flag':
        return box(input, set);
      case 'colour':
      case 'text':
      case 'seed':
        return field(parameter, input, set);
      default:
        return slider(parameter, input, set);
    }
  }
}

/**
 * The text of a condition: the label of a choice and some of its names.
 * @type {(chosen: [string, string[]], entries: {id: string, label: string}[]) => string}
 */
function phraseOf([id, names], entries) {
  const label = entries.find((entry) => entry.id === id)?.label ?? id;
  const [last, ...others] = [...names].reverse();
  const before = others.length > 0 ? `${others.reverse().join(', ')} or ` : '';
  return `${label.toLowerCase()} ${before}${last}`;
}

/**
 * Notes below a control which conditions leave its value without an effect.
 * @param {{row: HTMLElement, note: HTMLElement}} parts
 * @param {{when?: {[id: string]: string[]}, unless?: {[id: string]: string[]}}} conditions
 * @param {(condition: [string, string[]]) => boolean} isMet
 * @param {{id: string, label: string}[]} entries
 * @returns {string[]} the ids of the choices on which the value depends and that are not met
 */
export function noteConditions({ row, note }, { when = {}, unless = {} }, isMet, entries) {
  const unmet = Object.entries(when).filter((condition) => !isMet(condition));
  const excluded = Object.entries(unless);
  const isExcluded = excluded.length > 0 && excluded.every(isMet);
  const list = (/** @type {[string, string[]][]} */ all) =>
    all.map((condition) => phraseOf(condition, entries)).join(' and ');
  note.textContent = unmet.length > 0 ? `Only with ${list(unmet)}` : isExcluded ? `Not with ${list(excluded)}` : '';
  row.classList.toggle('idle', unmet.length > 0 || isExcluded);
  return unmet.map(([id]) => id);
}

/** @type {(parameter: Parameter, control: HTMLInputElement, set: (value: Value) => void) => Show} */
function slider(parameter, control, set) {
  let [min, max] = [0, 1];
  control.type = 'range';
  control.step = parameter.kind === 'integer' ? '1' : 'any';
  // Screen readers read the value from the slider.
  const output = document.createElement('span');
  output.className = 'value';
  output.setAttribute('aria-hidden', 'true');
  control.after(output);
  const showText = () => {
    const text = `${Number(Number(control.value).toPrecision(4))} ${parameter.unit}`.trim();
    output.textContent = text;
    control.setAttribute('aria-valuetext', text);
  };
  control.addEventListener('input', () => {
    showText();
    set(Number(control.value));
  });
  if (parameter.scale === 'log') {
    // Each press is an equal ratio, as on the panel. The browser's equal differences would skip the
    // lower half of the range.
    control.addEventListener('keydown', (event) => {
      const ratio = (max / min) ** (1 / LOG_STEPS);
      const up = STEPS[event.key];
      if (!up || event.ctrlKey || event.altKey || event.metaKey) return;
      event.preventDefault();
      const old = Number(control.value);
      let next = Number((old * ratio ** up).toPrecision(4));
      if (parameter.kind === 'integer') {
        next = Math.round(next) === old ? old + up : Math.round(next);
      }
      control.value = String(Math.min(max, Math.max(min, next)));
      control.dispatchEvent(new Event('input', { bubbles: true }));
    });
  }
  return (value, domain) => {
    ({ min = 0, max = 1 } = domain);
    control.min = String(min);
    control.max = String(max);
    if (value === undefined) return;
    control.value = String(value);
    showText();
  };
}

/** A choice by words, as on the panel. @param {string} name */
function choiceText(name) {
  const words = name === 'blackbody' ? 'black body' : name.replaceAll(/[-_]/g, ' ');
  return words[0].toUpperCase() + words.slice(1);
}

/** @type {(parameter: Pick<Parameter, 'choices'>, control: HTMLSelectElement, set: (value: Value) => void) => Show} */
export function list(parameter, control, set) {
  for (const name of parameter.choices ?? []) control.add(new Option(choiceText(name), name));
  control.addEventListener('change', () => set(control.value));
  return (value) => {
    if (value !== undefined) control.value = String(value);
  };
}

/** @type {(control: HTMLInputElement, set: (value: Value) => void) => Show} */
function box(control, set) {
  control.type = 'checkbox';
  control.addEventListener('change', () => set(control.checked));
  return (value) => {
    control.checked = Boolean(value);
  };
}

/** @type {(parameter: Parameter, control: HTMLInputElement, set: (value: Value) => void) => Show} */
function field(parameter, control, set) {
  control.type = parameter.kind === 'seed' ? 'number' : 'text';
  control.spellcheck = false;
  control.addEventListener('focus', () => control.select());
  control.addEventListener('change', () => {
    const seed = parameter.kind === 'seed' && control.value !== '';
    set(seed ? Number(control.value) : control.value);
  });
  return (value) => {
    if (value !== undefined) control.value = String(value);
  };
}
