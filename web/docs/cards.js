/**
 * The cards of lessons: two fires beside each other, a slider for the second one, and the number that it moves. One
 * card burns at a time. The build puts what a card states into `data-card`.
 *
 * @typedef {import('../hearth-fire.js').HearthFire} HearthFire
 *
 * @typedef {object} Card
 * @property {string} scene
 * @property {{[id: string]: number}} [values]  What differs from the scene, in both fires.
 * @property {string} slider  The parameter that the fires differ in.
 * @property {number} from  Its value in fire A, at the left end of the slider.
 * @property {number} to
 * @property {string} number  A field of the measures or of their place.
 * @property {boolean} [spread]  Whether its swing is shown, and not its mean.
 * @property {number} [x]  Where it is measured [m].
 * @property {number} [y]
 * @property {string} what  What the number is.
 */

import { POSITIONS, positionOf, valueAt } from '../paper/figures/range.js';
import { FIELDS, Field } from '../plots/field.js';
import { oxygen, temperature } from '../plots/units.js';
import { Reading } from './reading.js';

/** How often a number changes [ms]: faster ones cannot be read. */
const SHOW_MS = 250;

/** Ends the card that burns. @type {(() => void) | undefined} */
let stop;

/**
 * Shows the button of a card, which ends what another one has started, and its own fires at the next press.
 * @param {HTMLButtonElement} button @param {() => () => void} start  Returns what ends it.
 */
function runsAlone(button, start) {
  const words = button.textContent;
  button.hidden = false;
  button.addEventListener('click', () => {
    const runs = button.textContent === 'Stop';
    stop?.();
    stop = undefined;
    if (runs) return;
    const end = start();
    button.textContent = 'Stop';
    stop = () => {
      button.textContent = words;
      end();
    };
  });
}

/** The numbers as text. @type {{[number: string]: (value: number) => string}} */
const TEXTS = {
  temperature,
  oxygen,
  v: (speed) => `${speed.toFixed(2)} m/s`,
  flameHeight: (height) => `${(100 * height).toFixed(0)} cm`,
};

/** The value at a position of the slider, whose left end is that of fire A. @type {(card: Card, position: number) => number} */
export const sliderValue = ({ from, to }, position) =>
  position > 0 ? valueAt(position, from, to, isLog(from, to)) : from;

/** Whether ends are so far apart that equal ratios are equal distances. @type {(from: number, to: number) => boolean} */
const isLog = (from, to) => from > 0 && to / from >= 30;

/**
 * The value that a fragment such as `#wind=0.5` gives a card, within the ends of its slider; undefined for others.
 * @type {(fragment: string, anchor: string, card: Card) => number | undefined}
 */
export function linkedValue(fragment, anchor, { from, to }) {
  const [name, text] = fragment.replace(/^#/, '').split('=');
  const value = text ? Number(text) : NaN;
  if (name !== anchor || Number.isNaN(value)) return undefined;
  return Math.min(Math.max(value, Math.min(from, to)), Math.max(from, to));
}

/** @type {<Name extends keyof HTMLElementTagNameMap>(name: Name, properties: {[name: string]: unknown}, ...content: (string | Node)[]) => HTMLElementTagNameMap[Name]} */
function make(name, properties, ...content) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...content);
  return made;
}

/** Shows the button of each card, and opens the card of the page's address. @param {Iterable<HTMLElement>} cards */
export function showCards(cards) {
  /** @type {(() => void)[]} */
  const opens = [];
  for (const place of cards) {
    const card = /** @type {Card} */ (JSON.parse(place.dataset.card ?? ''));
    const button = /** @type {HTMLButtonElement} */ (place.querySelector('button'));
    const heading = headingOf(place);
    let first = card.from;
    runsAlone(button, () => burn(place, card, first, heading?.id ?? ''));
    opens.push(() => {
      const linked = linkedValue(location.hash, heading?.id ?? '', card);
      if (linked === undefined) return;
      first = linked;
      heading?.scrollIntoView();
      // A press asks for motion, an address does not.
      if (matchMedia('(prefers-reduced-motion: reduce)').matches) return;
      if (button.textContent === 'Stop') button.click();
      button.click();
    });
  }
  const open = () => {
    for (const act of opens) act();
  };
  addEventListener('hashchange', open);
  open();
}

/** The heading of the section of a card. @param {Element} place */
function headingOf(place) {
  let before = place.previousElementSibling;
  while (before && before.tagName !== 'H2') before = before.previousElementSibling;
  return before;
}

/** @type {(place: HTMLElement, card: Card, value: number, anchor: string) => () => void} */
function burn(place, card, value, anchor) {
  const ended = new AbortController();
  const status = make('p', { className: 'status' });
  status.setAttribute('role', 'status');
  const content = make('div', { className: 'lesson' }, status);
  place.classList.add('burns');
  place.prepend(content);
  Promise.all([import('../hearth-fire.js'), import('../parameters.js')])
    .then(([, { PARAMETERS }]) => {
      if (ended.signal.aborted) return;
      const { label = '', unit = '' } = PARAMETERS.find(({ id }) => id === card.slider) ?? {};
      fill(content, card, value, anchor, { label, unit: unit && ` ${unit}` }, ended.signal);
    })
    .catch(() => {
      status.textContent = 'The code of the fire did not load. Load the page again.';
    });
  return () => {
    ended.abort();
    content.remove();
    place.classList.remove('burns');
    if (document.fullscreenElement === place) document.exitFullscreen();
  };
}

/**
 * @param {HTMLElement} content @param {Card} card @param {number} value @param {string} anchor
 * @param {{label: string, unit: string}} parameter @param {AbortSignal} signal
 */
function fill(content, card, value, anchor, { label, unit }, signal) {
  const amount = (/** @type {number} */ of) => `${label} ${of}${unit}`;
  const a = side('A', card, card.from, amount);
  const b = side('B', card, value, amount);
  const slider = make('input', { type: 'range', min: '0', max: String(POSITIONS) });
  slider.value = String(positionOf(value, card.from, card.to, isLog(card.from, card.to)));
  slider.ariaValueText = amount(value);
  let now = value;
  slider.addEventListener('input', () => {
    now = sliderValue(card, Number(slider.value));
    slider.ariaValueText = amount(now);
    b.change(now);
  });
  const link = make('button', { type: 'button', title: 'Copy the address of this card with its slider' }, 'Link');
  const status = /** @type {HTMLElement} */ (content.querySelector('.status'));
  link.addEventListener('click', async () => {
    history.replaceState(null, '', `#${anchor}=${now}`);
    const copied = await navigator.clipboard?.writeText(location.href).then(
      () => true,
      () => false,
    );
    status.textContent = copied ? 'The address is copied.' : 'The address of this page is the link.';
  });
  const large = make('button', { type: 'button', hidden: !document.fullscreenEnabled }, 'Large');
  large.addEventListener('click', () => {
    if (document.fullscreenElement) document.exitFullscreen();
    else content.parentElement?.requestFullscreen().catch(() => {});
  });
  const fields = [a, b].map(({ fire, picture }) => new Field(fire, picture));
  const toggles = FIELDS.map(({ name, label: words }) => {
    const toggle = make('button', { type: 'button', ariaPressed: 'false' }, words);
    toggle.addEventListener('click', () => {
      for (const field of fields) field.toggle(name);
      toggle.ariaPressed = String(fields[0].shows(name));
    });
    return toggle;
  });
  signal.addEventListener('abort', () => {
    for (const field of fields) field.remove();
  });
  content.prepend(
    make('div', { className: 'fires' }, a.figure, b.figure),
    make('label', {}, `${label} of fire B`, slider),
    make('p', { className: 'buttons' }, ...toggles, large, link),
  );
  for (const { follow } of [a, b])
    follow(signal).catch((error) => {
      if (!signal.aborted) status.textContent = error instanceof Error ? error.message : String(error);
    });
}

/** A fire with its value and its number. @type {(name: string, card: Card, value: number, amount: (value: number) => string) => {fire: HearthFire, picture: HTMLElement, figure: HTMLElement, change: (value: number) => void, follow: (signal: AbortSignal) => Promise<void>}} */
function side(name, card, value, amount) {
  const { x = 0, y = 0 } = card;
  const fire = /** @type {HearthFire} */ (document.createElement('hearth-fire'));
  const attribute = card.slider.replaceAll('_', '-');
  const values = { preset: card.scene, warm: '', background: '#000', 'reduced-motion': 'ignore', ...card.values };
  for (const [id, stated] of Object.entries(values)) fire.setAttribute(id, String(stated));
  const stated = make('span', {});
  const number = make('strong', {}, '…');
  const ring = make('i', { hidden: card.y === undefined });
  const reading = new Reading(card.spread);
  const change = (/** @type {number} */ to) => {
    fire.setAttribute(attribute, String(to));
    fire.setAttribute('alt', `Fire ${name}: ${amount(to)}`);
    stated.textContent = amount(to);
    reading.clear();
  };
  change(value);
  const caption = make('figcaption', {}, make('b', {}, `Fire ${name}`), stated, make('span', {}, card.what), number);
  const picture = make('div', {}, fire, ring);
  const figure = make('figure', {}, picture, caption);

  /** Measures once a frame until the signal. @param {AbortSignal} signal */
  async function follow(signal) {
    let shown = -Infinity;
    while (!signal.aborted) {
      const now = await new Promise((resolve) => {
        requestAnimationFrame(resolve);
      });
      const measures = await fire.measure(x, y);
      const all = /** @type {{[field: string]: any}} */ ({ ...measures, ...measures.place, time: measures.time });
      reading.add(measures.time, all[card.number]);
      const pixel = fire.toPixels(x, y);
      if (pixel) ring.style.translate = `${pixel.x}px ${pixel.y}px`;
      if (now - shown < SHOW_MS) continue;
      shown = now;
      const mean = reading.value;
      number.textContent = mean === undefined ? '…' : (TEXTS[card.number]?.(mean) ?? String(mean));
    }
  }
  return { fire, picture, figure, change, follow };
}
