/**
 * The rule of `docs/parameters.md#values`, as a table: what a value of each type is, for a parameter of each kind. The
 * library and the element hold it.
 */

/** The value is refused. */
export const REFUSED = 'refused';
/** The value restores the default. */
export const DEFAULT = 'default';

const [NOTHING, LIST, OBJECT] = [NaN, [1], { wind: 1 }];

/** What a parameter becomes by a value. @type {{[id: string]: [value: unknown, becomes: unknown][]}} */
export const RULE = {
  wind: [
    [1.5, 1.5],
    ['1.5', 1.5],
    [' 1.5 ', 1.5],
    [null, DEFAULT],
    [true, REFUSED],
    ['', REFUSED],
    ['strong', REFUSED],
    [NOTHING, REFUSED],
    [LIST, REFUSED],
    [OBJECT, REFUSED],
  ],
  seed: [
    [7, 7],
    ['7', 7],
    [null, DEFAULT],
    [7.5, REFUSED],
    ['7.5', REFUSED],
    [false, REFUSED],
  ],
  source_enabled: [
    [false, false],
    ['false', false],
    ['off', false],
    ['0', false],
    ['on', true],
    ['', true],
    [null, DEFAULT],
    [0, REFUSED],
    ['no', REFUSED],
    [LIST, REFUSED],
  ],
  edges: [
    ['periodic', 'periodic'],
    [null, DEFAULT],
    [1, REFUSED],
    [true, REFUSED],
    ['', REFUSED],
    [LIST, REFUSED],
  ],
  hot_colour: [
    ['#f00', '#ff0000'],
    [null, DEFAULT],
    [0xff0000, REFUSED],
    [true, REFUSED],
    ['', REFUSED],
    [OBJECT, REFUSED],
  ],
};
