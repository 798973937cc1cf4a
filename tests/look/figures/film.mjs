/**
 * A fire as the page shows it at 1024 × 768, picture by picture, and the figures
 * of its pixels.
 */
import { Flashes } from './flashes.mjs';
import { okLab, relativeLuminance } from './colour.mjs';
import { rising } from './motion.mjs';

/** The element beside the panel [CSS px], and how many of these a pixel here is. */
const [WIDE, HIGH, PIXEL] = [684, 768, 3];
const [WIDTH, HEIGHT] = [WIDE / PIXEL, HIGH / PIXEL];
/** Pictures a second. */
export const RATE = 30;

/** Relative luminance from which a pixel is luminous, shown and before the tone map. */
const LUMINOUS = 0.03;
const SHINING = 0.05;

/** How often the slower figures are taken: in every so many pictures. */
const [LIGHT_EVERY, MOTION_EVERY] = [10, 3];

/** Linear sRGB to CIE XYZ. */
const XYZ = [
  [0.4123908, 0.3575843, 0.1804808],
  [0.212639, 0.7151687, 0.0721923],
  [0.0193308, 0.1191948, 0.9505322],
];

/** CIE XYZ to linear sRGB. */
const SRGB = [
  [3.2409699, -1.5373832, -0.4986108],
  [-0.9692436, 1.8759675, 0.0415551],
  [0.0556301, -0.203977, 1.0569715],
];

/** Chromaticity of linear sRGB. @param {number[]} rgb @returns {[number, number]} */
function chart(rgb) {
  const [x, y, z] = XYZ.map((row) => row[0] * rgb[0] + row[1] * rgb[1] + row[2] * rgb[2]);
  return [x / (x + y + z), y / (x + y + z)];
}

/** A chromaticity as a screen shows it, which has no less than no blue. */
function shown([x, y]) {
  const xyz = [x / y, 1, (1 - x - y) / y];
  return chart(SRGB.map((row) => Math.max(0, row[0] * xyz[0] + row[1] * xyz[1] + row[2] * xyz[2])));
}

/** A running sum of shares, and how many there were. */
class Share {
  of = 0;
  all = 0;

  add(of, all) {
    this.of += of;
    this.all += all;
  }

  get value() {
    return this.all > 0 ? this.of / this.all : NaN;
  }
}

/** Temperatures of the black bodies that colours are compared with [K]. */
const KELVINS = Array.from({ length: 241 }, (_, step) => 1000 + 5 * step);

export class Film {
  /**
   * Starts to watch a fire that burns. A painter has one film at a time.
   * @param {import('../painter.mjs').Painter} painter
   * @param {import('../painter.mjs').PictureRequest} request
   */
  static async of(painter, request) {
    const values = await painter.ask('values', request);
    const [bodies, start] = await Promise.all([
      painter.ask('locus', { kelvins: KELVINS, white: Number(values.white_balance) }),
      painter.ask('film', { ...request, width: WIDTH, height: HEIGHT }),
    ]);
    return new Film(painter, start, values, bodies);
  }

  /**
   * @param {import('../painter.mjs').Painter} painter @param {number} start  Age of the fire [s].
   * @param {{[id: string]: string}} values @param {[number, number][]} bodies  Where black bodies are.
   */
  constructor(painter, start, values, bodies) {
    this.painter = painter;
    this.start = start;
    this.flashes = new Flashes(WIDTH, HEIGHT, PIXEL);
    this.page = new Uint8ClampedArray(4 * WIDTH * HEIGHT);
    this.locus = { true: bodies, shown: bodies.map(shown) };
    this.warm = new Share();
    this.up = new Share();
    this.moving = new Share();
    this.exceeds = 0;
    this.offLocus = { true: [], shown: [] };
    this.mean = new Float64Array(WIDTH * HEIGHT);
    this.jumps = [];
    this.contrast = [0, 1, 2].map(() => new Share());
    this.flat = new Share();
    this.widths = new Share();
    /** Mean luminance of each picture. */
    this.means = [];
    this.pictures = 0;
    this.before = undefined;
    const number = (id) => Number(values[id]);
    /** Seconds of fire in one of the clock. */
    this.pace = number('time_scale');
    this.base =
      HEIGHT *
      (1 - Math.max(number('source_height'), number('seam') * number('domain_height')) / number('domain_height'));
    this.source = (number('source_width') / number('domain_height')) * HEIGHT;
    this.behind = behinds();
  }

  /** Goes on until that time [s] since the first picture. `found` is called once, because it takes long. */
  async until(seconds) {
    const ahead = [];
    for (let picture = this.pictures; picture < seconds * RATE; picture += 1) {
      const [time, light] = [this.start + (picture / RATE) * this.pace, picture % LIGHT_EVERY === 0];
      ahead.push(this.painter.call('picture', { time, light }));
    }
    // The painter draws the next picture while this one is measured.
    for (const picture of ahead) {
      const { bytes } = await picture;
      const light = bytes.subarray(4 * WIDTH * HEIGHT);
      if (light.length > 0) this.seeLight(new Float32Array(Uint8Array.from(light).buffer));
      this.see(this.pictures / RATE, bytes);
      this.pictures += 1;
    }
  }

  see(time, rgba) {
    const now = new Float32Array(WIDTH * HEIGHT);
    let [warm, luminous] = [0, 0];
    for (let at = 0; at < now.length; at += 1) {
      const [r, g, b, a] = [rgba[4 * at], rgba[4 * at + 1], rgba[4 * at + 2], rgba[4 * at + 3]];
      if (Math.max(r, g, b) > a) this.exceeds += 1;
      now[at] = relativeLuminance(r, g, b);
      this.mean[at] += now[at];
      if (now[at] > LUMINOUS) {
        luminous += 1;
        if (r >= g && g >= b) warm += 1;
      }
      this.page.set([r, g, b, 255], 4 * at);
    }
    this.warm.add(warm, luminous);
    this.means.push(now.reduce((sum, value) => sum + value, 0) / now.length);
    // The page is black.
    this.flashes.see(time, this.page);
    if (this.before && this.pictures % MOTION_EVERY === 0) {
      const [up, moving, all] = rising(this.before, now, WIDTH, HEIGHT, LUMINOUS);
      this.up.add(up, moving);
      this.moving.add(moving, all);
    }
    this.before = now;
    if (this.pictures % LIGHT_EVERY === 0) {
      this.seeBase(now);
      this.seeFlat(rgba, now);
      this.seeWidth(now);
      this.seeContrast(rgba, now);
    }
  }

  /** How far the chromaticity of what shines lies from the black bodies'. */
  seeLight(rgba) {
    for (let at = 0; at < rgba.length; at += 4) {
      const rgb = [...rgba.subarray(at, at + 3)];
      if (0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2] < SHINING) continue;
      const [x, y] = chart(rgb);
      for (const [which, bodies] of Object.entries(this.locus)) {
        let least = Infinity;
        for (let body = 0; body < bodies.length; body += 1) {
          const off = (x - bodies[body][0]) ** 2 + (y - bodies[body][1]) ** 2;
          if (off < least) least = off;
        }
        this.offLocus[which].push(Math.sqrt(least));
      }
    }
  }

  /** The largest step of luminance between two lines at the base, in its columns, as a
      share of the most luminous pixel. */
  seeBase(now) {
    const most = now.reduce((a, b) => Math.max(a, b), 0);
    if (most < LUMINOUS) return;
    const [middle, half] = [WIDTH / 2, Math.min(this.source, WIDTH) / 2];
    const reach = 0.08 * HEIGHT;
    for (let x = Math.ceil(middle - half); x < middle + half; x += 1) {
      let largest = 0;
      for (let y = Math.max(1, Math.floor(this.base - reach)); y < Math.min(HEIGHT, this.base + reach); y += 1) {
        largest = Math.max(largest, Math.abs(now[y * WIDTH + x] - now[(y - 1) * WIDTH + x]));
      }
      this.jumps.push(largest / most);
    }
  }

  /** The share of luminous pixels that have the most frequent colour, of 64 levels a channel. */
  seeFlat(rgba, now) {
    const counts = new Map();
    let luminous = 0;
    for (let at = 0; at < now.length; at += 1) {
      if (now[at] <= LUMINOUS) continue;
      const [r, g, b] = [rgba[4 * at] >> 2, rgba[4 * at + 1] >> 2, rgba[4 * at + 2] >> 2];
      const colour = (r << 12) | (g << 6) | b;
      counts.set(colour, (counts.get(colour) ?? 0) + 1);
      luminous += 1;
    }
    this.flat.add(Math.max(0, ...counts.values()), luminous);
  }

  /** The luminous width of lines between 0.3 and 0.5 of the height up to which nine of ten luminous pixels lie. */
  seeWidth(now) {
    const lines = new Array(HEIGHT).fill(0);
    now.forEach((value, at) => {
      if (value > LUMINOUS) lines[Math.floor(at / WIDTH)] += 1;
    });
    const all = lines.reduce((sum, count) => sum + count, 0);
    let [top, above] = [0, 0];
    while (top < HEIGHT && above + lines[top] <= 0.1 * all) {
      above += lines[top];
      top += 1;
    }
    const height = this.base - top;
    if (all === 0 || height <= 0) return;
    for (let y = Math.ceil(this.base - 0.5 * height); y < this.base - 0.3 * height; y += 1) {
      this.widths.add(lines[y] / this.source, 1);
    }
  }

  /** How different luminous pixels are from what is behind them: OkLab, hundredths. */
  seeContrast(rgba, now) {
    this.behind.forEach((behind, which) => {
      let [sum, count] = [0, 0];
      for (let at = 0; at < now.length; at += 1) {
        if (now[at] <= LUMINOUS) continue;
        const under = [...behind.subarray(3 * at, 3 * at + 3)];
        const left = 1 - rgba[4 * at + 3] / 255;
        const over = under.map((code, k) => Math.min(255, Math.round(rgba[4 * at + k] + code * left)));
        const [a, b] = [over, under].map(([red, green, blue]) => okLab(red, green, blue));
        sum += Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
        count += 1;
      }
      this.contrast[which].add(sum, count);
    });
  }

  /** Everything that was seen. @returns {any} */
  found() {
    const sorted = (values) => Float64Array.from(values).sort();
    const quantile = (values, share) => values[Math.min(values.length - 1, Math.floor(share * values.length))];
    const jumps = sorted(this.jumps);
    const off = Object.entries(this.offLocus).map(([which, all]) => [which, quantile(sorted(all), 0.99)]);
    let [left, right] = [0, 0];
    this.mean.forEach((sum, at) => {
      if (at % WIDTH < WIDTH / 2) left += sum;
      else right += sum;
    });
    return {
      seconds: this.pictures / RATE,
      flashes: this.flashes.found(),
      /** Distance from the locus, exceeded by one luminous pixel in a hundred: from where the
          black bodies stand in the chart, and from where a screen can show them. */
      locus: Object.fromEntries(off),
      warm: this.warm.value,
      up: this.up.value,
      moving: this.moving.value,
      asymmetry: Math.abs(left - right) / (left + right),
      /** Jump at the base that one column of twenty exceeds. */
      jump: quantile(jumps, 0.95),
      exceeds: this.exceeds,
      contrast: this.contrast.map((share) => share.value),
      flat: this.flat.value,
      width: this.widths.value,
      jerk: jerk(this.means),
      luminous: this.warm.all / this.pictures / (WIDTH * HEIGHT),
    };
  }
}

/** The mean second difference of a series by its mean. @param {number[]} series */
function jerk(series) {
  const differences = (/** @type {number[]} */ of) => of.slice(1).map((value, at) => value - of[at]);
  const size = (/** @type {number[]} */ of) => of.reduce((sum, value) => sum + Math.abs(value), 0) / of.length;
  return size(differences(differences(series))) / size(series);
}

/**
 * The flashes of a fire, and its pixels with a colour above their alpha, in a film of so
 * long [s]. A coarse one: what flashes is larger than its pixels.
 * @param {import('../painter.mjs').Painter} painter @param {import('../painter.mjs').PictureRequest} request
 * @param {number} seconds
 */
export async function glance(painter, request, seconds) {
  const [width, height] = [WIDTH / 2, HEIGHT / 2];
  const flashes = new Flashes(width, height, 2 * PIXEL);
  const [values, start] = await Promise.all([
    painter.ask('values', request),
    painter.ask('film', { ...request, width, height, quality: 'low' }),
  ]);
  const ahead = [];
  for (let picture = 0; picture < seconds * RATE; picture += 1) {
    const time = start + (picture / RATE) * Number(values.time_scale);
    ahead.push(painter.call('picture', { time }));
  }
  let [exceeds, luminous] = [0, 0];
  for (const [picture, answer] of ahead.entries()) {
    const { bytes: rgba } = await answer;
    for (let at = 0; at < rgba.length; at += 4) {
      const [r, g, b, a] = rgba.subarray(at, at + 4);
      if (Math.max(r, g, b) > a) exceeds += 1;
      if (relativeLuminance(r, g, b) > LUMINOUS) luminous += 1;
    }
    flashes.see(picture / RATE, rgba);
  }
  return { flashes: flashes.found(), exceeds, luminous: luminous / (seconds * RATE * width * height) };
}

/** What a fire may burn in front of: black, white, and something like a photograph, with
    its own lights and shades at every size. */
function behinds() {
  const count = WIDTH * HEIGHT;
  const photograph = new Uint8Array(3 * count);
  for (let at = 0; at < count; at += 1) {
    const [x, y] = [(at % WIDTH) / WIDTH, Math.floor(at / WIDTH) / HEIGHT];
    let light = 0.75 - 0.45 * y;
    for (const [size, share] of [
      [3, 0.22],
      [9, 0.14],
      [31, 0.09],
      [83, 0.06],
    ]) {
      light +=
        share * Math.sin(size * (x + 0.37 * y) + 2 * Math.sin(size * 0.7 * y + size)) * Math.cos(size * (y - 0.21 * x));
    }
    const tint = 0.5 + 0.5 * Math.sin(5 * x + 3 * y);
    const rgb = [0.9 + 0.1 * tint, 0.95, 1.05 - 0.25 * tint].map(
      (share) => 255 * Math.min(Math.max(light * share, 0), 1),
    );
    photograph.set(rgb, 3 * at);
  }
  return [new Uint8Array(3 * count), new Uint8Array(3 * count).fill(255), photograph];
}
