/**
 * The scenes that a visitor has saved, in the local storage of the origin: a name, the settings and a small
 * picture each.
 *
 * @typedef {import('../hearth-fire.js').HearthConfig} HearthConfig
 * @typedef {{name: string, config: HearthConfig, picture: string}} OwnScene  `picture` is a data URL, or empty.
 */

import { saveSettings } from '../editing/download.js';
import { isSettings, settingsOf } from '../editing/exchange.js';
import { presetOf } from '../editing/scene.js';

const KEY = 'hearth-scenes';

/** The most scenes, and the most letters of a name. */
export const MAX_SCENES = 50;
export const MAX_NAME = 40;

/** The size of a picture [px]. */
const PICTURE = { width: 120, height: 160 };

/** The text of the list; empty if the browser forbids storage. */
function stored() {
  try {
    return localStorage.getItem(KEY) ?? '';
  } catch {
    return '';
  }
}

/**
 * The scenes of a list, and whether something else is in it: another script, or a write that broke off.
 * @type {(text: string) => {scenes: OwnScene[], damaged: boolean}}
 */
function read(text) {
  let all;
  try {
    all = JSON.parse(text || '[]');
  } catch {}
  const isScene = (/** @type {any} */ scene) =>
    typeof scene?.name === 'string' && typeof scene.config === 'object' && scene.config !== null;
  const whole = (Array.isArray(all) ? all : []).filter(isScene);
  const scenes = whole.map(({ name, config, picture }) => ({
    name: name.slice(0, MAX_NAME),
    config,
    picture: /^data:image\//.test(picture) ? picture : '',
  }));
  return { scenes, damaged: scenes.length !== all?.length };
}

/** The saved scenes that can be read. */
export function ownScenes() {
  return read(stored()).scenes;
}

/** What is wrong with the list; empty if nothing is. */
export function damageOfScenes() {
  const { scenes, damaged } = read(stored());
  if (!damaged) return '';
  const some = scenes.length === 1 ? 'One scene of it is' : `${scenes.length || 'No'} scenes of it are`;
  return `The list of your scenes is damaged. ${some} readable. The next change keeps the damaged list beside the new one.`;
}

/**
 * Writes the list. A damaged one is kept under a key of its own.
 * @param {OwnScene[]} all
 * @throws {Error} the browser forbids storage, or it is full
 */
function store(all) {
  try {
    const before = stored();
    if (read(before).damaged) {
      let number = 1;
      while (localStorage.getItem(`${KEY}-damaged-${number}`) !== null) number += 1;
      localStorage.setItem(`${KEY}-damaged-${number}`, before);
    }
    localStorage.setItem(KEY, JSON.stringify(all));
  } catch (error) {
    const isFull = error instanceof DOMException && /quota/i.test(error.name);
    throw new Error(
      isFull
        ? 'The storage of this site is full: delete a scene, or download this one.'
        : 'This browser does not let the page store anything: download the scene instead.',
    );
  }
}

/** A name that no scene has yet. @type {(name: string, all: OwnScene[]) => string} */
function unused(name, all) {
  const base = name.trim().slice(0, MAX_NAME) || 'My fire';
  const taken = new Set(all.map((scene) => scene.name));
  for (let number = 1; ; number += 1) {
    const next = number === 1 ? base : `${base.slice(0, MAX_NAME - 4)} ${number}`;
    if (!taken.has(next)) return next;
  }
}

/**
 * Saves a scene and returns its name, which no other has.
 * @type {(name: string, config: HearthConfig, picture: string) => string}
 * @throws {Error} there is no room
 */
export function saveScene(name, config, picture) {
  const all = ownScenes();
  if (all.length >= MAX_SCENES) throw new Error(`${MAX_SCENES} scenes are saved, the maximum. Delete one first.`);
  const saved = { name: unused(name, all), config, picture };
  store([...all, saved]);
  return saved.name;
}

/**
 * Renames a scene and returns its new name.
 * @type {(from: string, to: string) => string}
 * @throws {Error} there is no room
 */
export function renameScene(from, to) {
  const all = ownScenes();
  const name = unused(
    to,
    all.filter((scene) => scene.name !== from),
  );
  store(all.map((scene) => (scene.name === from ? { ...scene, name } : scene)));
  return name;
}

/** Deletes a scene. @param {string} name */
export function deleteScene(name) {
  store(ownScenes().filter((scene) => scene.name !== name));
}

/**
 * A small picture of a fire as a data URL; empty if there is none.
 * @param {{toBlob: (type?: string) => Promise<Blob>}} fire
 */
export async function pictureOf(fire) {
  try {
    const whole = await createImageBitmap(await fire.toBlob());
    const canvas = Object.assign(document.createElement('canvas'), PICTURE);
    const context = canvas.getContext('2d');
    if (!context) return '';
    const scale = Math.max(PICTURE.width / whole.width, PICTURE.height / whole.height);
    const [width, height] = [whole.width * scale, whole.height * scale];
    context.fillRect(0, 0, PICTURE.width, PICTURE.height);
    // The floor is at the lower edge, and the fire in the middle.
    context.drawImage(whole, (PICTURE.width - width) / 2, PICTURE.height - height, width, height);
    whole.close();
    return canvas.toDataURL('image/jpeg', 0.7);
  } catch {
    return '';
  }
}

/**
 * What the card of scenes does with the saved ones.
 * @param {import('../hearth-fire.js').HearthFire} fire
 * @param {(config: HearthConfig | string) => Promise<void>} replace  Shows the fire of settings.
 * @returns {import('./scenes.js').Own}
 */
export function ownScenesOf(fire, replace) {
  return {
    list: ownScenes,
    damage: damageOfScenes,
    rename: renameScene,
    remove: deleteScene,
    choose: ({ config }) => replace(config),
    async save() {
      const config = await fire.exportConfig();
      return saveScene(presetOf(fire)?.label ?? '', config, await pictureOf(fire));
    },
    download: ({ name, config }) => saveSettings({ ...config, label: name }, name),
    open: async (file) => replace(await settingsOf(file)),
  };
}

/**
 * Listens to files that are dropped on `targets`. Settings, and all files on the panel, are opened before any other
 * listener of the page gets them. The page gets any other file first; if no listener takes it, opening it shows a
 * message that rejects it.
 * @param {HTMLElement} host  The element of the panel.
 * @param {EventTarget[]} targets
 * @param {(file: File) => void} open
 * @returns {() => void} stops
 */
export function listenToDrops(host, targets, open) {
  const ended = new AbortController();
  const { signal } = ended;
  const take = (/** @type {DragEvent} */ event, /** @type {File} */ file) => {
    event.preventDefault();
    event.stopPropagation();
    open(file);
  };
  const first = (/** @type {DragEvent} */ event) => {
    const files = [...(event.dataTransfer?.files ?? [])];
    // The canvas of the panel would take any file.
    const file = files.find(isSettings) ?? (event.composedPath().includes(host) ? files[0] : undefined);
    if (file) take(event, file);
  };
  const last = (/** @type {DragEvent} */ event) => {
    const [file] = event.dataTransfer?.files ?? [];
    if (file && !event.defaultPrevented) take(event, file);
  };
  // A browser drops files only where the event is cancelled.
  const over = (/** @type {DragEvent} */ event) => {
    if (event.dataTransfer?.types.includes('Files')) event.preventDefault();
  };
  for (const target of targets) {
    target.addEventListener('dragover', /** @type {EventListener} */ (over), { signal });
    target.addEventListener('drop', /** @type {EventListener} */ (first), { signal, capture: true });
    target.addEventListener('drop', /** @type {EventListener} */ (last), { signal });
  }
  return () => ended.abort();
}
