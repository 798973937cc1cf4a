/** Comparison of download sizes with the recorded ones. */

/** Growth that fails and decrease that should be recorded. */
const TOLERANCE = 0.02;

/**
 * The sizes [B] that have grown over their record or exceed their ceiling, and those that have fallen, as messages. A
 * size without a record counts as grown.
 * @param {{[name: string]: number}} sizes
 * @param {{[name: string]: number}} recorded
 * @param {{[name: string]: number | undefined}} ceilings
 */
export function compared(sizes, recorded, ceilings) {
  /** @type {string[][]} */
  const [grown, fallen] = [[], []];
  for (const [name, size] of Object.entries(sizes)) {
    const [record, ceiling = Infinity] = [recorded[name], ceilings[name]];
    const message = `${name}: ${size} bytes, recorded ${record ?? 'none'}`;
    if (size > ceiling) grown.push(`${name}: ${size} bytes, at most ${ceiling} are allowed`);
    else if (record === undefined || size > record * (1 + TOLERANCE)) grown.push(message);
    else if (size < record * (1 - TOLERANCE)) fallen.push(message);
  }
  return { grown, fallen };
}
