/**
 * What a page does with the library in a browser: it burns everything and keeps the
 * fingerprints as `window.prints`, or what went wrong as `window.failure`.
 */
import { burnEverything } from './fingerprint.mjs';

try {
  const { createSimulation } = await import(new URL('/web/sim.js', location.href).href);
  Object.assign(window, { prints: await burnEverything(createSimulation) });
} catch (error) {
  Object.assign(window, { failure: String(error) });
}
