/**
 * The card of scenes: a button with a picture for each, the current one marked. The card stays open, so
 * that a visitor can try one scene after another.
 *
 * @typedef {{name: string, label: string, description?: string}} Scene
 *
 * @typedef {object} Own  The commands of the visitor's own scenes.
 * @property {() => import('./own-scenes.js').OwnScene[]} list
 * @property {() => string} damage  What is wrong with the list; empty if nothing is.
 * @property {() => Promise<string>} save  Saves the current fire; returns its name.
 * @property {(scene: import('./own-scenes.js').OwnScene) => Promise<void>} choose
 * @property {(from: string, to: string) => string} rename  Returns the new name.
 * @property {(scene: import('./own-scenes.js').OwnScene) => void} download
 * @property {(name: string) => void} remove
 * @property {(file: Blob) => Promise<void>} open  Shows the fire of a file.
 */

import { element } from '../element/controls/icon-button.js';
import { openCard } from './cards.js';
import { MAX_NAME } from './own-scenes.js';

/**
 * @param {object} options
 * @param {HTMLElement} options.host
 * @param {Scene[]} options.scenes
 * @param {(name: string) => URL | undefined} options.pictureOf  The URL of its picture. Without one, and if it
 *   does not load, the tile shows the label alone.
 * @param {() => string} options.current  The name of the current scene.
 * @param {(name: string) => void} options.choose
 * @param {Own} options.own
 * @returns {import('./cards.js').Card & {mark: () => void}}
 */
export function showScenes({ host, scenes, pictureOf, current, choose, own }) {
  const card = openCard(host, 'scenes', 'Scenes');
  const list = card.add('div', '');
  list.className = 'hearth-scenes';
  // Arrow keys move the focus and press nothing.
  list.setAttribute('role', 'toolbar');
  list.setAttribute('aria-label', 'Scenes');
  const about = card.add('p', '');
  about.className = 'hearth-scenes-about';
  // Each picture has the description as its alternative text.
  about.setAttribute('aria-hidden', 'true');
  const describe = (/** @type {Scene | undefined} */ scene) => {
    about.textContent = scene?.description ?? '';
  };

  const tiles = scenes.map((scene) => {
    const tile = makeTile(scene, pictureOf(scene.name));
    tile.addEventListener('click', () => choose(scene.name));
    tile.addEventListener('focus', () => focus(tile));
    tile.addEventListener('pointerenter', () => describe(scene));
    tile.addEventListener('pointerleave', () => describe(sceneOf(focused)));
    list.append(tile);
    return tile;
  });
  let focused = tiles[0];
  const sceneOf = (/** @type {HTMLElement} */ tile) => scenes[tiles.indexOf(/** @type {HTMLButtonElement} */ (tile))];

  /** A roving tab index: the Tab key stops once in the list. @param {HTMLButtonElement} tile */
  const focus = (tile) => {
    focused.tabIndex = -1;
    focused = tile;
    focused.tabIndex = 0;
    describe(sceneOf(tile));
  };
  list.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const next = tiles[stepFrom(tiles, tiles.indexOf(focused), event.key)];
    if (!next) return;
    event.preventDefault();
    next.focus();
  });

  const mark = () => {
    const name = current();
    scenes.forEach((scene, at) => {
      if (scene.name === name) tiles[at].setAttribute('aria-current', 'true');
      else tiles[at].removeAttribute('aria-current');
    });
  };
  mark();
  const showOwn = ownSection(card, own);
  const save = async () => {
    const name = rowOf(card.content, await showOwn(own.save))?.querySelector('input');
    name?.focus();
    name?.select();
  };
  card.button('save', 'Save', save).title = 'Save this fire in the browser';
  card.button('open', 'Open', () => chooseFile((file) => showOwn(() => own.open(file)))).title =
    'Show the fire of a file';
  card.button('close', 'Close', card.close);
  const first = tiles.find((tile) => tile.hasAttribute('aria-current')) ?? tiles[0];
  focus(first);
  first.focus({ preventScroll: true });
  // `scrollIntoView` would scroll the page as well.
  list.scrollTo(
    first.offsetLeft - (list.clientWidth - first.offsetWidth) / 2,
    first.offsetTop - (list.clientHeight - first.offsetHeight) / 2,
  );
  return { ...card, mark };
}

/**
 * The visitor's scenes: a row for each, with its picture, its name as a field, and buttons.
 * @param {ReturnType<typeof openCard>} card
 * @param {Own} own
 * @returns {(act: () => unknown) => Promise<any>}  Runs a command, then shows the rows again, or the reason of a
 *   refusal; returns what the command returns.
 */
function ownSection(card, own) {
  const rows = card.add('ul', '');
  rows.className = 'hearth-own';
  rows.setAttribute('aria-label', 'Your scenes');
  const alert = card.add('p', '');
  alert.setAttribute('role', 'alert');
  const act = async (/** @type {() => unknown} */ what) => {
    alert.textContent = own.damage();
    /** @type {any} */
    let result;
    try {
      result = await what();
      alert.textContent = '';
    } catch (error) {
      alert.textContent = error instanceof Error ? error.message : String(error);
    }
    show();
    return result;
  };
  let shown = '';
  const show = () => {
    const all = own.list();
    // Rows that are replaced lose the focus and a press that is under way.
    const listed = JSON.stringify(all);
    if (listed === shown) return;
    shown = listed;
    rows.hidden = all.length === 0;
    rows.replaceChildren(
      ...all.map((scene) => {
        const image = element('img', { alt: '', width: '30', height: '40', src: scene.picture });
        image.hidden = !scene.picture;
        const labelled = { type: 'button', 'data-own': scene.name, 'aria-label': `Show ${scene.name}` };
        const start = element('button', labelled, image);
        start.addEventListener('click', () => act(() => own.choose(scene)));
        const name = element('input', {
          value: scene.name,
          maxlength: String(MAX_NAME),
          spellcheck: 'false',
          'aria-label': `Name of ${scene.name}`,
        });
        let entered = false;
        name.addEventListener('keydown', ({ key }) => (entered = key === 'Enter'));
        name.addEventListener('change', async () => {
          const renamed = await act(() => own.rename(scene.name, name.value));
          name.value = scene.name;
          // The row is another one now. Without the focus, the next letters would be shortcuts.
          if (entered) rowOf(rows, renamed)?.querySelector('button')?.focus({ preventScroll: true });
        });
        /** @type {(label: string, sign: string, action: () => unknown) => HTMLButtonElement} */
        const button = (label, sign, action) => {
          const node = element(
            'button',
            { type: 'button', title: label, 'aria-label': `${label} ${scene.name}` },
            sign,
          );
          node.addEventListener('click', () => act(action));
          return node;
        };
        const [download, remove] = [
          button('Download', '⤓', () => own.download(scene)),
          button('Delete', '✕', () => own.remove(scene.name)),
        ];
        return element('li', {}, start, name, download, remove);
      }),
    );
  };
  show();
  alert.textContent = own.damage();
  return act;
}

/** The row of a scene. @type {(rows: ParentNode, name: string) => Element | undefined} */
function rowOf(rows, name) {
  return [...rows.querySelectorAll('li')].find((row) => row.querySelector('input')?.value === name);
}

/** Lets the visitor choose a file of settings. @param {(file: Blob) => void} use */
function chooseFile(use) {
  const input = element('input', { type: 'file', accept: '.json,application/json' });
  input.addEventListener('change', () => {
    const [file] = input.files ?? [];
    if (file) use(file);
  });
  input.click();
}

/** @type {(scene: Scene, picture: URL | undefined) => HTMLButtonElement} */
function makeTile({ name, label, description = '' }, picture) {
  const size = { width: '120', height: '160' };
  const image = element('img', { alt: description, ...size, loading: 'lazy', decoding: 'async', draggable: 'false' });
  const tile = element(
    'button',
    { type: 'button', class: 'hearth-scene', 'data-scene': name, tabindex: '-1' },
    element('span', {}, label),
    element('i', {}, image),
  );
  image.addEventListener('error', () => tile.classList.add('bare'));
  if (picture) image.src = picture.href;
  else tile.classList.add('bare');
  return tile;
}

/**
 * The tile that a key leads to, in rows; -1 for other keys.
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
