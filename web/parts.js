/**
 * The parts of a wasm module: code that a page loads when a fire first needs it.
 */

/**
 * The parts that a module has when it starts: all of a module that is as cargo linked it. The build takes them out of a
 * module, which then exports by numbers what they import.
 * @param {WebAssembly.Module} module
 * @param {string[]} all
 */
export function loadedParts(module, all) {
  const isDivided = WebAssembly.Module.exports(module).some(({ name }) => name === '0');
  return new Set(isDivided ? [] : all);
}

/**
 * Checks that a module is a part. The build writes the name of each part into it.
 * @param {WebAssembly.Module} module
 * @param {string} name
 */
export function checkPart(module, name) {
  if (WebAssembly.Module.customSections(module, `part:${name}`).length === 0) {
    throw new TypeError(`it is not the part "${name}"`);
  }
}
