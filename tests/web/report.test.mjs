/** The report of a fire that a visitor copies into an issue. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Report } from '../../web/panel/report.js';

test('a report has version, link, settings and the last errors', () => {
  class Fire extends EventTarget {
    static version = '1.2.3';
    params = { seed: 7 };
    objects = [];
    stats = null;
    quality = 'auto';
  }
  const scope = { screen: { width: 1, height: 1 }, devicePixelRatio: 1, navigator: { hardwareConcurrency: 2 } };
  for (const [name, value] of Object.entries(scope)) Object.defineProperty(globalThis, name, { value });
  const fire = new Fire();
  const report = new Report(/** @type {any} */ (fire));
  const fail = (/** @type {number} */ at) =>
    fire.dispatchEvent(new CustomEvent('error', { detail: { kind: 'load', message: `error ${at}` } }));
  for (let at = 1; at <= 12; at += 1) fail(at);
  const config = /** @type {any} */ ({ hearth: 3, values: { wind: 1 } });
  const lines = report.text('https://a.example/?wind=1', config).split('\n');
  assert.equal(lines[0], 'Hearth 1.2.3');
  for (const line of ['Link: https://a.example/?wind=1', 'Seed: 7', `Settings: ${JSON.stringify(config)}`])
    assert.ok(lines.includes(line), line);
  const errors = lines.slice(lines.indexOf('Errors:') + 1).map((line) => line.slice(25));
  assert.deepEqual(
    errors,
    Array.from({ length: 10 }, (_, at) => `load: error ${at + 3}`),
  );
  report.close();
  fail(13);
  assert.doesNotMatch(report.text(undefined, undefined), /error 13/);
});
