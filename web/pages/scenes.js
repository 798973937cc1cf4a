/**
 * The strip of scenes at the edge of the fire: a button with a small picture for each. A scene replaces
 * all values of the fire.
 */

import { PRESETS } from '../parameters.js';

/**
 * Shows the strip.
 * @param {HTMLElement} parent
 * @param {import('../hearth-fire.js').HearthFire} fire
 * @param {string} first  The name of the first scene.
 * @param {(message: string) => void} warn  Shows an error to the visitor.
 */
export function showStrip(parent, fire, first, warn) {
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
      // A scene may take seconds to begin, which its picture shows.
      tile.setAttribute('aria-busy', 'true');
      fire
        .importConfig({ hearth: 3, preset: name, values: {} })
        .then(() => shownSoon(fire))
        .then(mark, (/** @type {Error} */ error) => warn(error.message))
        .finally(() => tile.removeAttribute('aria-busy'));
    });
    tile.addEventListener('focus', () => focus(tile));
    tile.addEventListener('pointerenter', () => describe(tile));
    tile.addEventListener('pointerleave', () => describe(undefined));
    tile.addEventListener('blur', () => describe(undefined));
    return tile;
  });
  let focused = tiles[0];
  /** The tile whose name stands beside it. @type {HTMLButtonElement | undefined} */
  let named;
  const place = () => {
    if (named)
      caption.style.top = `${named.offsetTop - list.scrollTop + (named.offsetHeight - caption.offsetHeight) / 2}px`;
  };
  const describe = (/** @type {HTMLButtonElement | undefined} */ tile) => {
    named = tile;
    caption.textContent = tile?.getAttribute('aria-label') ?? '';
    place();
  };
  list.addEventListener('scroll', place, { passive: true });

  /** A roving tab index: the Tab key stops once in the strip. @param {HTMLButtonElement} tile */
  const focus = (tile) => {
    focused.tabIndex = -1;
    focused = tile;
    focused.tabIndex = 0;
    describe(tile);
  };
  list.addEventListener('keydown', (event) => {
    const { key, ctrlKey, altKey, metaKey } = event;
    if (ctrlKey || altKey || metaKey) return;
    const at = tiles.indexOf(focused);
    const next =
      tiles[
        { ArrowLeft: at - 1, ArrowUp: at - 1, ArrowRight: at + 1, ArrowDown: at + 1, Home: 0, End: tiles.length - 1 }[
          key
        ] ?? -1
      ];
    if (!next) return;
    event.preventDefault();
    next.focus();
  });

  const mark = () => {
    for (const tile of tiles) {
      if (tile.dataset.starts === fire.preset) tile.setAttribute('aria-current', 'true');
      else tile.removeAttribute('aria-current');
    }
  };
  fire.addEventListener('params-change', mark);
  mark();
  focus(tiles.find((tile) => tile.hasAttribute('aria-current')) ?? tiles[0]);
  describe(undefined);
  list.append(...tiles);
  parent.append(caption, list);
  parent.hidden = false;
  focused.scrollIntoView({ block: 'nearest', inline: 'nearest' });
}

/** Resolves when the fire has measured its new scene. @param {import('../hearth-fire.js').HearthFire} fire */
function shownSoon(fire) {
  if (fire.paused) return undefined;
  return new Promise((resolve) => {
    fire.addEventListener('stats', resolve, { once: true });
  });
}
