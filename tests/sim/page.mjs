/**
 * Runs the library on a page, and stores the fingerprints as `window.prints`, or the error as
 * `window.failure`.
 */
import { burnEverything } from './fingerprint.mjs';

try {
  const { createSimulation } = await import(new URL('/web/sim.js', location.href).href);
  Object.assign(window, { prints: await burnEverything(createSimulation) });
} catch (error) {
  Object.assign(window, { failure: String(error) });
}
