/**
 * The keys of shortcuts on keyboards of several languages.
 */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { historyKey, keyOf } from '../../web/editing/keys.js';
import { zoomKey } from '../../web/panel/zoom-keys.js';

test('a key that types no Latin letter is that of its place, and another one is what it types', () => {
  for (const [layout, key, code, expected] of [
    ['Russian', 'я', 'KeyZ', 'z'],
    ['Russian', 'Я', 'KeyZ', 'z'],
    ['Russian', 'х', 'BracketLeft', '['],
    ['Russian', '.', 'Slash', '.'],
    ['Greek', 'ζ', 'KeyZ', 'z'],
    ['Hebrew', 'ז', 'KeyZ', 'z'],
    ['Hebrew', "'", 'KeyW', 'w'],
    ['Arabic', 'لا', 'KeyB', 'b'],
    ['Arabic', '٢', 'Digit2', '2'],
    ['Thai', 'ี', 'KeyU', 'u'],
    ['Korean', 'ㅋ', 'KeyZ', 'z'],
    ['QWERTZ', 'z', 'KeyY', 'z'],
    ['QWERTZ', 'ü', 'BracketLeft', 'ü'],
    ['AZERTY', 'M', 'Semicolon', 'm'],
    ['AZERTY', ',', 'KeyM', ','],
    ['AZERTY', 'é', 'Digit2', 'é'],
    ['Dvorak', ';', 'KeyZ', ';'],
    ['Dvorak', "'", 'KeyQ', "'"],
    ['Dvorak', 'z', 'Slash', 'z'],
    ['any', 'ArrowLeft', 'ArrowLeft', 'ArrowLeft'],
    ['any', 'Enter', 'NumpadEnter', 'Enter'],
    ['a script', 'R', undefined, 'r'],
    ['a script', 'я', undefined, 'я'],
  ])
    assert.equal(keyOf({ key, code }), expected, `${layout}: ${key}`);
});

test('undo, redo and zoom have their keys on each of them', () => {
  const press = (key, code, more = {}) => /** @type {any} */ ({ key, code, ctrlKey: true, ...more });
  assert.equal(historyKey(press('я', 'KeyZ')), 'undo');
  assert.equal(historyKey(press('Я', 'KeyZ', { shiftKey: true })), 'redo');
  assert.equal(historyKey(press('ط', 'KeyY')), 'redo');
  assert.equal(historyKey(press('y', 'KeyZ')), 'redo');
  const removed = [];
  const fire = /** @type {any} */ ({ zoom: 2, removeAttribute: (name) => removed.push(name) });
  zoomKey(fire, press('٠', 'Digit0'))?.();
  assert.deepEqual(removed, ['zoom', 'pan']);
});
