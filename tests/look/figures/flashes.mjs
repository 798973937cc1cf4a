/**
 * Flashes by success criterion 2.3.1 of the Web Content Accessibility Guidelines 2.2:
 * no more than three general flashes, and no more than three red ones, in any second,
 * unless those that happen concurrently fill no more than a quarter of any field of
 * 10°: 341 × 256 px at 1024 × 768.
 *
 * A general flash is a pair of opposing changes of relative luminance by a tenth of
 * white or more, the darker of which is below 0.80. A red flash is a pair of opposing
 * changes to or from a saturated red, by more than 0.2 in the chromaticity of CIE 1976.
 *
 * So a flash of a field is one of more than a quarter of it that changes together, there
 * and back, whichever places they are the next time. Places that flicker each in its own
 * time are no flash of their sum: how much of a field flickers too often, at whatever
 * time, is listed beside it, and the criterion does not ask for that.
 *
 * A film is measured picture by picture, in a browser and in Node alike.
 */

import { LINEAR } from './colour.mjs';

/** Of a field of 10° [CSS px]. */
const FIELD = [341, 256];
/** More than such a share of it is not small. */
export const SMALL = 0.25;
/** The shares that are asked whether so much flashes too often: the distance of a
    film from the criterion. */
const SHARES = Array.from({ length: 40 }, (_, at) => (at + 1) / 40);
/** Changes in a second beyond which there are more than three pairs of them. */
const MOST = 6;
/**
 * What changes within so long changes together [s]: in one picture of thirty a second, or,
 * where an edge comes between two, in two. In three, places that flicker five times a
 * second, each in its own time, would half of them seem to change at once. Changes
 * together are over when no more than such a share of what they need goes on: a steady
 * flow of single ones through two pictures, now a little more and now less, is no flash
 * after flash.
 */
const TOGETHER = [
  { long: 0.02, over: 1 },
  { long: 0.05, over: 0.5 },
];

/** How often every place has changed, one way and the other. */
class Changes {
  /** @param {number} count */
  constructor(count) {
    /** 1: it went up last; −1: down; 0: it has never changed by so much. */
    this.went = new Int8Array(count);
    /** When each place changed the last times, in turn. */
    this.times = new Float32Array(count * (MOST + 1)).fill(-Infinity);
    this.next = new Uint8Array(count);
    /** When it last went up, and down. */
    this.up = new Float32Array(count).fill(-Infinity);
    this.down = new Float32Array(count).fill(-Infinity);
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

/** Relative luminance, up and down. */
class Light extends Changes {
  /** A change is by so much, and between two of which one is below that. */
  static LEAST = 0.1 - 1e-6;
  static BRIGHT = 0.8;

  /** @param {number} count */
  constructor(count) {
    super(count);
    /** The lowest and the highest since it last changed. */
    this.low = new Float32Array(count).fill(Infinity);
    this.high = new Float32Array(count).fill(-Infinity);
  }

  /** @param {number} at @param {number} time @param {number} r @param {number} g @param {number} b */
  see(at, time, r, g, b) {
    const { low, high } = this;
    const light = luminance(r, g, b);
    if (this.went[at] <= 0 && light - low[at] >= Light.LEAST && low[at] < Light.BRIGHT) {
      this.change(at, time, 1);
      high[at] = -Infinity;
    } else if (this.went[at] >= 0 && high[at] - light >= Light.LEAST && light < Light.BRIGHT) {
      this.change(at, time, -1);
      low[at] = Infinity;
    }
    high[at] = Math.max(high[at], light);
    low[at] = Math.min(low[at], light);
  }
}

/** To a saturated red, and from it. No two of these are 0.2 apart, so that a change is
    always one between such a red and another colour. */
class Red extends Changes {
  /** A red of such a share of all light is saturated. */
  static SATURATED = 0.8;
  /** A change is by more than so much, here squared. */
  static MOST = 0.2 ** 2;
  /** Darker than that is black, which has no chromaticity, and counts as the white point
      does: the chromaticity of the light that a screen reflects, which is what an eye sees
      there. Below, a single step of eight bits would be the purest red. */
  static BLACK = 0.001;
  static WHITE = chromaticity(1, 1, 1);
  static PRIMARY = chromaticity(1, 0, 0);

  /** @param {number} count */
  constructor(count) {
    super(count);
    /** The peak and the valley since it last changed: how red the reddest was (0: none
        was), and how far from red the least red, squared; and their chromaticities. */
    this.reddest = new Float32Array(count);
    this.peak = new Float32Array(2 * count);
    this.furthest = new Float32Array(count).fill(-1);
    this.valley = new Float32Array(2 * count);
  }

  /** @param {number} at @param {number} time @param {number} r @param {number} g @param {number} b */
  see(at, time, r, g, b) {
    const dark = luminance(r, g, b) < Red.BLACK;
    const uv = dark ? Red.WHITE : chromaticity(r, g, b);
    const share = dark ? 0 : r / (r + g + b);
    const red = share >= Red.SATURATED;
    if (this.went[at] <= 0 && red && this.furthest[at] >= 0 && apart(uv, this.valley, at) > Red.MOST) {
      this.change(at, time, 1);
      this.reddest[at] = 0;
    } else if (this.went[at] >= 0 && this.reddest[at] > 0 && apart(uv, this.peak, at) > Red.MOST) {
      this.change(at, time, -1);
      this.furthest[at] = -1;
    }
    if (red && share > this.reddest[at]) {
      this.reddest[at] = share;
      this.peak.set(uv, 2 * at);
    }
    const off = (uv[0] - Red.PRIMARY[0]) ** 2 + (uv[1] - Red.PRIMARY[1]) ** 2;
    if (off > this.furthest[at]) {
      this.furthest[at] = off;
      this.valley.set(uv, 2 * at);
    }
  }
}

/** @param {number} r @param {number} g @param {number} b */
function luminance(r, g, b) {
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

/** u′ and v′ of CIE 1976, of linear sRGB. @param {number} r @param {number} g @param {number} b */
function chromaticity(r, g, b) {
  const x = 0.4123908 * r + 0.3575843 * g + 0.1804808 * b;
  const y = 0.212639 * r + 0.7151687 * g + 0.0721923 * b;
  const z = 0.0193308 * r + 0.1191948 * g + 0.9505322 * b;
  const all = x + 15 * y + 3 * z;
  return [(4 * x) / all, (9 * y) / all];
}

/** How far one chromaticity is from another of many, squared.
    @param {number[]} uv @param {Float32Array} of @param {number} at */
function apart([u, v], of, at) {
  return (u - of[2 * at]) ** 2 + (v - of[2 * at + 1]) ** 2;
}

/** What fields have done together, each asked for one share of its area. */
class Together {
  /** @param {number} count */
  constructor(count) {
    this.times = Array.from({ length: count }, () => /** @type {number[]} */ ([]));
    /** Which way each went last, and which way it goes just now. */
    this.went = new Int8Array(count);
    this.going = { up: new Uint8Array(count), down: new Uint8Array(count) };
    /** Most changes in a second. */
    this.most = new Uint16Array(count);
  }

  /** @param {number} at @param {number} time @param {'up' | 'down'} way @param {boolean} large @param {boolean} over */
  see(at, time, way, large, over) {
    const going = this.going[way];
    if (over) going[at] = 0;
    if (!large || going[at]) return;
    // However long it takes it is one; and one more that way is no opposing one.
    going[at] = 1;
    const sign = way === 'up' ? 1 : -1;
    if (this.went[at] === sign) return;
    this.went[at] = sign;
    const times = this.times[at];
    times.push(time);
    while (times[0] <= time - 1 + 1e-4) times.shift();
    this.most[at] = Math.max(this.most[at], times.length);
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
    this.corners = places(this.field[0], width).flatMap((x) => places(this.field[1], height).map((y) => [x, y]));
    const count = width * height;
    this.kinds = Object.entries({ general: new Light(count), red: new Red(count) }).map(([name, changes]) => ({
      name,
      changes,
      /** The largest share of a field that flickers too often, each place when it would. */
      flickers: 0,
      together: TOGETHER.map(() => SHARES.map(() => new Together(this.corners.length))),
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
      this.sum((at) => changes.flashes(at, time));
      kind.flickers = this.corners.reduce((most, corner) => Math.max(most, this.inField(corner)), kind.flickers);
    }
  }

  /** @param {any} kind @param {number} time */
  judge({ changes, together }, time) {
    for (const [way, times, others] of /** @type {const} */ ([
      ['up', changes.up, changes.down],
      ['down', changes.down, changes.up],
    ])) {
      TOGETHER.forEach(({ long, over }, which) => {
        // One half of a flash: what had gone the other way no more than a second ago.
        this.sum((at) => times[at] > time - long && others[at] > time - 1 + 1e-4);
        this.corners.forEach((corner, field) => {
          const share = this.inField(corner);
          SHARES.forEach((least, at) => {
            together[which][at].see(field, time, way, share > least, share <= over * least);
          });
        });
      });
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

  /** The share of a field that they fill. @param {number[]} corner */
  inField([x, y]) {
    const stride = this.width + 1;
    const [right, low] = [Math.min(x + this.field[0], this.width), Math.min(y + this.field[1], this.height)];
    const { sums } = this;
    return (
      (sums[low * stride + right] - sums[y * stride + right] - sums[low * stride + x] + sums[y * stride + x]) *
      (this.pixel ** 2 / (FIELD[0] * FIELD[1]))
    );
  }

  /** What was found: for each kind, and whether all is well. */
  found() {
    const kinds = Object.fromEntries(
      this.kinds.map(({ name, flickers, together }) => {
        const most = SHARES.map((_, at) =>
          Math.max(...together.flatMap((/** @type {Together[]} */ shares) => [...shares[at].most])),
        );
        const flashes = Math.max(...most.filter((_, at) => SHARES[at] >= SMALL)) / 2;
        return [
          name,
          {
            /** Pairs of opposing changes of more than a quarter of a field in a second. */
            flashes,
            /** More than that share of a field flashed more than three times in a second. */
            area: Math.max(0, ...SHARES.filter((_, at) => most[at] > MOST)),
            /** And that share did, each place when it would. */
            flickers,
            passes: flashes <= MOST / 2,
          },
        ];
      }),
    );
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
