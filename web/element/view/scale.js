/**
 * The colour bar of a `<hearth-fire>` that shows a quantity instead of its fire. It is loaded with the
 * first such display mode.
 *
 * The colours are those of `shaders/scale.glsl`. They are computed here because older browsers lack
 * OKLCH gradients.
 */

import { QUANTITIES } from '../../generated/quantities.js';

const STYLES = /* css */ `
.scale-room { position: absolute; inset: 0; container-type: size; pointer-events: none; }
.scale {
  position: absolute; left: 12px; bottom: 12px; box-sizing: border-box; max-inline-size: calc(100% - 24px);
  padding: 8px 12px 10px; border-radius: 10px; background: rgb(14 11 10 / 0.72); color: #f4ece4;
  font: 500 12px/1.25 system-ui, sans-serif; font-variant-numeric: tabular-nums; text-align: start;
}
.scale[hidden] { display: none; }
.scale > b { display: block; overflow: hidden; font-weight: 600; text-overflow: ellipsis; white-space: nowrap; }
.scale > div { position: relative; block-size: clamp(64px, 24cqh, 140px); margin-block: 11px 3px; }
.scale i {
  position: absolute; inset: -4px auto -4px 0; inline-size: 12px; box-sizing: border-box;
  border: 1px solid rgb(255 255 255 / 0.45); border-radius: 3px;
}
.scale span, .scale em { padding-inline-start: 22px; white-space: nowrap; }
.scale span { position: absolute; left: 0; bottom: calc(var(--at) * 100%); translate: 0 50%; }
.scale span::before {
  content: ''; position: absolute; left: 12px; top: calc(50% - 0.5px); inline-size: 5px;
  border-block-start: 1px solid; opacity: 0.7;
}
/* The invisible widest label sets the width of the bar: the others are positioned absolutely. */
.scale em { display: block; block-size: 0; overflow: hidden; visibility: hidden; }
@container (width < 280px) {
  .scale { left: 8px; bottom: 8px; padding: 6px 9px 9px; font-size: 11px; }
}
/* Makes room for the pause button, the buttons at the left, and the tools and their status. */
:where(.root:has(> .play:not([hidden])[data-does='pause']), .root[data-tools='row']) > * > .scale { bottom: 60px; }
.root[data-tools='column'] .scale { left: calc(154px + 2 * max(12px, env(safe-area-inset-left))); }
@container (height < 240px) {
  .root .scale { left: 64px; bottom: 8px; }
  .root[data-tools='row'] .scale { display: none; }
}
@container (width < 160px) or (height < 160px) or ((width < 360px) and (height < 240px)) { .root .scale { display: none; } }
`;

/** Labels of the display modes whose name is not their quantity. @type {{[mode: string]: string}} */
const LABELS = { particles: 'Temperature', velocity: 'Speed' };

/** Colours in a gradient: enough that its linear segments are invisible. */
const STOPS = 32;

/** Minimum distance of a tick from the ends, as a share of the bar: its number must not overlap theirs. */
const TICK_MARGIN = 0.13;

/** The bar of one element. */
export class Scale {
  #bar = document.createElement('div');
  #shown = '';

  /** @param {import('./view.js').FireView} view */
  constructor(view) {
    const room = document.createElement('div');
    room.className = 'scale-room';
    this.#bar.className = 'scale';
    this.#bar.dir = 'ltr';
    this.#bar.hidden = true;
    this.#bar.setAttribute('part', 'scale');
    this.#bar.setAttribute('role', 'img');
    room.append(this.#bar);
    view.style(STYLES);
    view.root.append(room);
  }

  /**
   * Shows the quantity of a display mode, or nothing. Until the next quantity is drawn, the picture and
   * its bar stay.
   * @param {string} [mode]
   * @param {[number, number] | null} [range] the values of its first and its last colour
   */
  show(mode = '', range = null) {
    const quantity = Object.hasOwn(QUANTITIES, mode) && QUANTITIES[/** @type {keyof typeof QUANTITIES} */ (mode)];
    if (quantity && !range) return;
    this.#bar.hidden = !quantity;
    if (!quantity || !range) return;
    const shown = `${mode} ${range}`;
    if (shown === this.#shown) return;
    this.#shown = shown;
    const label = LABELS[mode] ?? mode[0].toUpperCase() + mode.slice(1);
    const [min, max] = range;
    const unit = quantity.unit && `\u00a0${quantity.unit}`;
    this.#bar.setAttribute('aria-label', `${label}, ${formatNumber(min)} to ${formatNumber(max)}${unit}`);

    const heading = document.createElement('b');
    heading.textContent = label;
    const track = document.createElement('div');
    const band = document.createElement('i');
    band.style.background = gradient(quantity.signed);
    track.append(band);
    let widest = '';
    for (const value of [min, ...ticks(min, max, quantity.whole), max]) {
      const tick = document.createElement('span');
      const end = value === min || value === max;
      tick.textContent = formatNumber(value) + (end ? unit : '');
      tick.style.setProperty('--at', String((value - min) / (max - min)));
      track.append(tick);
      if (tick.textContent.length > widest.length) widest = tick.textContent;
    }
    const width = document.createElement('em');
    width.textContent = widest;
    this.#bar.replaceChildren(heading, track, width);
  }
}

/**
 * One or two round values that divide the bar evenly, or three if two cannot; an empty list if no round
 * value lies between the ends.
 * @type {(min: number, max: number, whole: boolean) => number[]}
 */
export function ticks(min, max, whole) {
  const span = max - min;
  /** @type {number[]} */
  let best = [];
  let widest = Infinity;
  for (let power = Math.ceil(Math.log10(span)); power > Math.log10(span) - 2; power -= 1) {
    for (const digit of [5, 2, 1]) {
      // Dividing by a power of ten rounds less than multiplying by its inverse.
      const step = power < 0 ? digit / 10 ** -power : digit * 10 ** power;
      const first = Math.ceil((min + TICK_MARGIN * span) / step);
      const last = Math.floor((max - TICK_MARGIN * span) / step);
      const count = last - first + 1;
      if (!(count >= 1 && count <= 3) || (whole && step < 1)) continue;
      const gap = Math.max(first * step - min, count > 1 ? step : 0, max - last * step) * (count > 2 ? 2.1 : 1);
      if (gap > 0.99 * widest) continue;
      widest = gap;
      best = Array.from({ length: count }, (_, at) => Number(((first + at) * step).toPrecision(6)));
    }
  }
  return best;
}

const SUPERSCRIPTS = [...'⁰¹²³⁴⁵⁶⁷⁸⁹'];

/** A number in the notation of tables: 0.05, −200, 20 000, 5·10⁻⁶. @param {number} value */
export function formatNumber(value) {
  const size = Math.abs(value);
  const sign = value < 0 ? '−' : '';
  const digits = Number(size.toPrecision(4));
  if (digits !== 0 && (digits < 1e-3 || digits >= 1e7)) {
    const [mantissa, power] = digits.toExponential().split('e');
    const raised = power
      .replace('+', '')
      .replace('-', '⁻')
      .replace(/\d/g, (digit) => SUPERSCRIPTS[Number(digit)]);
    return `${sign}${mantissa === '1' ? '' : `${mantissa}·`}10${raised}`;
  }
  const text = String(digits);
  return sign + (digits < 1e4 ? text : text.replace(/\B(?=(\d{3})+$)/g, '\u202f'));
}

/** The colours from bottom to top as a CSS gradient. @param {boolean} signed */
function gradient(signed) {
  const stops = Array.from({ length: STOPS + 1 }, (_, at) => `rgb(${colour(at / STOPS, signed)})`);
  return `linear-gradient(to top, ${stops})`;
}

/**
 * The colour at a position of the bar: from dark to bright, or from a dark middle to two bright ends
 * for a signed quantity.
 * @param {number} at from 0 to 1
 * @param {boolean} signed
 */
export function colour(at, signed) {
  if (!signed) return srgb(0.18 + 0.77 * at, 0.03 + 0.6 * at * (1 - at) + 0.06 * at, 295 + 170 * at);
  const size = Math.abs(2 * at - 1);
  const [chroma, hue] = at < 0.5 ? [0.34, 262 - 42 * size] : [0.46, 15 + 65 * size];
  return srgb(0.16 + 0.74 * size, chroma * size * (1 - 0.74 * size), hue);
}

/**
 * Converts OKLCH to sRGB: three numbers from 0 to 255.
 * @type {(lightness: number, chroma: number, hue: number) => number[]}
 */
function srgb(lightness, chroma, hue) {
  const a = chroma * Math.cos((hue * Math.PI) / 180);
  const b = chroma * Math.sin((hue * Math.PI) / 180);
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ].map((linear) => {
    const light = Math.min(1, Math.max(0, linear));
    const shown = light <= 0.0031308 ? 12.92 * light : 1.055 * light ** (1 / 2.4) - 0.055;
    return Math.round(255 * shown);
  });
}
