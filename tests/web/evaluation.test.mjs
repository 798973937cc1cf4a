/**
 * The tables of `docs/evaluation.md` that a command fills row by row: none lacks a row.
 */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { PRESETS } from '../../web/parameters.js';

test('each preset has its row in the table of appearances, and nothing but scenes of the community has another', () => {
  const text = readFileSync(new URL('../../docs/evaluation.md', import.meta.url), 'utf8');
  const [, section = ''] = /<!-- looked: begin -->([\s\S]*?)<!-- looked: end -->/.exec(text) ?? [];
  const [, , , ...rows] = section.split('\n').filter((line) => line.startsWith('|'));
  const scenes = PRESETS.map(({ name }) => name);
  assert.deepEqual(
    rows.map((row) => row.split(' ')[1]).filter((name) => !name.startsWith('community/')),
    scenes,
    'run `cargo measure look NAME` for what is missing',
  );
});
