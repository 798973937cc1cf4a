/**
 * The tools: their names, hints, and icons as paths of 24 × 24.
 *
 * @typedef {object} Tool
 * @property {string} name
 * @property {'act' | 'draw' | 'edit' | 'view'} group
 * @property {string} key  The key that chooses it.
 * @property {string} label
 * @property {string} hint  What a visitor does with it.
 * @property {string} icon
 * @property {string} cursor
 */

/** The groups of the toolbar, in its order, with their labels. @type {[Tool['group'], string][]} */
export const GROUPS = [
  ['act', 'Fire'],
  ['draw', 'Draw'],
  ['edit', 'Edit'],
  ['view', 'View'],
];

/** In the order of their groups. @type {Tool[]} */
export const TOOLS = [
  {
    name: 'stir',
    group: 'act',
    key: '1',
    label: 'Stir',
    hint: 'Move to blow, click for sparks',
    cursor: '',
    icon: 'M3 9h11a3 3 0 1 0-3-3M3 13h16a2.5 2.5 0 1 1-2.5 2.5M3 17h7a2 2 0 1 1-2 2',
  },
  {
    name: 'blow',
    group: 'act',
    key: 'b',
    label: 'Blow',
    hint: 'Drag to blow; arrow keys blow from the cross and, with Shift, move it',
    cursor: 'all-scroll',
    icon: 'M3 8h9M3 12h14M3 16h9M14 7l5 5-5 5',
  },
  {
    name: 'sparks',
    group: 'act',
    key: 'k',
    label: 'Sparks',
    hint: 'Drag to throw sparks, or press Enter at the cross',
    cursor: 'crosshair',
    icon: 'M12 3v5M12 16v5M3 12h5M16 12h5M6 6l3 3M15 15l3 3M18 6l-3 3M9 15l-3 3',
  },
  {
    name: 'ignite',
    group: 'act',
    key: 'i',
    label: 'Ignite',
    hint: 'Press a solid or a wet source, or drag along it, to light it',
    cursor: 'crosshair',
    icon: 'M4 20L13 11M14 3c1 3 4 4 4 7a4 4 0 0 1-8 0c0-2 1-3 1-4 1 0 2 1 2 2 1-1 1-3 1-5z',
  },
  {
    name: 'water',
    group: 'act',
    key: 'w',
    label: 'Water',
    hint: 'Hold to spray water downwards',
    cursor: 'crosshair',
    icon: 'M12 3c3 4 6 7 6 11a6 6 0 0 1-12 0c0-4 3-7 6-11zM9 14a3 3 0 0 0 3 3',
  },
  {
    name: 'extinguish',
    group: 'act',
    key: 'x',
    label: 'Extinguish',
    hint: 'Press or drag to put out what burns',
    cursor: 'crosshair',
    icon: 'M8 9h7v12H8zM8 13h7M11.5 9V5M7 5h9l3 4M9 5l-4 4',
  },
  {
    name: 'probe',
    group: 'view',
    key: 'p',
    label: 'Probe',
    hint: 'Point at a place to measure it, or move the cross with the arrow keys',
    cursor: 'crosshair',
    icon: 'M12 2v6M12 16v6M2 12h6M16 12h6M12 8a4 4 0 1 1 0 8a4 4 0 1 1 0-8z',
  },
  {
    name: 'select',
    group: 'edit',
    key: '2',
    label: 'Select',
    hint: 'Click an object, with Shift several; drag them, or the handles of one',
    cursor: 'default',
    icon: 'M6 3l13 9-6 1.2L9.5 19z',
  },
  {
    name: 'brush',
    group: 'draw',
    key: '3',
    label: 'Brush',
    hint: 'Draw a stroke',
    cursor: 'crosshair',
    icon: 'M20 4c-5 2-9 6-11 10M9 14c-3 0-3 2-4 4-.5 1-1 1.5-2 2 4 1 8 0 8-3a3 3 0 0 0-2-3z',
  },
  {
    name: 'line',
    group: 'draw',
    key: '4',
    label: 'Line',
    hint: 'Drag from end to end',
    cursor: 'crosshair',
    icon: 'M5 19L19 5',
  },
  {
    name: 'box',
    group: 'draw',
    key: '5',
    label: 'Box',
    hint: 'Drag from corner to corner',
    cursor: 'crosshair',
    icon: 'M4 6h16v12H4z',
  },
  {
    name: 'circle',
    group: 'draw',
    key: '6',
    label: 'Circle',
    hint: 'Drag from the centre outwards',
    cursor: 'crosshair',
    icon: 'M12 4a8 8 0 1 1 0 16a8 8 0 1 1 0-16z',
  },
  {
    name: 'polygon',
    group: 'draw',
    key: '7',
    label: 'Polygon',
    hint: 'Click corners; click the first one again to close',
    cursor: 'crosshair',
    icon: 'M12 3l9 7-4 10H7L3 10z',
  },
  {
    name: 'text',
    group: 'draw',
    key: '8',
    label: 'Text',
    hint: 'Click where a word goes',
    cursor: 'text',
    icon: 'M5 6V4h14v2M12 4v16M9 20h6',
  },
  {
    name: 'source',
    group: 'draw',
    key: '9',
    label: 'Source',
    hint: 'Drag a line of fire',
    cursor: 'crosshair',
    icon: 'M12 3c1 4 6 6 6 12a6 6 0 0 1-12 0c0-3 2-4 2-7 2 1 3 2 3 4 2-2 2-5 1-9z',
  },
  {
    name: 'erase',
    group: 'edit',
    key: '0',
    label: 'Erase',
    hint: 'Drag over objects to remove them',
    cursor: 'cell',
    icon: 'M9 20h11M4 15l9-10 7 6-8 9H8z',
  },
];

/** A hint in the words of a finger, where the pointer is one. */
export const worded = (/** @type {string} */ hint) =>
  globalThis.matchMedia?.('(pointer: coarse)').matches
    ? hint
        .replace(', with Shift several', '; Select several adds more')
        .replace(/; arrow keys.*|, or press Enter.*|, or move the cross.*/, '')
        .replaceAll('Click', 'Tap')
        .replaceAll('click', 'tap')
    : hint;

/** Icons of the buttons that act at once. */
export const ICONS = {
  several: 'M4 4h8v8H4zM9 15v5h11V9h-5M17 2v5M14.5 4.5h5',
  picture: 'M4 5h16v14H4zM4 16l5-5 4 4 3-3 4 4M15.5 9h.01',
  plots: 'M4 4v16h16M7 15l4-6 4 4 5-8',
  undo: 'M9 6L4 11l5 5M4 11h10a6 6 0 0 1 0 12h-3',
  redo: 'M15 6l5 5-5 5M20 11H10a6 6 0 0 0 0 12h3',
  duplicate: 'M8 8h12v12H8zM4 16V4h12',
  back: 'M3 3h10v10H3zM16 9h5v12H9v-5M17 12l-4 5M13 13v4h4',
  front: 'M9 9h12v12H9zM13 6V3H3v10h3M12 17l5-5M13 12h4v4',
  remove: 'M5 7h14M9 7V4h6v3M7 7l1 13h8l1-13',
  close: 'M6 6l12 12M18 6L6 18',
};

/** The ways to align, with their icons. @type {[import('./geometry.js').Alignment, string][]} */
export const ALIGNMENTS = [
  ['left', 'M4 3v18M7 6h13v4H7zM7 14h8v4H7z'],
  ['centre', 'M12 3v3M12 10v4M12 18v3M5 6h14v4H5zM8 14h8v4H8z'],
  ['right', 'M20 3v18M4 6h13v4H4zM9 14h8v4H9z'],
  ['top', 'M3 4h18M6 7h4v13H6zM14 7h4v8h-4z'],
  ['middle', 'M3 12h3M10 12h4M18 12h3M6 5h4v14H6zM14 8h4v8h-4z'],
  ['bottom', 'M3 20h18M6 4h4v13H6zM14 9h4v8h-4z'],
];

/** The arrow keys: right and up. @type {{[key: string]: [number, number]}} */
export const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
