/**
 * The accessible controls: native controls for everything on the panel's canvas.
 *
 * A canvas has no content for a screen reader and no stops for the Tab key. Each parameter of the fire's
 * model therefore has a labelled native control here, and each button of the panel a button, in the
 * panel's groups. A control is visible only while it has the focus, and follows the fire. Its `data-rect`
 * is the position of its counterpart on the panel: `x y width height` in CSS pixels of the window, absent
 * while the panel does not show it. Tests click there with a real mouse.
 */

import { element } from '../element/controls/icon-button.js';
import { COPIES } from '../editing/exchange.js';
import { OBJECTS, mountAccessibleObjects } from './accessible-objects.js';
import { idDomain } from '../editing/objects.js';
import { addQuality, makeControl, noteConditions } from './native-controls.js';
import { PARAMETERS } from '../parameters.js';
import { STRENGTHS } from '../editing/random-values.js';

/** The parameter that decides which others exist. */
const MODEL = 'model';

/** The parameter that decides which others of the combustion model exist. */
const EDGES = 'edges';

/** How far the focused control may lie over the egui control: native sliders of browsers differ in height [points]. */
const OVERLAP = 2;

/** As on the panel, the model is in the group of the physics. */
const [[model], others] = [true, false].map((is) => PARAMETERS.filter(({ id }) => (id === MODEL) === is));
const PHYSICS = others.findIndex(({ group }) => group === 'Physics');
const ROWS = [...others.slice(0, PHYSICS), { ...model, group: 'Physics' }, ...others.slice(PHYSICS)];

/** The parameters that decide whether others have an effect. */
const CONDITIONS = new Set(PARAMETERS.flatMap(({ when, unless }) => Object.keys({ ...when, ...unless })));

/** The model of a fire without one. */
const DEFAULT_MODEL = /** @type {ModelName} */ (PARAMETERS.find(({ id }) => id === MODEL)?.default);

/**
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 * @typedef {import('../parameters.js').Parameter} Parameter
 * @typedef {import('../parameters.js').ParameterId} Id
 * @typedef {import('../parameters.js').ModelName} ModelName
 *
 * @typedef {object} AccessibleControls
 * @property {(rectangles: Record<string, number[]>, canvas: DOMRect, scale: number) => void} position
 *   notes where the panel shows its controls, by name
 * @property {(alone?: boolean, message?: HTMLElement) => void} show makes the controls visible in place of the panel,
 *   below a message
 * @property {() => void} destroy
 */

/**
 * @param {object} options
 * @param {HTMLElement} options.host
 * @param {HearthFire} options.fire  The source of the values.
 * @param {import('./controller.js').PanelController} options.controller  The receiver of the commands.
 * @param {(id: string) => void} options.reveal  Scrolls the panel to a parameter, or opens a group of buttons.
 * @returns {AccessibleControls}
 */
export function mountAccessibleControls({ host, fire, controller, reveal }) {
  const root = element('div', { class: 'hearth-controls', dir: 'ltr', role: 'group', 'aria-label': 'Fire controls' });
  const status = element('p', { role: 'status' });
  /** The native controls by the names of their counterparts on the panel. @type {Map<string, HTMLElement>} */
  const counterparts = new Map();
  /** @type {Map<string, () => void>} */
  const shows = new Map();
  /** @type {<I extends Id>(id: I) => import('../parameters.js').HearthParameters[I] | undefined} */
  const read = (id) => fire.params?.[id];
  /** The domain of a parameter in the current model; undefined if the model does not use it. */
  const domainOf = (/** @type {Parameter} */ parameter) => parameter.domains[read(MODEL) ?? DEFAULT_MODEL];

  const ignoreRefusal = (/** @type {unknown} */ answer) => {
    // The element's error event reports a refusal.
    Promise.resolve(answer).catch(() => {});
  };
  const announce = (/** @type {string} */ text) => {
    status.textContent = text;
  };

  /**
   * @param {string} action
   * @param {string} text
   * @param {() => unknown} press
   * @param {HTMLElement} [parent]
   */
  function addButton(action, text, press, parent = root) {
    const button = element('button', { type: 'button', 'data-action': action }, text);
    button.addEventListener('click', () => ignoreRefusal(press()));
    parent.append(button);
    counterparts.set(`action:${action}`, button);
    return button;
  }
  const limited = controller.only !== undefined;
  const shownParameters =
    controller.only?.flatMap((id) => PARAMETERS.filter((parameter) => parameter.id === id)) ?? ROWS;

  const pause = addButton('pause', 'Pause', () => (fire.paused ? fire.play() : fire.pause()));
  const step = addButton('step', 'One step', () => {
    if (!fire.paused) ignoreRefusal(fire.pause());
    return fire.step();
  });
  const reset = addButton('reset', 'Restart', () => fire.reset());
  const undo = addButton('undo', 'Undo', () => controller.undo());
  const redo = addButton('redo', 'Redo', () => controller.redo());
  const picture = addButton('picture', 'Save an image or a film', () => controller.picture());
  const fullscreen = addButton('fullscreen', 'Full screen', () => controller.fullscreen());
  const copies = COPIES.map(({ name, label }) =>
    addButton(`copy:${name}`, `Copy the ${label}`, () => controller.copy(name)),
  );
  const paste = addButton('paste', 'Paste settings', () => controller.paste());
  for (const button of [...copies, paste]) button.addEventListener('focus', () => reveal('share'));
  const help = addButton('help', 'Keyboard shortcuts', () => controller.help());
  // A low panel hides these buttons until it is expanded.
  for (const button of [step, reset, redo, picture, fullscreen, help]) {
    button.addEventListener('focus', () => reveal('tools'));
  }
  const scenes = addButton('scenes', 'Scenes', () => controller.scenes());
  scenes.setAttribute('aria-haspopup', 'dialog');
  const states = /** @type {const} */ (['A', 'B']).map((letter) =>
    addButton(`compare:${letter}`, `State ${letter}`, () => controller.compare(letter)),
  );
  const strengths = STRENGTHS.map((strength) =>
    addButton(`randomise:${strength}`, `Randomise: ${strength}`, () => controller.randomise(strength)),
  );
  const variants = [...states, ...strengths];
  for (const button of variants) button.addEventListener('focus', () => reveal('tools'));
  const resetAll = addButton('reset-all', 'Reset all to the scene', () => controller.restoreAll());
  if (!limited) resetAll.addEventListener('focus', () => reveal('tools'));

  const quality = addQuality(root, (name) => controller.quality(name));
  quality.addEventListener('focus', () => reveal('quality'));
  counterparts.set('quality', quality);
  if (limited) {
    for (const control of [
      step,
      picture,
      fullscreen,
      ...copies,
      paste,
      help,
      scenes,
      ...variants,
      quality.parentElement,
    ])
      control?.remove();
  }

  /** @type {HTMLFieldSetElement | undefined} */
  let group;
  /** @type {import('./accessible-objects.js').AccessibleObjects | undefined} */
  let objects;
  for (const parameter of shownParameters) {
    const id = parameter.id;
    if (!group || (!limited && group.name !== parameter.group)) {
      // As on the panel, the objects follow the first group.
      if (group && !limited && !objects)
        objects = mountAccessibleObjects({ root, fire, controller, reveal, addButton, counterparts });
      const name = limited ? 'Controls' : parameter.group;
      group = element('fieldset', { name }, element('legend', {}, name));
      root.append(group);
    }
    const parent = group;
    const { row, control, note, show } = makeControl(parameter, (value) => {
      ignoreRefusal(controller.set(id, value).finally(shows.get(id)));
    });
    control.dataset.parameter = id;
    control.title = parameter.doc;
    parent.append(row);
    counterparts.set(id, control);
    const restore = addButton(
      `restore:${id}`,
      `Reset ${parameter.label}`,
      () => {
        control.focus();
        return controller.restore(id);
      },
      parent,
    );
    shows.set(id, () => {
      const value = read(id);
      const domain = idDomain(fire, id, value, domainOf(parameter));
      const isMet = (/** @type {[string, string[]]} */ [of, names]) =>
        names.includes(String(read(/** @type {Id} */ (of))));
      const unmet = noteConditions({ row, note }, parameter, isMet, PARAMETERS);
      // As on the panel, each kind of edges has its own parameters.
      const isUsed = domain && !unmet.includes(EDGES);
      row.hidden = !isUsed;
      restore.hidden = !isUsed || value === controller.defaultOf(id);
      if (domain) show(value, domain);
    });
    control.addEventListener('focus', () => reveal(id));
    control.addEventListener('blur', () => reveal(''));
  }
  // As on the panel, the quality ends the first group.
  const first = root.querySelector('fieldset');
  if (first && !limited) first.append(/** @type {HTMLElement} */ (quality.parentElement));
  root.append(status);
  host.append(root);

  const showAll = () => {
    for (const show of shows.values()) show();
    objects?.show();
    for (const set of root.querySelectorAll('fieldset')) {
      set.hidden =
        set.name !== OBJECTS &&
        [...set.querySelectorAll('.row')].every((row) => /** @type {HTMLElement} */ (row).hidden);
    }
    showPlaying();
    showQuality();
  };
  const showQuality = () => {
    if (fire.quality !== undefined) quality.value = fire.quality;
  };
  const showPlaying = () => {
    pause.textContent = fire.paused ? 'Play' : 'Pause';
  };
  const changed = (/** @type {Event} */ event) => {
    const { id } = /** @type {CustomEvent<{id: Id}>} */ (event).detail ?? {};
    // Another model has other controls and other values. Some choices disable other parameters.
    if (id === MODEL || CONDITIONS.has(id)) showAll();
    else shows.get(id)?.();
  };
  const failed = (/** @type {Event} */ event) => announce(/** @type {CustomEvent} */ (event).detail?.message ?? '');
  const listeners = {
    ready: showAll,
    play: showPlaying,
    pause: showPlaying,
    'params-change': changed,
    'objects-change': () => objects?.show(),
    'quality-change': showQuality,
    error: failed,
    restored: () => announce(''),
  };
  for (const [name, listener] of Object.entries(listeners)) fire.addEventListener(name, listener);
  let message = '';
  let preset = controller.state.preset;
  const showState = () => {
    const state = controller.state;
    // Another scene has other values to reset to.
    if (state.preset !== preset) showAll();
    else objects?.show();
    preset = state.preset;
    // A disabled button would lose the focus.
    undo.setAttribute('aria-disabled', String(!state.undo));
    redo.setAttribute('aria-disabled', String(!state.redo));
    for (const button of states)
      button.setAttribute('aria-pressed', String(button.dataset.action === `compare:${state.compared}`));
    scenes.textContent = state.scene ? `Scene: ${state.scene}` : 'Scenes';
    fullscreen.hidden = !state.fullscreen;
    for (const [at, button] of copies.entries()) button.hidden = !state.copies.includes(COPIES[at]);
    if (state.message !== message) announce(state.message);
    message = state.message;
  };
  controller.addEventListener('change', showState);
  showState();
  showAll();

  return {
    position(rectangles, canvas, scale) {
      // The focused control covers the panel's lower edge.
      const focused = root.querySelector(':focus');
      const shown = focused?.closest('.row') ?? focused;
      const free = ((shown?.getBoundingClientRect().top ?? Infinity) - canvas.y) / scale;
      for (const [name, element] of counterparts) {
        const rectangle = rectangles[name];
        const text =
          rectangle && rectangle[1] + rectangle[3] <= free + OVERLAP
            ? [
                canvas.x + rectangle[0] * scale,
                canvas.y + rectangle[1] * scale,
                rectangle[2] * scale,
                rectangle[3] * scale,
              ]
                .map((x) => Math.round(x * 100) / 100)
                .join(' ')
            : undefined;
        if (text === undefined) delete element.dataset.rect;
        else if (element.dataset.rect !== text) element.dataset.rect = text;
      }
    },
    show(alone = true, message) {
      root.classList.toggle('alone', alone);
      if (message) root.prepend(message);
    },
    destroy() {
      for (const [name, listener] of Object.entries(listeners)) fire.removeEventListener(name, listener);
      controller.removeEventListener('change', showState);
      root.remove();
    },
  };
}
