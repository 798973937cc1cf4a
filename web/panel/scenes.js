/**
 * The scenes to start from, as a card of pictures: each is a button, and the current one is marked. The
 * card stays open, so that a visitor can try one scene after another.
 *
 * @typedef {{name: string, label: string, description?: string}} Scene
 */

import { openCard } from './cards.js';

/**
 * @param {object} parts
 * @param {HTMLElement} parts.host
 * @param {Scene[]} parts.scenes
 * @param {(name: string) => URL | undefined} parts.pictureOf  Where its picture is; where
 *   nobody knows, and where none comes, its words do.
 * @param {() => string} parts.present  The name of the present one.
 * @param {(name: string) => void} parts.choose
 * @returns {import('./cards.js').Card & {mark: () => void}}
 */
export function showScenes({ host, scenes, pictureOf, present, choose }) {
  const card = openCard(host, 'scenes', 'Scenes');
  const list = card.add('div', '');
  list.className = 'hearth-scenes';
  // Buttons that arrows lead to; none of them is pressed by that.
  list.setAttribute('role', 'toolbar');
  list.setAttribute('aria-label', 'Scenes');
  const about = card.add('p', '');
  about.className = 'hearth-scenes-about';
  // Each picture has these words as its own.
  about.setAttribute('aria-hidden', 'true');
  const tell = (/** @type {Scene | undefined} */ scene) => {
    about.textContent = scene?.description ?? '';
  };

  const tiles = scenes.map((scene) => {
    const tile = makeTile(scene, pictureOf(scene.name));
    tile.addEventListener('click', () => choose(scene.name));
    tile.addEventListener('focus', () => reach(tile));
    tile.addEventListener('pointerenter', () => tell(scene));
    tile.addEventListener('pointerleave', () => tell(sceneOf(reached)));
    list.append(tile);
    return tile;
  });
  let reached = tiles[0];
  const sceneOf = (/** @type {HTMLElement} */ tile) => scenes[tiles.indexOf(/** @type {HTMLButtonElement} */ (tile))];

  /** The Tab key stops once in the list; arrows go on from there. @param {HTMLButtonElement} tile */
  const reach = (tile) => {
    reached.tabIndex = -1;
    reached = tile;
    reached.tabIndex = 0;
    tell(sceneOf(tile));
  };
  list.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const next = tiles[stepFrom(tiles, tiles.indexOf(reached), event.key)];
    if (!next) return;
    event.preventDefault();
    next.focus();
  });

  const mark = () => {
    const name = present();
    scenes.forEach((scene, at) => {
      if (scene.name === name) tiles[at].setAttribute('aria-current', 'true');
      else tiles[at].removeAttribute('aria-current');
    });
  };
  mark();
  card.button('close', 'Close', card.close);
  const first = tiles.find((tile) => tile.hasAttribute('aria-current')) ?? tiles[0];
  reach(first);
  first.focus({ preventScroll: true });
  // In the list alone: the page stays where it is.
  list.scrollTo(
    first.offsetLeft - (list.clientWidth - first.offsetWidth) / 2,
    first.offsetTop - (list.clientHeight - first.offsetHeight) / 2,
  );
  return { ...card, mark };
}

/** @type {(scene: Scene, picture: URL | undefined) => HTMLButtonElement} */
function makeTile({ name, label, description = '' }, picture) {
  const tile = document.createElement('button');
  tile.type = 'button';
  tile.className = 'hearth-scene';
  tile.dataset.scene = name;
  tile.tabIndex = -1;
  const words = document.createElement('span');
  words.textContent = label;
  tile.append(words);
  const image = document.createElement('img');
  image.alt = description;
  image.width = 120;
  image.height = 160;
  image.loading = 'lazy';
  image.decoding = 'async';
  image.draggable = false;
  image.addEventListener('error', () => tile.classList.add('bare'));
  if (picture) image.src = picture.href;
  else tile.classList.add('bare');
  const ground = document.createElement('i');
  ground.append(image);
  tile.append(ground);
  return tile;
}

/**
 * Where a key leads from one of the tiles, which stand in rows; nowhere for other keys.
 * @type {(tiles: HTMLElement[], at: number, key: string) => number}
 */
function stepFrom(tiles, at, key) {
  const row = tiles.filter(({ offsetTop }) => offsetTop === tiles[0].offsetTop).length;
  /** @type {{[key: string]: number}} */
  const steps = { ArrowLeft: -1, ArrowRight: 1, ArrowUp: -row, ArrowDown: row };
  if (key === 'Home') return 0;
  if (key === 'End') return tiles.length - 1;
  return Object.hasOwn(steps, key) ? at + steps[key] : -1;
}
