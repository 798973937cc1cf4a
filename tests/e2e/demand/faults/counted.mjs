/** Which calls of a run fail, one in each case. */

/** The first calls, each of which fails in a case, and the cases that the others share: `HEARTH_CASES` states fewer. */
const [FIRST, SPREAD] = (process.env.HEARTH_CASES ?? '100,50').split(',').map(Number);

/** The numbers of the calls that fail: the first ones, and some spread over the rest. @param {number} all */
export function struck(all) {
  const rest = Math.max(all - FIRST, 0);
  const cases = Math.min(rest, SPREAD);
  return [
    ...Array.from({ length: Math.min(all, FIRST) }, (_, at) => at + 1),
    ...Array.from({ length: cases }, (_, at) => FIRST + Math.round((rest * (at + 1)) / cases)),
  ];
}
