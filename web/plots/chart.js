/**
 * A chart: a title, the present value as text, and lines in an SVG.
 *
 * @typedef {{x: number, y: number}} Point
 * @typedef {[min: number, max: number]} Range
 * @typedef {[first: string, name: string, last: string]} Axis  The labels of an axis: its ends and what it shows.
 *
 * @typedef {object} ChartData
 * @property {(Point | undefined)[][]} lines  Of points, with gaps. The last line is the main one.
 * @property {Range} across
 * @property {Range} up
 * @property {Axis} alongX
 * @property {Axis} alongY
 * @property {string} now  The present value.
 * @property {string} description  The accessible name, after the title.
 * @property {number[]} [marks]  Lines upwards there.
 * @property {number} [mean]  A line across there.
 */

import { element } from '../element/controls/icon-button.js';

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
  return Number(((ROUND.find((step) => step * power >= most * 0.999_999) ?? 10) * power).toPrecision(3));
}

/** A chart of the card. */
export class Chart {
  element = element('div', { role: 'img' });
  #now = element('b', {});
  /** @type {{[side: string]: HTMLElement}} */
  #labels = Object.fromEntries(
    ['top', 'up', 'bottom', 'left', 'across', 'right'].map((side) => [side, element('span', { class: side })]),
  );
  #drawing = document.createElementNS(SVG, 'svg');
  #title;

  /** @param {string} title @param {string} [shape]  `wide` or `tall` */
  constructor(title, shape = '') {
    this.#title = title;
    this.element.className = `chart ${shape}`;
    for (const [name, value] of Object.entries({ viewBox: `0 0 ${WIDTH} ${HEIGHT}`, preserveAspectRatio: 'none' }))
      this.#drawing.setAttribute(name, value);
    this.element.append(
      element('p', {}, element('span', {}, title), this.#now),
      element('div', {}, this.#drawing, ...Object.values(this.#labels)),
    );
  }

  /** @param {ChartData} data */
  show({ lines, across, up, alongX, alongY, now, description, marks = [], mean }) {
    const coordinates = (/** @type {Point} */ { x, y }) => {
      const [right, above] = [share(x, across) * WIDTH, (1 - share(y, up)) * HEIGHT];
      return `${right.toFixed(1)},${above.toFixed(1)}`;
    };
    const middle = `M0,${HEIGHT / 2}H${WIDTH}M${WIDTH / 2},0V${HEIGHT}`;
    const paths = [
      path('grid', middle),
      ...lines.map((line, at) => path(at === lines.length - 1 ? 'main' : 'beside', pathOf(line, coordinates))),
    ];
    if (mean !== undefined) paths.push(path('mean', `M0,${((1 - share(mean, up)) * HEIGHT).toFixed(1)}H${WIDTH}`));
    for (const mark of marks) paths.push(path('mark', `M${(share(mark, across) * WIDTH).toFixed(1)},0V${HEIGHT}`));
    this.#drawing.replaceChildren(...paths);
    this.#now.textContent = now;
    const { top, up: upwards, bottom, left, across: along, right } = this.#labels;
    [left.textContent, along.textContent, right.textContent] = alongX;
    [bottom.textContent, upwards.textContent, top.textContent] = alongY;
    this.element.setAttribute('aria-label', `${this.#title}: ${description}`);
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

/** @type {(line: (Point | undefined)[], coordinates: (point: Point) => string) => string} */
function pathOf(line, coordinates) {
  let pen = 'M';
  return line
    .map((point) => {
      const drawn = point && pen + coordinates(point);
      pen = point ? 'L' : 'M';
      return drawn ?? '';
    })
    .join('');
}
