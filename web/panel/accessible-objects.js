/**
 * The objects among the accessible controls: buttons to add, duplicate, delete and order, and to act on the fire at
 * one, a list to select one, and a control for each property of the selected object.
 *
 * The properties of the first source are parameters, whose controls stand in their own groups.
 */

import { element } from '../element/controls/icon-button.js';
import { ACTS } from '../editing/acts.js';
import {
  KINDS,
  entriesOf,
  isBody,
  isFirstSource,
  isFull,
  isSame,
  nameOf,
  objectsOf,
  sliderDomain,
} from '../editing/objects.js';
import { makeControl, noteConditions } from './native-controls.js';
import { MAX_OBJECTS } from '../generated/scene-objects.js';

/** The group, and its name for the panel. */
export const OBJECTS = 'Objects';

/**
 * @typedef {object} AccessibleObjects
 * @property {() => void} show  Shows the present objects.
 */

/**
 * @param {object} options
 * @param {HTMLElement} options.root
 * @param {import('../hearth-fire.js').HearthFire} options.fire
 * @param {import('./controller.js').PanelController} options.controller
 * @param {(id: string) => void} options.reveal
 * @param {(action: string, text: string, press: () => unknown, parent: HTMLElement) => HTMLButtonElement}
 *   options.addButton
 * @param {Map<string, HTMLElement>} options.counterparts  The controls by the names of their counterparts on the panel.
 * @returns {AccessibleObjects}
 */
export function mountAccessibleObjects({ root, fire, controller, reveal, addButton, counterparts }) {
  const group = element('fieldset', { name: OBJECTS }, element('legend', {}, OBJECTS));
  root.append(group);

  const revealGroup = (/** @type {HTMLElement} */ control) => control.addEventListener('focus', () => reveal(OBJECTS));
  /** A disabled button would lose the focus. @type {{button: HTMLButtonElement, isOn: () => boolean}[]} */
  const buttons = [];
  /** @type {(action: string, text: string, isOn: () => boolean, press: () => unknown) => void} */
  const add = (action, text, isOn, press) => {
    const button = addButton(action, text, () => (isOn() ? press() : undefined), group);
    revealGroup(button);
    buttons.push({ button, isOn });
  };
  for (const kind of KINDS)
    add(
      `add:${kind}`,
      `Add ${kind}`,
      () => !isFull(fire, kind),
      () => controller.add(kind),
    );
  add(
    'duplicate',
    'Duplicate',
    () => {
      const object = controller.selected;
      return object !== undefined && !isFull(fire, object.kind);
    },
    () => controller.selected && controller.duplicate(controller.selected.id),
  );
  add(
    'delete',
    'Delete',
    () => controller.selected !== undefined,
    () => controller.selected && controller.remove(controller.selected.id),
  );
  for (const [end, front] of /** @type {[string, boolean][]} */ ([
    ['back', false],
    ['front', true],
  ])) {
    add(
      `to:${end}`,
      `To ${end}`,
      () => isBody(controller.selected ?? {}),
      () => controller.selected && controller.order(controller.selected.id, front),
    );
  }
  for (const { name, label } of ACTS) {
    add(
      name,
      label,
      () => controller.selected !== undefined,
      () => controller.selected && controller.act(name, controller.selected.id),
    );
  }

  const selection = makeControl({ label: 'Selected object', kind: 'choice', unit: '' }, (value) => {
    controller.select(value === '' ? undefined : Number(value));
  });
  const select = /** @type {HTMLSelectElement} */ (selection.control);
  select.dataset.action = 'select-object';
  revealGroup(select);
  counterparts.set('objects', select);
  group.append(selection.row);

  const rows = KINDS.flatMap((kind) => entriesOf(kind).map((entry) => addRow(kind, entry)));

  /** @type {(kind: import('../editing/objects.js').Kind, entry: import('../editing/objects.js').Entry) => () => void} */
  function addRow(kind, entry) {
    const { name } = entry;
    const key = `${kind}:${name}`;
    const { row, control, note, show } = makeControl(entry, (value) => {
      const object = controller.selected;
      // The element's error event reports a refusal.
      if (object)
        controller
          .change(object.id, name, value)
          .catch(() => {})
          .finally(update);
    });
    control.dataset.property = key;
    control.title = entry.doc;
    group.append(row);
    counterparts.set(key, control);
    const restore = addButton(
      `restore:${key}`,
      `Reset ${entry.label}`,
      () => {
        control.focus();
        return controller.selected && controller.restoreProperty(controller.selected.id, name);
      },
      group,
    );
    control.addEventListener('focus', () => reveal(key));
    control.addEventListener('blur', () => reveal(''));

    function update() {
      const object = controller.selected;
      const domain = object && sliderDomain(fire, entry, object[name]);
      const isShown =
        object?.kind === kind && domain !== undefined && (name === 'name' || !isFirstSource(fire, object));
      row.hidden = !isShown;
      restore.hidden = !isShown || isSame(object[name], controller.propertyOf(object, name));
      if (!isShown) return;
      show(object[name], domain);
      const isMet = (/** @type {[string, string[]]} */ [of, names]) => {
        const own = entriesOf(kind).find(({ id }) => id === of);
        return names.includes(
          String(own ? object[own.name] : fire.params[/** @type {keyof typeof fire.params} */ (of)]),
        );
      };
      noteConditions({ row, note }, entry, isMet, entriesOf(kind));
    }
    return update;
  }

  /** The items of the list: an open list is not replaced by the same items. */
  let listed = '';
  return {
    show() {
      const names = objectsOf(fire).map((object) => [String(object.id), nameOf(object)]);
      if (JSON.stringify(names) !== listed) {
        listed = JSON.stringify(names);
        select.replaceChildren(new Option('none', ''), ...names.map(([id, name]) => new Option(name, id)));
      }
      const selected = controller.selected;
      select.value = String(selected?.id ?? '');
      for (const { button, isOn } of buttons) button.setAttribute('aria-disabled', String(!isOn()));
      const full = KINDS.filter((kind) => isFull(fire, kind)).map(
        (kind) => `A scene has at most ${MAX_OBJECTS} ${kind}s.`,
      );
      const first =
        selected && isFirstSource(fire, selected) ? ['The properties of the first source are in Basics and Fire.'] : [];
      selection.note.textContent = [...full, ...first].join(' ');
      for (const update of rows) update();
    },
  };
}
