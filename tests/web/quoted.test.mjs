/** Texts of others in messages: short, and without characters that act. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { cut, listed } from '../../web/quoted.js';

test('a quoted text is short, has whole letters, and shows the characters that would act', () => {
  assert.equal(cut('Feuer ☃'), 'Feuer ☃');
  assert.equal(cut(`${'x'.repeat(39)}🔥🔥`), `${'x'.repeat(39)}…`);
  assert.equal(cut('a\u202eb\u0007\u001b]52;\u200d\0'), 'a\\u202eb\\u0007\\u001b]52;\\u200d\\u0000');
  for (let code = 0; code < 0x3000; code += 1) {
    const letter = String.fromCharCode(code);
    assert.doesNotMatch(
      cut(letter.repeat(50)),
      /[\p{Cc}\p{Bidi_Control}\u200b\u2060\ufeff\u2028\u2029]/u,
      code.toString(16),
    );
  }
});

test('a list of many names is short and counts the names that it leaves out', () => {
  assert.equal(listed(['wind', 'seed']), 'wind, seed');
  const names = Array.from({ length: 100 }, (_, at) => `parameter${at}`);
  assert.match(listed(names), /^parameter0, .{20,160} and \d+ more$/);
  const [, shown, more] = listed(names).match(/^(.*) and (\d+) more$/) ?? [];
  assert.equal(shown.split(', ').length + Number(more), 100);
});
