/**
 * Flashes by success criterion 2.3.1 of the Web Content Accessibility Guidelines:
 * nothing flashes more than three times in any second, unless what flashes is small.
 *
 * A general flash is a pair of opposing changes of relative luminance by a tenth of
 * white or more, the darker of which is below 0.80. A red flash is a pair of opposing
 * changes to or from a saturated red, by more than 20 in (R − G − B) × 320. Flashes
 * are small where those at a time fill no more than a quarter of any field of 10°:
 * 341 × 256 px at 1024 × 768.
 *
 * Two things count: places that each flash too often and change at the same time, the
 * same way; and changes of a large part of one field, of whichever places, that follow
 * one another. A flame flickers
 * at every place by itself. How much of it flickers too often, at whatever time, is a
 * third figure, which the criterion does not ask for.
 *
 * It is asked of a film, picture by picture, in a browser and in Node alike.
 */

import { LINEAR } from './colour.mjs';

/** Of a field of 10° [CSS px]. */
const FIELD = [341, 256];
/** More than so much of it is not small [CSS px²]. */
export const SMALL = 0.25 * FIELD[0] * FIELD[1];
/** Changes in a second beyond which there are more than three pairs of them. */
const MOST = 6;
/** Changes less apart than so happen at the same time [s]: it is less than half of the
    shortest time that four flashes a second leave to each. */
const AT_ONCE = 0.1;

/**
 * What changes: a value of linear light, whether a change from there or to there
 * counts, and by how much it has to.
 * @typedef {object} Kind
 * @property {(r: number, g: number, b: number) => number} value
 * @property {(r: number, g: number, b: number) => boolean} counts
 * @property {number} least
 */

const luminance = (/** @type {number} */ r, /** @type {number} */ g, /** @type {number} */ b) => (
  0.2126 * r + 0.7152 * g + 0.0722 * b
);

/** @type {{[name: string]: Kind}} */
const KINDS = {
  // The darker of two is below 0.80 where either is.
  general: { value: luminance, counts: (r, g, b) => luminance(r, g, b) < 0.8, least: 0.1 - 1e-6 },
  red: {
    value: (r, g, b) => 320 * Math.max(r - g - b, 0),
    counts: (r, g, b) => r > 0 && r / (r + g + b) >= 0.8,
    least: 20 + 1e-6,
  },
};

/** How one kind of change goes on at every place. */
class Changes {
  /** @param {number} count @param {Kind} kind */
  constructor(count, kind) {
    this.kind = kind;
    /** The lowest and the highest value since it last changed, and whether each counts. */
    this.low = new Float32Array(count).fill(Infinity);
    this.high = new Float32Array(count).fill(-Infinity);
    this.lowCounts = new Uint8Array(count);
    this.highCounts = new Uint8Array(count);
    /** 1: it went up last; −1: down; 0: it has never changed by so much. */
    this.went = new Int8Array(count);
    /** When each place changed the last times, in turn. */
    this.times = new Float32Array(count * (MOST + 1)).fill(-Infinity);
    this.next = new Uint8Array(count);
    /** When it last went up, and down. */
    this.up = new Float32Array(count).fill(-Infinity);
    this.down = new Float32Array(count).fill(-Infinity);
  }

  /** @param {number} at @param {number} time @param {number} r @param {number} g @param {number} b */
  see(at, time, r, g, b) {
    const { kind, low, high, lowCounts, highCounts } = this;
    const value = kind.value(r, g, b);
    const counts = kind.counts(r, g, b);
    if (this.went[at] <= 0 && value - low[at] >= kind.least && (counts || lowCounts[at])) {
      this.change(at, time, 1);
      high[at] = -Infinity;
    } else if (this.went[at] >= 0 && high[at] - value >= kind.least && (counts || highCounts[at])) {
      this.change(at, time, -1);
      low[at] = Infinity;
    }
    if (value > high[at]) {
      high[at] = value;
      highCounts[at] = Number(counts);
    }
    if (value < low[at]) {
      low[at] = value;
      lowCounts[at] = Number(counts);
    }
  }

  /** @param {number} at @param {number} time @param {number} way */
  change(at, time, way) {
    this.went[at] = way;
    this.times[at * (MOST + 1) + this.next[at]] = time;
    this.next[at] = (this.next[at] + 1) % (MOST + 1);
    (way > 0 ? this.up : this.down)[at] = time;
  }

  /** Whether a place has changed more often in the last second than it may.
      @param {number} at @param {number} time */
  flashes(at, time) {
    // The oldest of one more than are allowed.
    return this.times[at * (MOST + 1) + this.next[at]] > time - 1 + 1e-4;
  }
}

/** A film's flashes. */
export class Flashes {
  /**
   * @param {number} width @param {number} height  Of a picture.
   * @param {number} pixel  Side of one of its pixels on the page [CSS px].
   */
  constructor(width, height, pixel) {
    this.width = width;
    this.height = height;
    this.pixel = pixel;
    this.field = FIELD.map((side) => Math.max(1, Math.round(side / pixel)));
    // Fields that overlap by all but an eighth: the upper left of each.
    this.corners = places(this.field[0], width).flatMap((x) => (
      places(this.field[1], height).map((y) => [x, y])
    ));
    this.kinds = Object.entries(KINDS).map(([name, kind]) => ({
      name,
      changes: new Changes(width * height, kind),
      /** Largest area that flashed too often in a second, all of it at once [CSS px²]. */
      area: 0,
      /** The same, each place when it would. */
      flickers: 0,
      /** Most changes of a large part of a field in a second. */
      most: 0,
      /** Of each field: when it changed, and which way; which way it goes just now. */
      events: this.corners.map(() => /** @type {[number, number][]} */ ([])),
      going: this.corners.map(() => ({ up: false, down: false })),
    }));
    this.sums = new Float64Array((width + 1) * (height + 1));
  }

  /**
   * Sees the next picture.
   * @param {number} time  Seconds, ever later.
   * @param {Uint8Array | Uint8ClampedArray} rgba  As on the page: nothing shows through.
   */
  see(time, rgba) {
    const count = this.width * this.height;
    for (const kind of this.kinds) {
      const { changes } = kind;
      for (let at = 0; at < count; at += 1) {
        changes.see(at, time, LINEAR[rgba[4 * at]], LINEAR[rgba[4 * at + 1]], LINEAR[rgba[4 * at + 2]]);
      }
      this.judge(kind, time);
    }
  }

  /** @param {any} kind @param {number} time */
  judge(kind, time) {
    const { changes, events, going } = kind;
    const often = (/** @type {number} */ at) => changes.flashes(at, time);
    const largest = () => this.corners.reduce((most, corner) => Math.max(most, this.inField(corner)), 0);
    this.sum(often);
    kind.flickers = Math.max(kind.flickers, largest());
    for (const [way, times, others, sign] of [
      ['up', changes.up, changes.down, 1],
      ['down', changes.down, changes.up, -1],
    ]) {
      const now = (/** @type {number} */ at) => times[at] > time - AT_ONCE + 1e-4;
      this.sum((at) => now(at) && often(at));
      kind.area = Math.max(kind.area, largest());
      // One half of a flash: what had gone the other way no more than a second ago.
      this.sum((at) => now(at) && others[at] > time - 1 + 1e-4);
      this.corners.forEach((corner, field) => {
        const large = this.inField(corner) > SMALL;
        // However long it takes it is one; and one more that way is no opposing one.
        if (large && !going[field][way] && events[field].at(-1)?.[1] !== sign) events[field].push([time, sign]);
        going[field][way] = large;
      });
    }
    for (const one of events) {
      while (one.length > 0 && one[0][0] <= time - 1 + 1e-4) one.shift();
      kind.most = Math.max(kind.most, one.length);
    }
  }

  /** Counts the places for which that holds, from the upper left to everywhere.
      @param {(at: number) => boolean} holds */
  sum(holds) {
    const { width, height, sums } = this;
    const stride = width + 1;
    for (let y = 0; y < height; y += 1) {
      let row = 0;
      for (let x = 0; x < width; x += 1) {
        if (holds(y * width + x)) row += 1;
        sums[(y + 1) * stride + x + 1] = sums[y * stride + x + 1] + row;
      }
    }
  }

  /** The area of those in a field [CSS px²]. @param {number[]} corner */
  inField([x, y]) {
    const stride = this.width + 1;
    const [right, low] = [Math.min(x + this.field[0], this.width), Math.min(y + this.field[1], this.height)];
    const { sums } = this;
    return (sums[low * stride + right] - sums[y * stride + right] - sums[low * stride + x] + sums[y * stride + x])
      * this.pixel ** 2;
  }

  /** What was found: for each kind, and whether all is well. */
  found() {
    const kinds = Object.fromEntries(this.kinds.map(({ name, area, flickers, most }) => [name, {
      /** What flashed more than three times in a second, at once, as a share of a quarter of a field. */
      area: area / SMALL,
      /** And each place when it would. */
      flickers: flickers / SMALL,
      /** Pairs of opposing changes of more than a quarter of a field in a second. */
      flashes: most / 2,
      passes: area <= SMALL && most <= MOST,
    }]));
    return { ...kinds, passes: Object.values(kinds).every(({ passes }) => passes) };
  }
}

/** Where fields of that size begin, along a side: the last one ends where that does.
    @param {number} field @param {number} side */
function places(field, side) {
  const last = Math.max(side - field, 0);
  const count = Math.ceil(last / Math.max(field / 8, 1));
  return Array.from({ length: count + 1 }, (_, at) => (count === 0 ? 0 : Math.round((at * last) / count)));
}
