/**
 * The speaker button, and the sliders of the sound. Sound starts with the visitor's press, never with a link alone.
 */

import { element, iconButton } from '../element/controls/icon-button.js';

/** A loudspeaker with waves. */
export const SPEAKER = 'M4 9h4l5-5v16l-5-5H4zM16 9a4 4 0 0 1 0 6M19 6a8 8 0 0 1 0 12';

/** The volume of a fire whose page sets none. */
const VOLUME = 0.8;

/** The sliders: the attribute, its name and its highest value. */
const SLIDERS = /** @type {const} */ ([
  ['sound', 'Volume', '1'],
  ['roar', 'Roar', '2'],
  ['crackle', 'Crackle', '2'],
  ['hiss', 'Hiss', '2'],
]);

/** @typedef {import('../hearth-fire.js').HearthFire} HearthFire */

/** Whether a fire is to be heard. @param {HearthFire} fire */
export const isOn = (fire) => fire.sound > 0 && !fire.muted;

/** Mutes a fire, or lets it be heard. @param {HearthFire} fire */
export function toggleSound(fire) {
  const on = isOn(fire);
  if (!on && !(fire.sound > 0)) fire.sound = VOLUME;
  fire.muted = on;
}

/**
 * Lets a button mute a fire.
 * @param {HTMLElement} button
 * @param {HearthFire} fire
 * @param {(on: boolean) => void} [shown]
 * @returns {() => void} ends it
 */
export function bindSpeaker(button, fire, shown = () => {}) {
  const ended = new AbortController();
  const { signal } = ended;
  const update = () => {
    const on = isOn(fire);
    button.setAttribute('aria-pressed', String(on));
    shown(on);
  };
  button.addEventListener('click', () => toggleSound(fire), { signal });
  fire.addEventListener('sound-change', update, { signal });
  const attributes = new MutationObserver(update);
  if (fire instanceof Node) attributes.observe(fire, { attributeFilter: SLIDERS.map(([name]) => name) });
  signal.addEventListener('abort', () => attributes.disconnect());
  update();
  return () => ended.abort();
}

/**
 * A speaker button with sliders beside it, which show while the fire is to be heard and the button or a slider is
 * used.
 * @param {HearthFire} fire
 * @param {string} className of the button
 * @returns {{parts: HTMLElement[], remove: () => void}}
 */
export function speakerControls(fire, className) {
  const button = iconButton(SPEAKER, { class: className, 'aria-label': 'Sound', title: 'Sound on or off (M)' });
  const sliders = element('div', { class: 'hearth-sound', role: 'group', 'aria-label': 'Sound', hidden: '' });
  const all = SLIDERS.map(([name, label, max]) => {
    const slider = element('input', { type: 'range', min: '0', max, step: '0.05', 'data-sound': name });
    slider.addEventListener('input', () => Object.assign(fire, { [name]: Number(slider.value) }));
    sliders.append(element('label', {}, label, slider));
    return { name, slider };
  });
  const end = bindSpeaker(button, fire, (on) => {
    sliders.hidden = !on;
    for (const { name, slider } of all) slider.value = String(fire[name]);
  });
  const parts = [button, sliders];
  return {
    parts,
    remove() {
      end();
      for (const part of parts) part.remove();
    },
  };
}

const STYLES = /* css */ `
.speaker {
  position: absolute; inset: auto 10px 8px auto; display: grid; place-items: center; inline-size: 44px; block-size: 44px; padding: 0;
  border: 2px solid; border-radius: 50%; background: rgb(0 0 0 / 0.6); color: #fff; cursor: pointer; pointer-events: auto;
}
.speaker:hover { background: rgb(0 0 0 / 0.8); }
.speaker:focus-visible { outline: 3px solid #ffb454; outline-offset: 3px; }
.speaker svg { inline-size: 22px; block-size: 22px; fill: none; stroke: currentcolor; stroke-width: 2; }
`;

/** The views that have the styles of the button. */
const STYLED = new WeakSet();

/**
 * The button of an element whose sound waits for a gesture. Any gesture starts it, and so does the press.
 * @param {import('../element/view/view.js').FireView} view
 * @returns {() => void} removes it
 */
export function waitingButton(view) {
  if (!STYLED.has(view)) view.style(STYLES);
  STYLED.add(view);
  const button = iconButton(SPEAKER, {
    class: 'speaker',
    part: 'speaker',
    'aria-label': 'Sound',
    'aria-pressed': 'false',
    title: 'Sound on',
  });
  view.root.append(button);
  return () => button.remove();
}
