/**
 * A chart: a title, the present value in words, and lines in a frame of its own SVG.
 *
 * @typedef {{x: number, y: number}} Point
 * @typedef {[min: number, max: number]} Range
 * @typedef {[first: string, last: string]} Ends  The labels of an axis.
 *
 * @typedef {object} Shown
 * @property {(Point | undefined)[][]} lines  Of points, with gaps. The last line is the main one.
 * @property {Range} across
 * @property {Range} up
 * @property {Ends} alongX
 * @property {Ends} alongY
 * @property {string} now  The present value.
 * @property {string} says  The chart in words.
 * @property {number} [mark]  A line upwards there.
 */

import { element } from '../element/icon-button.js';

const SVG = 'http://www.w3.org/2000/svg';

/** Size of the drawing in its own units. */
const WIDTH = 200;
const HEIGHT = 80;

/** The first numbers of the ends of axes. */
const ROUND = [1, 2, 3, 5, 8, 10];

/** The next round number. @param {number} most */
export function roundUp(most) {
  if (!(most > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(most));
  return Number(((ROUND.find((one) => one * power >= most * 0.999_999) ?? 10) * power).toPrecision(3));
}

/** A chart of the card. */
export class Chart {
  element = element('div', { role: 'img' });
  #now = element('b', {});
  /** @type {{[place: string]: HTMLElement}} */
  #labels = Object.fromEntries(['top', 'bottom', 'left', 'right'].map((place) => [place, element('span', { class: place })]));
  #drawing = document.createElementNS(SVG, 'svg');
  #title;

  /** @param {string} title @param {string} [shape]  `wide` or `tall` */
  constructor(title, shape = '') {
    this.#title = title;
    this.element.className = `chart ${shape}`;
    const caption = element('p', {});
    caption.append(Object.assign(element('span', {}), { textContent: title }), this.#now);
    const frame = element('div', {});
    for (const [name, value] of Object.entries({ viewBox: `0 0 ${WIDTH} ${HEIGHT}`, preserveAspectRatio: 'none' })) this.#drawing.setAttribute(name, value);
    frame.append(this.#drawing, ...Object.values(this.#labels));
    this.element.append(caption, frame);
  }

  /** @param {Shown} shown */
  show({ lines, across, up, alongX, alongY, now, says, mark }) {
    const place = (/** @type {Point} */ { x, y }) => {
      const [right, above] = [share(x, across) * WIDTH, (1 - share(y, up)) * HEIGHT];
      return `${right.toFixed(1)},${above.toFixed(1)}`;
    };
    const middle = `M0,${HEIGHT / 2}H${WIDTH}M${WIDTH / 2},0V${HEIGHT}`;
    const paths = [path('grid', middle), ...lines.map((line, at) => path(at === lines.length - 1 ? 'main' : 'beside', pathOf(line, place)))];
    if (mark !== undefined) paths.push(path('mark', `M${(share(mark, across) * WIDTH).toFixed(1)},0V${HEIGHT}`));
    this.#drawing.replaceChildren(...paths);
    this.#now.textContent = now;
    [this.#labels.left.textContent, this.#labels.right.textContent] = alongX;
    [this.#labels.bottom.textContent, this.#labels.top.textContent] = alongY;
    this.element.setAttribute('aria-label', `${this.#title}: ${says}`);
  }
}

/** @type {(value: number, range: Range) => number} */
function share(value, [min, max]) {
  return (value - min) / (max - min);
}

/** @type {(name: string, d: string) => SVGElement} */
function path(name, d) {
  const made = document.createElementNS(SVG, 'path');
  made.setAttribute('class', name);
  made.setAttribute('d', d);
  return made;
}

/** @type {(line: (Point | undefined)[], place: (point: Point) => string) => string} */
function pathOf(line, place) {
  let pen = 'M';
  return line.map((point) => {
    const drawn = point && pen + place(point);
    pen = point ? 'L' : 'M';
    return drawn ?? '';
  }).join('');
}
