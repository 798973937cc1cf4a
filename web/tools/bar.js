/**
 * The bar of buttons, with the settings of new solids and the list of objects.
 *
 * @typedef {import('../editing/objects.js').Fields} Fields
 *
 * @typedef {object} BarActions
 * @property {(name: string) => void} tool
 * @property {(id: number | undefined) => void} select
 * @property {(file: Blob) => void} picture
 * @property {() => void} duplicate
 * @property {() => void} remove
 * @property {(front: boolean) => void} order
 * @property {(to: import('./geometry.js').Alignment) => void} align
 * @property {() => void} plots
 * @property {() => void} undo
 * @property {() => void} redo
 * @property {() => void} close
 */

import { element, iconButton } from '../element/controls/icon-button.js';
import { entriesOf, isBody, nameOf } from '../editing/objects.js';
import { SPEAKER } from '../sound/speaker.js';
import { ALIGNMENTS, ARROWS, GROUPS, ICONS, TOOLS, worded } from './table.js';

/** The material of new solids, which burns. */
const FIRST = 'wood';

/** The options of a list of materials, of which one is chosen: wood first. */
export const materialOptions = (chosen = FIRST) =>
  [...(entriesOf('solid').find(({ name }) => name === 'material')?.choices ?? [])]
    .sort((a, b) => Number(b === FIRST) - Number(a === FIRST))
    .map((name) => new Option(name === 'none' ? 'invisible' : name, name, false, name === chosen));

/** The bar of one toolbar. */
export class Bar {
  element = element('div', {
    class: 'hearth-toolbar',
    role: 'toolbar',
    'aria-label': 'Tools',
    'aria-orientation': 'vertical',
  });
  /** Shown while several objects are selected. */
  align = element('div', { class: 'hearth-align', role: 'toolbar', 'aria-label': 'Align', hidden: '' });
  #list = element('select', { 'aria-label': 'Selected object', title: 'Selected object' });
  #material = element('select', { 'aria-label': 'Material of new solids', title: 'Material of new solids' });
  #burns = element('input', { type: 'checkbox', checked: '' });
  /** @type {{[name: string]: HTMLElement}} */
  #groups = {};
  /** @type {Map<string, HTMLButtonElement>} */
  #buttons = new Map();
  /** @type {HTMLButtonElement} */
  #several;
  #names = '';

  /** @param {BarActions} acts */
  constructor(acts) {
    for (const [name, label] of GROUPS) {
      const group = element('div', { class: 'group', role: 'group', 'aria-label': label });
      group.append(element('span', { 'aria-hidden': 'true' }, label));
      this.#groups[name] = group;
      this.element.append(group);
    }
    const file = element('input', { type: 'file', accept: 'image/*', hidden: '' });
    file.addEventListener('change', () => {
      const [first] = file.files ?? [];
      if (first) acts.picture(first);
      // The same file can be chosen again.
      file.value = '';
    });
    const { draw, edit, view } = this.#groups;
    this.#material.append(...materialOptions());
    const burns = element('label', { title: 'New solids burn all around' }, this.#burns, 'on fire');
    this.#list.addEventListener('change', () =>
      acts.select(this.#list.value === '' ? undefined : Number(this.#list.value)),
    );
    draw.append(element('div', { class: 'settings' }, this.#material, burns, file));
    for (const { name, group, key, label, hint, icon } of TOOLS) {
      const shown = key.toUpperCase();
      const press = () => acts.tool(name);
      const button = this.#button(name, `${label} (${shown})`, icon, press, this.#groups[group]);
      button.title = `${label}: ${worded(hint)} (${shown})`;
    }
    this.#button('picture', 'Picture', ICONS.picture, () => file.click(), draw).title =
      'A picture from a file; it may also be dropped or pasted';
    edit.append(element('div', { class: 'settings' }, this.#list));
    this.#several = this.#button(
      'several',
      'Select several',
      ICONS.several,
      () => this.#setSeveral(!this.several),
      edit,
    );
    this.#several.title = 'Select several: each click adds an object, as with Shift';
    this.#setSeveral(false);
    this.#button('duplicate', 'Duplicate (Ctrl D)', ICONS.duplicate, acts.duplicate, edit);
    this.#button('remove', 'Delete (Delete)', ICONS.remove, acts.remove, edit);
    this.#button('back', 'To back', ICONS.back, () => acts.order(false), edit).title =
      'Draw the solid behind the others';
    this.#button('front', 'To front', ICONS.front, () => acts.order(true), edit).title =
      'Draw the solid before the others';
    this.#button('plots', 'Plots (G)', ICONS.plots, acts.plots, view);
    this.mark('plots', false);
    this.speaker = this.#button('speaker', 'Sound', SPEAKER, () => {}, view);
    this.speaker.title = 'Sound on or off (M)';
    this.#button('undo', 'Undo (Ctrl Z)', ICONS.undo, acts.undo, view);
    this.#button('redo', 'Redo (Ctrl Y)', ICONS.redo, acts.redo, view);
    this.#button('close', 'Close the tools', ICONS.close, acts.close, view);
    for (const [to, icon] of ALIGNMENTS)
      this.#button(`align-${to}`, `Align: ${to}`, icon, () => acts.align(to), this.align);
  }

  /** The material of new solids. */
  get material() {
    return this.#material.value;
  }

  /** Whether new solids burn. */
  get burns() {
    return this.#burns.checked;
  }

  /** Whether each click adds an object to the selection. */
  get several() {
    return this.#several.getAttribute('aria-pressed') === 'true';
  }

  /** @param {boolean} on */
  #setSeveral(on) {
    this.#several.setAttribute('aria-pressed', String(on));
  }

  /** @type {(name: string, label: string, icon: string, act: () => void, bar: HTMLElement) => HTMLButtonElement} */
  #button(name, label, icon, act, bar) {
    const button = iconButton(icon, { 'aria-label': label, title: label, 'data-tool': name });
    button.addEventListener('click', act);
    bar.append(button);
    const [first] = this.#barOf(button).querySelectorAll('button');
    button.tabIndex = first === button ? 0 : -1;
    this.#buttons.set(name, button);
    return button;
  }

  /** Marks a tool. @param {string} name */
  choose(name) {
    for (const { name: other } of TOOLS) this.mark(other, other === name);
  }

  /** Marks a button as pressed. @type {(name: string, on: boolean) => void} */
  mark(name, on) {
    this.#buttons.get(name)?.setAttribute('aria-pressed', String(on));
  }

  /**
   * Shows the objects, the selected ones, and what can be done.
   * @type {(all: Fields[], selected: Fields[], history: {canUndo: boolean, canRedo: boolean}) => void}
   */
  show(all, selected, { canUndo, canRedo }) {
    const [first, ...more] = selected;
    const none = more.length > 0 ? `${selected.length} selected` : 'no object';
    const names = [none, ...all.map((object) => `${object.id}:${nameOf(object)}`)].join();
    if (this.#names !== names) {
      this.#names = names;
      this.#list.replaceChildren(
        new Option(none, ''),
        ...all.map((object) => new Option(nameOf(object), String(object.id))),
      );
    }
    this.#list.value = first && more.length === 0 ? String(first.id) : '';
    this.align.hidden = more.length === 0;
    const solid = selected.some(isBody);
    for (const [name, works] of Object.entries({
      undo: canUndo,
      redo: canRedo,
      duplicate: first,
      remove: first,
      back: solid,
      front: solid,
    })) {
      this.#buttons.get(name)?.setAttribute('aria-disabled', String(!works));
    }
  }

  /** The bar that a button is in. @param {HTMLElement} button */
  #barOf(button) {
    return this.align.contains(button) ? this.align : this.element;
  }

  /**
   * Arrow keys lead through the buttons as they are on the screen; the Tab key reaches one of them.
   * @type {(button: HTMLElement, key: string) => boolean}
   */
  rove(button, key) {
    const orderOf = (/** @type {Element} */ shown) => Number(getComputedStyle(shown).order);
    const all = /** @type {HTMLButtonElement[]} */ ([...this.#barOf(button).querySelectorAll('button')]).sort(
      (a, b) => orderOf(a) - orderOf(b),
    );
    const at = all.indexOf(/** @type {HTMLButtonElement} */ (button));
    const [right, up] = ARROWS[key] ?? [0, 0];
    const to = { Home: 0, End: all.length - 1 }[key] ?? (at + right - up + all.length) % all.length;
    if (at < 0 || to === at) return false;
    for (const other of all) other.tabIndex = -1;
    all[to].tabIndex = 0;
    all[to].focus();
    return true;
  }
}
