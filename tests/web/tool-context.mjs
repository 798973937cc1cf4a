/**
 * What the gestures of tools act on in tests without a browser: a fire that answers in order and records each call,
 * with the history, the selection and the edits that the toolbar uses.
 */
import { FireHistory } from '../../web/element/session/history.js';
import { Editing } from '../../web/editing/editing.js';
import { entriesOf } from '../../web/editing/objects.js';
import { PARAMETERS } from '../../web/parameters.js';
import { Cross } from '../../web/tools/cross.js';
import { Edits } from '../../web/tools/edits.js';
import { handlesOf } from '../../web/tools/geometry.js';
import { Pointers } from '../../web/tools/pointers.js';

/** Metres of a pixel. */
const PER_PIXEL = 0.0025;

const defaultsOf = (kind, model) =>
  Object.fromEntries(
    entriesOf(kind)
      .filter((entry) => entry.domain(model))
      .map((entry) => [entry.name, entry.domain(model)?.default]),
  );

/** A delta that leads to these objects from any others. */
const deltaTo = (objects) => ({
  objects: Object.fromEntries(objects.map((object) => [object.id, object])),
  order: objects.map(({ id }) => id),
});

/** A fire of a model with its source; its calls are `[name, ...arguments]`. */
class Fire extends EventTarget {
  preset = 'default';
  calls = [];

  reports = { emit: (type, detail) => this.dispatchEvent(new CustomEvent(type, { detail })) };
  history = new FireHistory(/** @type {any} */ (this));
  #objects = [];
  #answers = Promise.resolve();

  constructor(model) {
    super();
    this.params = { ...Object.fromEntries(PARAMETERS.map(({ id, domains }) => [id, domains[model]?.default])), model };
    this.#add({ kind: 'source' });
    for (const name of ['stir', 'sparks', 'ignite', 'extinguish', 'spray']) {
      this[name] = async (...args) => void this.calls.push([name, ...args]);
    }
  }

  get objects() {
    return structuredClone(this.#objects);
  }

  #add(fields) {
    const id = fields.id ?? 1 + Math.max(0, ...this.#objects.map((object) => object.id));
    this.#objects.push({ ...defaultsOf(fields.kind, this.params.model), ...fields, id });
    return id;
  }

  /** Answers later, as a worker does. */
  #ask(act, source = this.history.source('property')) {
    const [, key] = source.split(/:(.*)/s);
    const answer = this.#answers
      .then(
        () =>
          new Promise((resolve) => {
            setImmediate(resolve);
          }),
      )
      .then(() => {
        const before = deltaTo(this.objects);
        const result = act();
        const after = deltaTo(this.objects);
        if (JSON.stringify(before) !== JSON.stringify(after) && key !== undefined)
          this.history.record(key, before, after);
        return result;
      });
    this.#answers = answer.catch(() => {});
    return answer;
  }

  addObject(fields) {
    return this.#ask(() => this.#add(fields));
  }

  changeObject(id, fields) {
    return this.#ask(() =>
      Object.assign(
        this.#objects.find((object) => object.id === id),
        fields,
      ),
    );
  }

  removeObject(id) {
    return this.#ask(() => (this.#objects = this.#objects.filter((object) => object.id !== id)));
  }

  set({ objects }) {
    return this.#ask(() => {
      this.#objects = [];
      for (const object of objects) this.#add(object);
    });
  }

  /** What the history calls. */
  call(name, deltas, source) {
    return this.#ask(() => {
      // Nobody but the tools changes it.
      if (name === 'restore') this.#objects = structuredClone(deltas[0].order.map((id) => deltas[0].objects[id]));
    }, source);
  }

  /** Until it has answered all. */
  async settled() {
    for (let turn = 0; turn < 20; turn += 1) await this.#ask(() => {});
  }
}

/** The tools of a fire of this model with these objects beside its source, as the toolbar wires them. */
export async function toolsOf(objects = [], { model = 'combustion' } = {}) {
  const fire = /** @type {any} */ (new Fire(model));
  for (const object of objects) await fire.addObject(object);
  const editing = new Editing(fire);
  const { history } = fire;
  /** What the toolbar shows. */
  const shown = /** @type {{[name: string]: any}} */ ({
    messages: [],
    preview: [],
    guides: [],
    word: undefined,
    probes: [],
    cross: undefined,
  });
  const style = { material: 'stone', burns: false };
  /** Where forces have moved objects, by their ids. */
  const places = new Map();
  const now = () => fire.objects.map((object) => ({ ...object, ...places.get(object.id) }));
  const edits = new Edits(
    fire,
    editing,
    () => style,
    (text) => shown.messages.push(text),
    now,
  );
  const context = /** @type {import('../../web/tools/gestures.js').ToolContext} */ ({
    fire,
    editing,
    objects: now,
    add: (fields) => edits.add(fields),
    remove: (id) => editing.takeAway(id),
    changes: (changed, fields, held) => edits.changes(changed, fields, held),
    attempt: (act) => edits.attempt(act),
    handleAt: (object, at) =>
      (object ? handlesOf(object, PER_PIXEL) : []).find(
        (handle) => Math.hypot(handle.at.x - at.x, handle.at.y - at.y) <= 16 * PER_PIXEL,
      ),
    preview: (outlines) => (shown.preview = outlines),
    guide: (lines) => (shown.guides = lines),
    toggle: (id) => edits.toggle(id),
    thickness: () => 0.03,
    askForText: (at) => (shown.word = at),
    probe: (...args) => shown.probes.push(args),
  });
  const pointers = new Pointers(context);
  editing.cancelDrawing = () => pointers.cancelAll();
  const overlay = { seen: { x: 0, y: 0.9, width: 1.4 }, cross: (at) => (shown.cross = at) };
  const cross = new Cross(context, pointers, /** @type {any} */ (overlay));
  const how = (keys) => ({ snaps: false, adds: false, free: false, perPixel: PER_PIXEL, ...keys });
  const point = ([x, y]) => ({ x, y });
  return {
    fire,
    editing,
    history,
    edits,
    pointers,
    cross,
    shown,
    style,
    places,
    how,
    /** Presses at the first place, moves through the others and releases at the last one. */
    async drag(tool, path, keys) {
      pointers.begin(tool, 1, point(path[0]), how(keys));
      for (const place of path.slice(1)) pointers.move(1, point(place), how(keys));
      pointers.end(1, point(path.at(-1)), how(keys));
      await fire.settled();
      return fire.objects;
    },
    async undo() {
      await editing.undo();
      return fire.objects;
    },
  };
}
