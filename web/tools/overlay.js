/**
 * The layer over a fire on which tools draw: the outline and the handles of the selected object, the preview
 * of a gesture, and a cross that stands for the pointer while keys draw.
 *
 * @typedef {import('./geometry.js').Point} Point
 * @typedef {import('./geometry.js').Fields} Fields
 */

import { handlesOf, outlineOf } from './geometry.js';

const SVG = 'http://www.w3.org/2000/svg';

/** Radius of a handle, and of the area that takes it [px]. */
const HANDLE_PX = 6;
const GRIP_PX = 16;

/** @type {(name: string, attributes: {[name: string]: string | number}) => SVGElement} */
function svg(name, attributes) {
  const node = document.createElementNS(SVG, name);
  for (const [attribute, value] of Object.entries(attributes)) node.setAttribute(attribute, String(value));
  return node;
}

/** The layer of one fire. */
export class Overlay {
  #fire;
  #outline = svg('path', { class: 'outline' });
  #preview = svg('path', { class: 'preview' });
  #guides = svg('path', { class: 'guide' });
  #cross = svg('path', { class: 'cross' });
  #handles = svg('g', {});
  /** Without an area, at the upper left and the lower right corner. */
  #corners = ['0 auto auto 0', 'auto 0 0 auto'].map((inset) => {
    const corner = document.createElement('i');
    corner.style.cssText = `position:absolute;inset:${inset}`;
    return corner;
  });
  element = document.createElement('div');

  /** @param {import('../hearth-fire.js').HearthFire} fire */
  constructor(fire) {
    this.#fire = fire;
    this.element.className = 'hearth-overlay';
    this.element.tabIndex = 0;
    this.element.setAttribute('role', 'application');
    this.element.setAttribute('aria-label', 'Drawing area: arrow keys move the cross, Enter presses and releases');
    const drawing = svg('svg', { 'aria-hidden': 'true' });
    drawing.append(this.#outline, this.#preview, this.#guides, this.#handles, this.#cross);
    this.element.append(...this.#corners, drawing);
  }

  /**
   * The point of the world under a point of the window.
   * @type {(at: {clientX: number, clientY: number}) => Point | null}
   */
  metres({ clientX, clientY }) {
    const { left, top } = this.#fire.getBoundingClientRect();
    return this.#fire.toMetres(clientX - left, clientY - top);
  }

  /** The points of the world at two corners of the layer, whatever transforms it; undefined without a picture. */
  get #box() {
    const [from, to] = this.#corners.map((corner) => {
      const { x, y } = corner.getBoundingClientRect();
      return this.metres({ clientX: x, clientY: y });
    });
    const { offsetWidth: width, offsetHeight: height } = this.element;
    return from && to && width && height ? { from, to, width, height } : undefined;
  }

  /** Metres of a pixel. */
  get perPixel() {
    const box = this.#box;
    return box ? (box.to.x - box.from.x) / box.width : 0.001;
  }

  /** Width and middle of what is seen [m]. */
  get seen() {
    const box = this.#box;
    const { domain_width: width, domain_height: height } = this.#fire.params;
    if (!box) return { width, x: 0, y: height / 2 };
    const { from, to } = box;
    return { width: Math.min(width, to.x - from.x), x: (from.x + to.x) / 2, y: (Math.max(0, to.y) + from.y) / 2 };
  }

  /**
   * The handle at a point of the world; undefined without one.
   * @type {(object: Fields | undefined, at: Point) => ReturnType<typeof handlesOf>[number] | undefined}
   */
  handleAt(object, at) {
    const size = this.perPixel;
    const all = object ? handlesOf(object, size) : [];
    const away = (/** @type {Point} */ point) => Math.hypot(point.x - at.x, point.y - at.y);
    const [nearest] = all.sort((a, b) => away(a.at) - away(b.at));
    return nearest && away(nearest.at) <= GRIP_PX * size ? nearest : undefined;
  }

  /**
   * Shows the outlines of objects, and the handles of one.
   * @type {(objects: Fields[], handled: Fields | undefined) => void}
   */
  select(objects, handled) {
    this.#outline.setAttribute('d', this.#path(objects.map(outlineOf)));
    const all = handled ? handlesOf(handled, this.perPixel) : [];
    const pixels = this.#pixels;
    this.#handles.replaceChildren(
      ...all.flatMap(({ does, at }) => {
        const { x, y } = pixels(at);
        return [svg('circle', { class: `handle ${does}`, cx: x, cy: y, r: HANDLE_PX })];
      }),
    );
  }

  /**
   * Shows what a gesture draws: objects, or an open path.
   * @type {(shown: {points: Point[], closed: boolean}[]) => void}
   */
  preview(shown) {
    this.#preview.setAttribute('d', this.#path(shown));
  }

  /** Shows the lines to which a moved object snaps. @param {Point[][]} lines */
  guide(lines) {
    this.#guides.setAttribute('d', this.#path(lines.map((points) => ({ points, closed: false }))));
  }

  /** Shows the cross. @param {Point | undefined} at */
  cross(at) {
    const { x, y } = at ? this.#pixels(at) : { x: 0, y: 0 };
    this.#cross.setAttribute('d', at ? `M${x - 12},${y}H${x + 12}M${x},${y - 12}V${y + 12}` : '');
  }

  /** Converts points of the world to pixels of the layer. @returns {(point: Point) => Point} */
  get #pixels() {
    const box = this.#box;
    if (!box) return () => ({ x: 0, y: 0 });
    const { from, to, width, height } = box;
    return ({ x, y }) => ({
      x: ((x - from.x) / (to.x - from.x)) * width,
      y: ((from.y - y) / (from.y - to.y)) * height,
    });
  }

  /** The outlines as a path. @param {{points: Point[], closed: boolean}[]} outlines */
  #path(outlines) {
    const pixels = this.#pixels;
    return outlines
      .filter(({ points }) => points.length > 0)
      .map(({ points, closed }) => {
        const all = points.map(pixels).map(({ x, y }) => `${x.toFixed(1)},${y.toFixed(1)}`);
        return `M${all.join('L')}${closed ? 'Z' : ''}`;
      })
      .join('');
  }
}
