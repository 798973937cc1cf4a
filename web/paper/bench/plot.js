/** The plot of the time of a step over the number of particles, with logarithmic axes, as inline SVG. */

const SVG = 'http://www.w3.org/2000/svg';
const WIDTH = 480;
const HEIGHT = 340;
/** Space for the numbers beside the axes. */
const LEFT = 64;
const BOTTOM = 44;
const TOP = 12;
const RIGHT = 30;

/**
 * @typedef {object} Line
 * @property {string} name
 * @property {string} className
 * @property {[count: number, ms: number][]} points
 */

/** @param {string} name @param {{[name: string]: string | number}} attributes @param {string} [text] */
function node(name, attributes, text) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  if (text !== undefined) made.textContent = text;
  return made;
}

/** The whole decades that hold all of these numbers. @param {number[]} values */
function decades(values) {
  const low = Math.floor(Math.log10(Math.min(...values)));
  return { low, high: Math.max(low + 1, Math.ceil(Math.log10(Math.max(...values)))) };
}

/** A power of ten as text: 0.01, 1, 10,000. @param {number} exponent */
function tick(exponent) {
  return exponent < 0 ? (10 ** exponent).toFixed(-exponent) : (10 ** exponent).toLocaleString('en');
}

/**
 * Replaces the content of `figure` with the plot; without points it becomes empty.
 * @param {HTMLElement} figure
 * @param {Line[]} lines
 */
export function showPlot(figure, lines) {
  const drawn = lines.filter(({ points }) => points.length > 0);
  const points = drawn.flatMap((line) => line.points);
  figure.replaceChildren();
  if (points.length === 0) return;
  const across = decades(points.map(([count]) => count));
  const up = decades(points.map(([, ms]) => ms));
  const x = (/** @type {number} */ count) =>
    LEFT + ((Math.log10(count) - across.low) / (across.high - across.low)) * (WIDTH - LEFT - RIGHT);
  const y = (/** @type {number} */ ms) =>
    HEIGHT - BOTTOM - ((Math.log10(ms) - up.low) / (up.high - up.low)) * (HEIGHT - BOTTOM - TOP);
  const svg = node('svg', {
    viewBox: `0 0 ${WIDTH} ${HEIGHT}`,
    role: 'img',
    'aria-label': `Time of a step over the number of particles: ${drawn.map(({ name }) => name).join('; ')}. The table has the numbers.`,
  });
  for (let at = across.low; at <= across.high; at += 1) {
    svg.append(
      node('path', { class: 'grid', d: `M${x(10 ** at)} ${TOP}V${HEIGHT - BOTTOM}` }),
      node('text', { x: x(10 ** at), y: HEIGHT - BOTTOM + 18, 'text-anchor': 'middle' }, tick(at)),
    );
  }
  for (let at = up.low; at <= up.high; at += 1) {
    svg.append(
      node('path', { class: 'grid', d: `M${LEFT} ${y(10 ** at)}H${WIDTH - RIGHT}` }),
      node('text', { x: LEFT - 8, y: y(10 ** at) + 5, 'text-anchor': 'end' }, tick(at)),
    );
  }
  svg.append(
    node('text', { x: (LEFT + WIDTH - RIGHT) / 2, y: HEIGHT - 6, 'text-anchor': 'middle' }, 'particles'),
    node(
      'text',
      { transform: `translate(14 ${(HEIGHT - BOTTOM) / 2}) rotate(-90)`, 'text-anchor': 'middle' },
      'ms a step',
    ),
  );
  for (const { className, points: own } of drawn) {
    const sorted = [...own].sort(([a], [b]) => a - b);
    const path = sorted.map(([count, ms], at) => `${at === 0 ? 'M' : 'L'}${x(count).toFixed(1)} ${y(ms).toFixed(1)}`);
    svg.append(node('path', { class: `line ${className}`, d: path.join('') }));
    for (const [count, ms] of sorted) svg.append(node('circle', { class: className, cx: x(count), cy: y(ms), r: 3 }));
  }
  const caption = document.createElement('figcaption');
  for (const { name, className } of drawn) {
    const mark = document.createElement('span');
    mark.className = className;
    mark.textContent = name;
    caption.append(mark);
  }
  figure.append(svg, caption);
}
