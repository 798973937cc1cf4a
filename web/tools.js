/**
 * The toolbar, which draws, moves and edits objects. A visitor draws solids and sources, writes words, drops
 * pictures, and moves, turns, sizes and erases objects, with a mouse, a finger, a pen or keys. It uses the public
 * API of the element and shares the history and the selection of the panel.
 */

import { element } from './element/controls/icon-button.js';
import { editingOf, isOn } from './editing/editing.js';
import { historyKey, keyOf } from './editing/keys.js';
import { objectsOf } from './editing/objects.js';
import { addStyle, check, optionsOf } from './editing/style.js';
import { bindSpeaker } from './sound/speaker.js';
import { Bar } from './tools/bar.js';
import { Cross } from './tools/cross.js';
import { Edits } from './tools/edits.js';
import { rounded, scaled } from './tools/geometry.js';
import { Inserts } from './tools/insert.js';
import { Instruments } from './tools/instruments.js';
import { Overlay } from './tools/overlay.js';
import { Pointers } from './tools/pointers.js';
import { ARROWS, TOOLS, worded } from './tools/table.js';

/**
 * @typedef {import('./hearth-fire.js').HearthFire} HearthFire
 * @typedef {import('./tools/geometry.js').Fields} Fields
 * @typedef {import('./tools/gestures.js').How} How
 */

/** Thickness of a new line, as a share of the domain's smaller side. */
const THICKNESS = 0.03;

/** How far a key moves an object or the cross [m]; the Shift key multiplies it by {@link FAST}. */
const STEP = 0.01;
const FAST = 10;
/** How far a key turns an object [°]. */
const TURN = 5;

/** How long a message stays [ms]. */
const STATUS_MS = 5000;

/**
 * Shows the toolbar of a fire.
 * @param {object} options
 * @param {HTMLElement} options.host  Gets the toolbar; it covers the fire.
 * @param {HearthFire} options.fire
 * @param {boolean} [options.page]  Whether the page is about this fire: keys work anywhere on it.
 * @param {() => void} [options.closed]  The visitor has closed the toolbar.
 * @returns {Promise<{destroy(): void}>}
 */
export async function mountTools(options) {
  const { host, fire, page = false, closed = () => {} } = optionsOf(options);
  check('closed', 'a function', typeof closed === 'function');
  const { styled, removeStyle } = addStyle(host, new URL('./tools/tools.css', import.meta.url).href);
  await styled;
  const tools = new Toolbar(host, fire, closed);
  const ended = new AbortController();
  tools.listen(page ? document : host, ended.signal);
  return {
    destroy() {
      ended.abort();
      tools.remove();
      removeStyle();
    },
  };
}

/** The toolbar of one fire. */
class Toolbar {
  #fire;
  #host;
  #editing;
  #edits;
  #inserts;
  #instruments;
  #overlay;
  #pointers;
  #cross;
  #tool = 'select';
  /**
   * The poses of the solids that forces move, by their ids.
   * @type {Map<number, {x: number, y: number, angle: number}>}
   */
  #poses = new Map();
  #bar;
  #status = element('p', { class: 'hearth-status', role: 'status' });
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #statusEnds;
  /** Whether the state of the fire is about to be shown. */
  #isStale = false;
  /** Ends what the speaker button follows. */
  #unbind;

  /** @param {HTMLElement} host @param {HearthFire} fire @param {() => void} closed */
  constructor(host, fire, closed) {
    this.#host = host;
    this.#fire = fire;
    this.#editing = editingOf(fire);
    this.#edits = new Edits(
      fire,
      this.#editing,
      () => this.#bar,
      (text) => this.#showStatus(text),
      () => this.#objects,
    );
    this.#overlay = new Overlay(fire);
    this.#inserts = new Inserts(host, this.#overlay, this.#edits, (config) => this.#open(config));
    const plotsShown = (/** @type {boolean} */ shown) => this.#bar.mark('plots', shown);
    this.#instruments = new Instruments(
      { host, fire, showStatus: (text) => this.#showStatus(text), plotsShown },
      (act) => this.#edits.attempt(act),
    );
    const context = this.#context;
    this.#pointers = new Pointers(context);
    this.#cross = new Cross(context, this.#pointers, this.#overlay);
    this.#editing.cancelDrawing = () => this.#pointers.cancelAll();
    this.#bar = new Bar({
      tool: (name) => this.#choose(name),
      select: (id) => {
        if (this.#bar.several && id !== undefined) this.#edits.toggle(id);
        else this.#editing.select(id);
        this.#choose('select', false);
      },
      picture: (file) => this.#inserts.picture(file),
      duplicate: () => this.#edits.duplicate(),
      remove: () => this.#edits.remove(),
      order: (front) => this.#edits.order(front),
      align: (to) => this.#align(to),
      plots: () => this.#instruments.plot(),
      undo: () => this.#edits.attempt(() => this.#editing.undo()),
      redo: () => this.#edits.attempt(() => this.#editing.redo()),
      close: closed,
    });
    this.#unbind = bindSpeaker(this.#bar.speaker, fire);
    host.classList.add('hearth-tools');
    host.append(this.#overlay.element, this.#bar.element, this.#bar.align, this.#status);
    this.#choose('select');
    this.#update();
  }

  /** The objects as they are now: forces move some of them. @returns {import('./editing/objects.js').Fields[]} */
  get #objects() {
    return objectsOf(this.#fire).map((object) => ({ ...object, ...this.#poses.get(object.id) }));
  }

  /** The selected objects as they are now. */
  get #selected() {
    const { all } = this.#editing;
    return this.#objects.filter(({ id }) => all.some((chosen) => chosen.id === id));
  }

  /** Follows the solids that forces move, until the signal. @param {AbortSignal} signal */
  async #follow(signal) {
    while (!signal.aborted) {
      await new Promise((resolve) => {
        requestAnimationFrame(resolve);
      });
      if (this.#poses.size === 0 && !objectsOf(this.#fire).some(({ motion }) => motion === 'free')) continue;
      const solids = await this.#fire.freeSolids().catch(() => []);
      this.#poses = new Map(
        solids.map(({ id, x, y, angle }) => [id, { x: rounded(x), y: rounded(y), angle: Math.round(10 * angle) / 10 }]),
      );
      this.#outline();
    }
  }

  /** What gestures need. @returns {import('./tools/gestures.js').ToolContext} */
  get #context() {
    return {
      fire: this.#fire,
      editing: this.#editing,
      objects: () => this.#objects,
      add: (fields) => {
        this.#overlay.preview([]);
        this.#edits.add(fields);
      },
      remove: (id) => this.#editing.takeAway(id),
      changes: (objects, fields, held) => this.#edits.changes(objects, fields, held),
      attempt: (act) => this.#edits.attempt(act),
      handleAt: (object, at) => this.#overlay.handleAt(object, at),
      preview: (shown) => this.#overlay.preview(shown),
      guide: (lines) => this.#overlay.guide(lines),
      toggle: (id) => this.#edits.toggle(id),
      thickness: () =>
        rounded(Math.max(0.01, THICKNESS * Math.min(this.#fire.params.domain_width, this.#fire.params.domain_height))),
      askForText: (at) => this.#inserts.askForText(at),
      probe: (at, options) => this.#tool === 'probe' && this.#instruments.probe(at, options),
    };
  }

  /** Starts to listen. @type {(keys: EventTarget, signal: AbortSignal) => void} */
  listen(keys, signal) {
    const layer = this.#overlay.element;
    const on = (
      /** @type {EventTarget} */ target,
      /** @type {string} */ name,
      /** @type {(event: any) => void} */ act,
    ) => target.addEventListener(name, act, { signal });
    on(layer, 'pointerdown', (event) => this.#press(event));
    on(layer, 'pointermove', (event) => this.#move(event));
    on(layer, 'pointerup', (event) => this.#lift(event));
    // The click of a tap would press what of the form of a word is under the finger.
    on(layer, 'touchend', (event) => this.#tool === 'text' && event.preventDefault());
    on(layer, 'pointercancel', ({ pointerId }) => this.#pointers.cancel(pointerId));
    on(layer, 'blur', () => this.#cross.point(undefined));
    on(layer, 'dblclick', () => this.#pointers.polygon.close());
    on(keys, 'keydown', (event) => this.#key(event));
    this.#inserts.listen([this.#fire, this.#host], signal);
    this.#editing.watch(() => this.#update(), signal);
    for (const name of ['objects-change', 'params-change', 'ready']) on(this.#fire, name, () => this.#updateSoon());
    this.#follow(signal);
    const sizes = new ResizeObserver(() => {
      this.#place(getComputedStyle(this.#bar.element).display === 'flex' ? 'row' : 'column');
      this.#update();
    });
    for (const sized of [this.#fire, this.#host]) sizes.observe(sized);
    const view = new MutationObserver(() => this.#update());
    view.observe(this.#fire, { attributeFilter: ['zoom', 'pan', 'fit', 'align'] });
    signal.addEventListener('abort', () => {
      sizes.disconnect();
      view.disconnect();
    });
  }

  remove() {
    clearTimeout(this.#statusEnds);
    this.#unbind();
    this.#cross.remove();
    this.#pointers.cancelAll();
    this.#editing.cancelDrawing = () => false;
    this.#host.classList.remove('hearth-tools');
    for (const element of [this.#overlay.element, this.#bar.element, this.#bar.align, this.#status]) element.remove();
    this.#inserts.close();
    this.#instruments.remove();
    this.#place('');
  }

  /** Tells the fire where the bar lies: what else is over the fire makes room. @param {string} where */
  #place(where) {
    this.#fire.shadowRoot?.querySelector('.root')?.setAttribute('data-tools', where);
  }

  /** @type {(name: string, announces?: boolean) => void} */
  #choose(name, announces = true) {
    this.#pointers.cancelAll();
    this.#tool = name;
    const tool = TOOLS.find((candidate) => candidate.name === name);
    this.#bar.choose(name);
    const layer = this.#overlay.element;
    layer.style.cursor = tool?.cursor ?? '';
    layer.classList.toggle('idle', name === 'stir');
    // The probe measures at the cross until a pointer moves.
    if (name === 'probe') this.#instruments.probe(this.#cross.at);
    else this.#instruments.hideProbe();
    const missing =
      ['sparks', 'ignite', 'extinguish', 'water'].includes(name) && this.#fire.params.model === 'classic'
        ? ' The classic model has none.'
        : '';
    if (announces && tool) this.#showStatus(`${tool.label}: ${worded(tool.hint)}.${missing}`);
    this.#update();
  }

  /** Shows the state of the fire. */
  #update() {
    this.#outline();
    this.#bar.show(objectsOf(this.#fire), this.#editing.all, this.#fire.history);
  }

  /** Shows the state of the fire once for all events of one answer: a scene changes many values. */
  #updateSoon() {
    if (this.#isStale) return;
    this.#isStale = true;
    queueMicrotask(() => {
      this.#isStale = false;
      this.#update();
    });
  }

  /** Shows the outlines and the handles of the selected objects. */
  #outline() {
    const [all, selected] = [this.#objects, this.#selected];
    // A source at the surface of a solid is where that is.
    const outlined = selected.map((object) => all.find(({ id }) => isOn(object, id)) ?? object);
    const hasHandles = outlined.length === 1 && outlined[0] === selected[0] && this.#tool === 'select';
    this.#overlay.select(outlined, hasHandles ? outlined[0] : undefined);
  }

  /** Shows a message for a while. @param {string} text */
  #showStatus(text) {
    this.#status.textContent = text;
    clearTimeout(this.#statusEnds);
    this.#statusEnds = setTimeout(() => (this.#status.textContent = ''), STATUS_MS);
  }

  /** Opens settings. @param {import('./hearth-fire.js').HearthConfig | string} config */
  #open(config) {
    return this.#editing.group()(() => this.#fire.importConfig(config));
  }

  /** @param {MouseEvent | KeyboardEvent} event @returns {How} */
  #how(event) {
    const { shiftKey, altKey } = event;
    // A key moves by whole steps.
    const free = altKey || event instanceof KeyboardEvent;
    return { snaps: shiftKey, adds: shiftKey || this.#bar.several, free, perPixel: this.#overlay.perPixel };
  }

  /** @param {PointerEvent} event */
  #press(event) {
    const at = this.#overlay.metres(event);
    if (event.button !== 0 || !at) return;
    event.preventDefault();
    // A pointer that is gone cannot be captured.
    try {
      this.#overlay.element.setPointerCapture(event.pointerId);
    } catch {}
    this.#pointers.begin(this.#tool, event.pointerId, at, this.#how(event));
  }

  /** @param {PointerEvent} event */
  #move(event) {
    const at = this.#overlay.metres(event);
    if (at) this.#pointers.move(event.pointerId, at, this.#how(event));
  }

  /** @param {PointerEvent} event */
  #lift(event) {
    const at = this.#overlay.metres(event);
    if (at) this.#pointers.end(event.pointerId, at, this.#how(event));
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const target = /** @type {Partial<HTMLElement>} */ (event.composedPath()[0]);
    if (this.#bar.rove(/** @type {HTMLElement} */ (target), event.key)) {
      event.preventDefault();
      return;
    }
    if (event.defaultPrevented || target.matches?.('input:not([type=checkbox]), textarea, select')) return;
    const act = this.#actionOf(event, target === this.#overlay.element);
    if (!act) return;
    event.preventDefault();
    // A panel of this page may listen to the same keys.
    event.stopImmediatePropagation();
    act();
  }

  /** @type {(event: KeyboardEvent, onLayer: boolean) => (() => void) | undefined} */
  #actionOf(event, onLayer) {
    const { shiftKey } = event;
    const key = keyOf(event);
    const { id: last } = this.#editing;
    const all = this.#selected;
    const selected = all.find(({ id }) => id === last);
    if (event.altKey) return undefined;
    const move = historyKey(event);
    if (move) return () => this.#edits.attempt(() => this.#editing[move]());
    if (event.ctrlKey || event.metaKey) {
      return key === 'd' && selected ? () => this.#edits.duplicate() : undefined;
    }
    const tool = TOOLS.find((candidate) => candidate.key === key);
    if (tool) return () => this.#choose(tool.name);
    if (key === 'g') return () => this.#instruments.plot();
    if (key === 'Escape') return () => this.#escape();
    if (key === 'Delete' || key === 'Backspace') return selected && (() => this.#edits.remove());
    const arrow = ARROWS[key];
    const far = STEP * (shiftKey ? FAST : 1);
    if (onLayer && (this.#tool !== 'select' || this.#cross.shown || !selected)) {
      if (this.#tool === 'blow' && arrow && !shiftKey)
        return () => this.#cross.puff(this.#how(event), { x: arrow[0], y: arrow[1] });
      if (arrow) return () => this.#moveCross(arrow[0] * far, arrow[1] * far, this.#how(event));
      if (key === 'Enter' || key === ' ') return () => this.#cross.press(this.#tool, this.#how(event));
    }
    if (!selected) return undefined;
    const change = (/** @type {(object: Fields) => Fields} */ of) => () => {
      if (!event.repeat) this.#editing.press();
      this.#edits.change(all.map(of), all);
    };
    if (arrow) return change(({ x, y }) => ({ x: rounded(x + arrow[0] * far), y: rounded(y + arrow[1] * far) }));
    if (key === '[' || key === ']') return change(({ angle = 0 }) => ({ angle: angle + (key === '[' ? TURN : -TURN) }));
    if (key === '+' || key === '-') return change((object) => scaled(object, key === '+' ? 1.1 : 1 / 1.1));
    // Enter shows the cross, with which other objects are chosen.
    return onLayer && key === 'Enter' ? () => this.#cross.point({ x: selected.x, y: selected.y }) : undefined;
  }

  /** @param {import('./tools/geometry.js').Alignment} to */
  #align(to) {
    this.#editing.press();
    this.#edits.align(to);
  }

  #escape() {
    if (this.#pointers.cancelAll()) {
      // Nothing is drawn any more.
    } else if (this.#instruments.close()) {
      // The plots are hidden.
    } else if (this.#cross.shown) {
      this.#cross.point(undefined);
    } else if (this.#editing.selected) {
      this.#editing.select();
    } else {
      this.#choose('stir');
    }
  }

  /** @type {(right: number, up: number, how: How) => void} */
  #moveCross(right, up, how) {
    const at = this.#cross.move(right, up, how);
    this.#showStatus(`${at.x.toFixed(2)}, ${at.y.toFixed(2)} m`);
  }
}
