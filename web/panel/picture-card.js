/**
 * The card that asks how to save a picture: its size and its background. It opens with the last choices.
 */

import { element } from '../element/controls/icon-button.js';
import { openCard } from './cards.js';
import { remember, remembered } from '../editing/memory.js';

/** The sizes: multiples of the width of the picture on the page. */
const SCALES = [1, 2, 3, 4];

/** The backgrounds, by their names in `toBlob`, with their labels. */
const BACKGROUNDS = { scene: 'As it is shown', transparent: 'Transparent', black: 'Black', white: 'White' };

/**
 * Asks for a picture. If `save` fails, the card shows the reason and stays open.
 * @param {{host: HTMLElement, save: (choice: {scale: number, background: string}) => Promise<void>}} what
 * @returns {import('./cards.js').Card}
 */
export function askForPicture({ host, save }) {
  const card = openCard(host, 'picture', 'Save an image');
  const { picture } = remembered();
  const scales = SCALES.map((scale) => [String(scale), scale === 1 ? 'As it is shown' : `${scale} times as wide`]);
  const scale = choice(card, 'scale', 'Size', scales, picture?.scale);
  const background = choice(card, 'background', 'Background', Object.entries(BACKGROUNDS), picture?.background);
  const alert = card.add('p', '');
  alert.setAttribute('role', 'alert');
  const button = card.button('save', 'Save', async () => {
    const chosen = { scale: scale.value, background: background.value };
    remember({ picture: chosen });
    alert.textContent = '';
    button.disabled = true;
    try {
      await save({ ...chosen, scale: Number(chosen.scale) });
      card.close();
    } catch (error) {
      alert.textContent = error instanceof Error ? error.message : String(error);
      button.disabled = false;
    }
  });
  card.button('close', 'Cancel', card.close);
  button.focus({ preventScroll: true });
  return card;
}

/**
 * A labelled list of choices.
 * @param {ReturnType<typeof openCard>} card
 * @param {string} name
 * @param {string} text
 * @param {string[][]} choices  Their names and labels.
 * @param {string} [chosen]
 */
function choice(card, name, text, choices, chosen) {
  const label = card.add('label', `${text} `);
  const select = element('select', { 'data-card': name }, ...choices.map(([value, shown]) => new Option(shown, value)));
  if (choices.some(([value]) => value === chosen)) select.value = /** @type {string} */ (chosen);
  label.append(select);
  return select;
}
