/**
 * The output of benchmark programs: lines of a name and `key=value` pairs,
 * `NAME,where=native,N=5000,neigh=19.4,median_ms=0.42,min_ms=0.41`. See README.md.
 */

/**
 * @typedef {object} Line
 * @property {string} name
 * @property {string} where  native, node or chromium.
 * @property {number} particles
 * @property {number} [neighbours]
 * @property {number} stepMs  Median time of a step.
 */

/**
 * The lines of a program's output that are such lines; it may print others.
 * @param {string} output
 * @returns {Line[]}
 */
export function parse(output) {
  const lines = [];
  for (const line of output.split('\n')) {
    const [name, ...pairs] = line.trim().split(',');
    const values = Object.fromEntries(pairs.map((pair) => pair.trim().split('=', 2)));
    const particles = Number(values.N);
    const stepMs = Number(values.median_ms);
    if (name && particles > 0 && stepMs > 0) {
      const neighbours = Number(values.neigh);
      lines.push({
        name,
        where: values.where ?? 'native',
        particles,
        neighbours: neighbours > 0 ? neighbours : undefined,
        stepMs,
      });
    }
  }
  return lines;
}

/** The value of a key in the first line that has it. */
export function value(/** @type {string} */ output, /** @type {string} */ key) {
  const found = output.match(new RegExp(`,${key}=([^,\\s]+)`));
  return found ? Number(found[1]) : undefined;
}
