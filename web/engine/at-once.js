/**
 * The calls that no other call delays, for instance one that waits for a part of the wasm: a visitor sees at once what
 * they do, and no other call depends on them.
 */
export const AT_ONCE = ['play', 'pause', 'visible', 'resize', 'remove'];
