/**
 * The strip of scenes: a small picture each, at the edge of the fire. Choosing one
 * starts the fire from that scene.
 */

import { PRESETS } from '../parameters.js';

/**
 * Shows the strip.
 * @param {HTMLElement} place
 * @param {import('../hearth-fire.js').HearthFire} fire
 * @param {string} first  The scene that stands first.
 * @param {(words: string) => void} say  Tells the visitor what went wrong.
 */
export function showStrip(place, fire, first, say) {
  const scenes = [...PRESETS].sort((a, b) => Number(b.name === first) - Number(a.name === first));
  const list = document.createElement('div');
  list.className = 'tiles';
  list.setAttribute('role', 'toolbar');
  list.setAttribute('aria-label', 'Scenes');
  const caption = document.createElement('p');
  caption.setAttribute('aria-hidden', 'true');

  const tiles = scenes.map(({ name, label, description }) => {
    const tile = document.createElement('button');
    tile.type = 'button';
    tile.tabIndex = -1;
    tile.dataset.starts = name;
    tile.setAttribute('aria-label', label);
    tile.title = description;
    const image = document.createElement('img');
    Object.assign(image, { alt: '', width: 120, height: 160, loading: 'lazy', decoding: 'async', draggable: false });
    image.addEventListener('error', () => image.remove());
    image.src = new URL(`../scenes/${name}.jpg`, import.meta.url).href;
    tile.append(image);
    tile.addEventListener('click', () => {
      fire.importConfig({ hearth: 1, preset: name, values: {} }).then(mark, (/** @type {Error} */ error) => say(error.message));
    });
    tile.addEventListener('focus', () => reach(tile));
    tile.addEventListener('pointerenter', () => tell(label));
    tile.addEventListener('pointerleave', () => tell(''));
    tile.addEventListener('blur', () => tell(''));
    return tile;
  });
  let reached = tiles[0];
  const tell = (/** @type {string} */ words) => {
    caption.textContent = words;
  };

  /** The Tab key stops once in the strip; arrow keys go on from there. @param {HTMLButtonElement} tile */
  const reach = (tile) => {
    reached.tabIndex = -1;
    reached = tile;
    reached.tabIndex = 0;
    tell(tile.getAttribute('aria-label') ?? '');
  };
  list.addEventListener('keydown', (event) => {
    const { key, ctrlKey, altKey, metaKey } = event;
    if (ctrlKey || altKey || metaKey) return;
    const at = tiles.indexOf(reached);
    const next = tiles[{ ArrowLeft: at - 1, ArrowUp: at - 1, ArrowRight: at + 1, ArrowDown: at + 1, Home: 0, End: tiles.length - 1 }[key] ?? -1];
    if (!next) return;
    event.preventDefault();
    next.focus();
  });
  // A wheel that turns up and down pushes a strip that lies.
  list.addEventListener('wheel', (event) => {
    if (event.ctrlKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) return;
    list.scrollBy({ left: event.deltaY, behavior: 'instant' });
  }, { passive: true });

  const mark = () => {
    for (const tile of tiles) {
      if (tile.dataset.starts === fire.preset) tile.setAttribute('aria-current', 'true');
      else tile.removeAttribute('aria-current');
    }
  };
  fire.addEventListener('params-change', mark);
  mark();
  reach(tiles.find((tile) => tile.hasAttribute('aria-current')) ?? tiles[0]);
  tell('');
  list.append(...tiles);
  place.append(caption, list);
  place.hidden = false;
  reached.scrollIntoView({ block: 'nearest', inline: 'nearest' });
}
