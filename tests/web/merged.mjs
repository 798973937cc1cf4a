/** Undo and redo as the engine merges them, for fires of tests that have none. */

/** @typedef {{[name: string]: any}} Fields */

/** @type {(first: unknown, second: unknown) => boolean} */
const same = (first, second) => JSON.stringify(first) === JSON.stringify(second);

/** @param {unknown[]} all */
const areFields = (all) => all.every((value) => typeof value === 'object' && value && !Array.isArray(value));

/**
 * What a step leads to from present settings: `to`, with what has changed since the step led to `from`.
 * @template T
 * @param {T} to
 * @param {T} from
 * @param {T} now
 * @returns {T}
 */
export function merged(to, from, now) {
  if (same(from, now)) return to;
  if (same(to, from)) return now;
  /** @type {any[]} */
  const all = [to, from, now];
  if (all.every(Array.isArray)) return /** @type {any} */ (mergedObjects(all[0], all[1], all[2]));
  if (!areFields(all)) return to;
  const names = new Set(all.flatMap(Object.keys));
  const [a, b, c] = all;
  const fields = [...names].map((name) => [name, merged(a[name], b[name], c[name])]);
  return /** @type {any} */ (Object.fromEntries(fields.filter(([, value]) => value !== undefined)));
}

/** Objects by their ids; those that the page has added are the last ones. @type {(...lists: Fields[][]) => Fields[]} */
function mergedObjects(to, from, now) {
  const [before, present] = [from, now].map((list) => new Map(list.map((object) => [object.id, object])));
  const kept = to.filter(({ id }) => present.has(id) || !before.has(id));
  const known = new Set(kept.map(({ id }) => id));
  const added = now.filter(({ id }) => !before.has(id) && !known.has(id));
  return [
    ...kept.map((object) => {
      const [old, other] = [before.get(object.id), present.get(object.id)];
      // Another object may have the id by now.
      return old && other && old.kind === object.kind && other.kind === object.kind
        ? merged(object, old, other)
        : object;
    }),
    ...added,
  ];
}
