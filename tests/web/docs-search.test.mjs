/** The search of the documentation. The file that it reads is tested in `pages` of `xtask`. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { sectionsWith, wordsOf } from '../../web/docs/search.js';

/** @type {import('../../web/docs/search.js').Page[]} */
const PAGES = [
  {
    name: 'physics',
    title: 'The physics',
    sections: [
      ['the-physics', 'The physics', 'Air moves. Wind is a force, and a rewind is none.'],
      ['wind', 'Wind', 'It blows.'],
      ['windows', 'Panes', 'Windows and windmills in the wind.'],
    ],
  },
  { name: 'sound', title: 'Sound', sections: [['sound', 'Sound', 'A fire roars in WIND: ½ (a+b).']] },
];

const found = (/** @type {string} */ query) => sectionsWith(PAGES, wordsOf(query)).map(({ address }) => address);

test('every section with all words is found, in any case, and no other', () => {
  assert.equal(found('wind').length, 4);
  assert.deepEqual(found('WIND  blows'), ['physics.html#wind']);
  assert.deepEqual(found('wind roars'), ['sound.html#sound']);
  assert.deepEqual(found('nothing'), []);
  assert.deepEqual(found('(a+b).'), ['sound.html#sound'], 'no word is a pattern');
});

test('a heading comes before a text, and a word that begins so before one that contains it', () => {
  assert.equal(found('wind')[0], 'physics.html#wind');
  assert.equal(found('mills').length, 1);
  const of = (/** @type {string} */ text) => ({ name: text, title: '', sections: [['', '', text]] });
  const [first] = sectionsWith(/** @type {any} */ ([of('rewind'), of('wind')]), ['wind']);
  assert.equal(first.text, 'wind');
});

test('a query without a word has no words', () => assert.deepEqual(wordsOf(' \n\t '), []));
