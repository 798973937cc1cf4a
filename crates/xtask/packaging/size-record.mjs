/** Download sizes: their comparison with the recorded ones, and the documents that name them. */

/** Growth that fails and decrease that should be recorded. */
const TOLERANCE = 0.02;

/** The entries of the table in the package's README, by the download that each begins. */
const ENTRIES = {
  'element and engine': ['`hearth-fire`', '`hearth-fire/react`'],
  'panel, on request': ['`hearth-fire/panel`'],
  'headless library': ['`hearth-fire/sim`'],
};

/**
 * The sizes [B] that have grown over their record and those that have fallen, as messages. A size without a record counts
 * as grown.
 * @param {{[name: string]: number}} sizes
 * @param {{[name: string]: number}} recorded
 */
export function compared(sizes, recorded) {
  /** @type {string[][]} */
  const [grown, fallen] = [[], []];
  for (const [name, size] of Object.entries(sizes)) {
    const record = recorded[name];
    const message = `${name}: ${size} bytes, recorded ${record ?? 'none'}`;
    if (record === undefined || size > record * (1 + TOLERANCE)) grown.push(message);
    else if (size < record * (1 - TOLERANCE)) fallen.push(message);
  }
  return { grown, fallen };
}

/**
 * A document with these sizes in the last cells of its tables, and in its sentence about the first download.
 * @param {string} text @param {{[name: string]: number}} sizes
 */
export function documented(text, sizes) {
  return Object.entries(sizes).reduce((text, [name, bytes]) => {
    const size = `${Math.round(bytes / 1000)} KB`;
    const rows = [name, ...(ENTRIES[/** @type {keyof typeof ENTRIES} */ (name)] ?? [])].join('|');
    const changed = text.replace(new RegExp(`^(\\| (?:${rows}) \\|.* )?\\d+ KB \\|$`, 'gm'), (all, row) =>
      row ? `${row}${size} |` : all,
    );
    return name === 'element and engine' ? changed.replace(/\d+ KB(?= to download, engine)/, size) : changed;
  }, text);
}
