/**
 * The parts of a wasm module: code that a page loads when a fire first needs it.
 */

/**
 * The calls of a fire that go past those that wait for a part: a visitor sees at once what they do, and no other call
 * depends on them.
 */
export const AT_ONCE = ['play', 'pause', 'visible', 'resize', 'remove'];

/**
 * Whether the build has taken the parts out of a module, which then exports by numbers what they import. A module as
 * cargo linked it has all parts when it starts.
 * @param {WebAssembly.Module} module
 */
export function isDivided(module) {
  return WebAssembly.Module.exports(module).some(({ name }) => name === '0');
}

/**
 * Checks that a module is a part of another. The build writes the hash of the other into both.
 * @param {WebAssembly.Module} module
 * @param {string} name of the part
 * @param {WebAssembly.Module} base the other
 * @throws {TypeError}
 */
export function checkPart(module, name, base) {
  const build = buildOf(module, `part:${name}`);
  if (build === undefined) throw new TypeError(`it is not the part "${name}"`);
  if (build !== buildOf(base, 'build')) throw new TypeError('it is of another build; reload the page');
}

/** The hash in a section. @type {(module: WebAssembly.Module, section: string) => string | undefined} */
function buildOf(module, section) {
  const [data] = WebAssembly.Module.customSections(module, section);
  return data && new Uint8Array(data).join();
}
