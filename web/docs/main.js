/** A page of the site: a search; of the documentation, contents that are open beside the text, and examples that burn. */

import { runExamples } from './examples.js';
import { search } from './search.js';

const contents = /** @type {HTMLDetailsElement | null} */ (document.querySelector('#contents details'));
// The width at which the style sheet puts them beside the text.
if (contents) contents.open = matchMedia('(min-width: 60rem)').matches;

const form = /** @type {HTMLFormElement} */ (document.querySelector('form[role="search"]'));
const field = /** @type {HTMLInputElement} */ (form.querySelector('input'));
const found = /** @type {HTMLElement} */ (document.getElementById('found'));
search(form, field, found);
runExamples(document);

const cards = document.querySelectorAll('[data-card]');
if (cards.length > 0)
  import('./cards.js').then(({ showCards }) => showCards(/** @type {NodeListOf<HTMLElement>} */ (cards)));
