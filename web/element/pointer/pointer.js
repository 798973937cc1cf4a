/**
 * A pointer on a fire: it moves gas along, twice as fast while it is pressed; a click throws sparks;
 * a drag that begins on the source or the lower flame moves the source and the objects attached to it, or the solid that the source is
 * on. Other gestures enlarge the picture.
 *
 * @typedef {import('../../hearth-fire.js').HearthPoint} Point
 * @typedef {Point & {id?: number}} Grip  A distance from the middle of the source [m], and the solid that it is on.
 * @typedef {{start: number, all: import('./attached-objects.js').Fields[]}} Group  Where the source was, and the
 *   objects attached to it.
 * @typedef {{x: number, y: number, held: Grip | undefined, group?: Group, clicks: boolean}} Press
 */

import { attachedObjects, halvesOf } from './attached-objects.js';
import { listenToZoom } from './zoom.js';

/** Maximum time between two events of one movement [ms]. */
const PAUSE_MS = 200;

/** Maximum speed of the gas that a pointer moves along [m/s]. */
const MAX_SPEED = 20;

/** Maximum movement of a click, and minimum half-width and height of a source's grip area [px]. */
const CLICK_PX = 6;
const GRIP_PX = 16;

/** The largest coordinate of a solid [m]. */
const MAX_COORDINATE = 10;

/** Sparks of a click. */
const SPARKS = 24;

/** Children of a fire that handle pointers themselves. */
const OTHERS = '.panel, .tools, .message, a, button, input, select, textarea, label';

/**
 * Starts to listen.
 * @param {import('../session/session.js').FireSession} session
 * @param {AbortSignal} signal ends it
 */
export function listenToPointer(session, signal) {
  const { fire, view } = session;
  const { root } = view;
  /**
   * The last position of each pointer; there are several with several fingers.
   * @type {Map<number, Point & {time: number}>}
   */
  const last = new Map();
  /**
   * Where each was pressed, and its distance from the middle of the source that it drags [m].
   * @type {Map<number, Press>}
   */
  const pressed = new Map();

  /** Its position in the window [px] and in the domain [m], and the size of a pixel there [m]. */
  const locate = (/** @type {MouseEvent} */ { clientX: x, clientY: y }) => {
    const viewport = view.viewport(fire.params);
    const metresAt = (/** @type {number} */ aside) => viewport?.metresOf(view.sharesAt(x + aside, y));
    const [metres, next] = [metresAt(0), metresAt(1)];
    const [low, high] = [viewport?.metresOf({ x: 0, y: 1 }), viewport?.metresOf({ x: 1, y: 0 })];
    if (!metres || !next || !low || !high) return undefined;
    const inside = metres.x >= low.x && metres.y >= low.y && metres.x <= high.x && metres.y <= high.y;
    return { x, y, low, high, inside, metres, perPixel: Math.hypot(next.x - metres.x, next.y - metres.y) };
  };
  const isForFire = (/** @type {Event} */ event) =>
    !event.composedPath().some(
      (node) =>
        // Not `instanceof`: the fire may have moved to another window's document.
        node !== fire &&
        /** @type {Partial<Element>} */ (node).matches?.(OTHERS) &&
        fire.shadowRoot?.contains(/** @type {Node} */ (node)),
    );
  /** Its distance from the middle of the source; undefined if it is not on the source. @returns {Grip | undefined} */
  const grip = (/** @type {MouseEvent} */ event) => {
    const at = locate(event);
    if (!at?.inside || !isForFire(event)) return undefined;
    const { metres, perPixel } = at;
    const source = sourceOf(fire.params);
    const solid = solidOf(fire);
    if (solid) {
      const from = { x: metres.x - solid.x, y: metres.y - solid.y };
      return isOn(solid, from, CLICK_PX * perPixel) ? { ...from, id: solid.id } : undefined;
    }
    const reach = GRIP_PX * perPixel;
    // The lower half of the flame is up to one and a half times as high as its source is wide.
    const up = metres.y - source.y;
    const near =
      Math.abs(metres.x - source.x) <= Math.max(source.half, 2 * reach) &&
      up >= -reach &&
      up <= Math.max(3 * source.half, 4 * reach);
    // The box of another shape may be mostly empty.
    const isOnAttached = () =>
      attachedObjects(fire).some(
        (solid) =>
          /^(line|box|circle)$/.test(solid.shape) &&
          solid.kind === 'solid' &&
          isOn(solid, { x: metres.x - solid.x, y: metres.y - solid.y }, 0),
      );
    return near || isOnAttached() ? { x: metres.x - source.x, y: 0 } : undefined;
  };

  const movesPicture = listenToZoom(session, isForFire, signal);
  const leave = (/** @type {PointerEvent} */ event) => last.delete(event.pointerId);
  /** The number of presses on objects: the drag of each is a step. */
  let presses = 0;
  const press = (/** @type {PointerEvent} */ event) => {
    if (event.button !== 0 || !isForFire(event)) return;
    const at = locate(event);
    if (!at?.inside) return;
    // A pointer that moves the picture neither drags nor clicks.
    if (movesPicture(event)) return pressed.clear();
    const held = grip(event);
    pressed.set(event.pointerId, { x: at.x, y: at.y, held, clicks: true });
    if (held === undefined) return;
    presses += 1;
    // A pointer that is gone cannot be captured.
    try {
      fire.setPointerCapture(event.pointerId);
    } catch {}
  };
  const drag = (
    /** @type {Press & {held: Grip}} */ press,
    /** @type {NonNullable<ReturnType<typeof locate>>} */ { low, high, metres },
  ) => {
    const { held } = press;
    const source = `pointer:press ${presses}`;
    // The panel shows as many digits, and URLs stay short.
    /** @type {(value: number, limit: number) => number} */
    const rounded = (value, limit) => Math.round(within(value, -limit, limit) * 1000) / 1000;
    const visible = within(metres.x - held.x, low.x, high.x);
    if (held.id !== undefined) {
      const y = within(metres.y - held.y, low.y, high.y);
      const position = { x: rounded(visible, MAX_COORDINATE), y: rounded(y, MAX_COORDINATE) };
      session.call('changeObject', held.id, position, source).catch(() => {});
      return;
    }
    const x = rounded(visible, Math.min(sourceOf(fire.params).max, 3));
    press.group ??= { start: sourceOf(fire.params).x, all: attachedObjects(fire) };
    session.call('set', { source_x: x }, source).catch(() => {});
    for (const object of press.group.all) {
      const position = { x: rounded(object.x + x - press.group.start, MAX_COORDINATE) };
      session.call('changeObject', object.id, position, source).catch(() => {});
    }
  };
  const follow = (/** @type {PointerEvent} */ event) => {
    if (movesPicture(event)) return last.clear();
    const at = locate(event);
    if (!at) return;
    const press = pressed.get(event.pointerId);
    if (press && Math.hypot(at.x - press.x, at.y - press.y) > CLICK_PX) press.clicks = false;
    if (press?.held !== undefined) {
      root.style.cursor = 'grabbing';
      if (!press.clicks) drag(/** @type {Press & {held: Grip}} */ (press), at);
      return;
    }
    root.style.cursor = event.pointerType !== 'touch' && grip(event) !== undefined ? 'grab' : '';
    const before = last.get(event.pointerId);
    const position = at.inside && isForFire(event) ? at.metres : null;
    if (!position) {
      // A finger may leave the element and return.
      leave(event);
      return;
    }
    last.set(event.pointerId, { ...position, time: event.timeStamp });
    if (!before) return;
    const seconds = (event.timeStamp - before.time) / 1000;
    if (!(seconds > 0 && seconds < PAUSE_MS / 1000)) return;
    const strength = event.buttons & 1 ? 2 : 1;
    const speed = (/** @type {number} */ metres) =>
      Math.max(-MAX_SPEED, Math.min(MAX_SPEED, (strength * metres) / seconds));
    session.send('stir', position.x, position.y, speed(position.x - before.x), speed(position.y - before.y));
  };
  const lift = (/** @type {PointerEvent} */ event) => {
    leave(event);
    const press = pressed.get(event.pointerId);
    pressed.delete(event.pointerId);
    root.style.cursor = '';
    const at = locate(event);
    if (event.type === 'pointerup' && press?.clicks && at?.inside) {
      session.send('sparks', at.metres.x, at.metres.y, SPARKS);
    }
  };
  // A drag of the source selects no text. A finger still scrolls the page: `touch-action`
  // separates a scroll from a drag.
  const hold = (/** @type {MouseEvent} */ event) => {
    if (grip(event) !== undefined) event.preventDefault();
  };

  // An undo, another scene or another change of a visitor ends a drag: its object may be gone.
  const end = (/** @type {CustomEventInit<import('../types.js').HearthHistoryDetail>} */ { detail }) => {
    if (detail?.type !== 'step' || !detail.key.startsWith('press ')) pressed.clear();
  };

  fire.addEventListener('history-change', end, { signal });
  fire.addEventListener('pointermove', follow, { signal });
  fire.addEventListener('pointerdown', press, { signal });
  fire.addEventListener('pointerleave', leave, { signal });
  fire.addEventListener('pointerup', lift, { signal });
  fire.addEventListener('pointercancel', lift, { signal });
  fire.addEventListener('mousedown', hold, { signal });
  signal.addEventListener('abort', () => (root.style.cursor = ''));
}

/**
 * The source as the engine positions it: middle and height of its base, half of its width, and its maximum
 * distance from the middle of the domain [m].
 * @param {import('../../parameters.js').HearthParameters} params
 */
function sourceOf(params) {
  const { model, domain_width: across, domain_height: up, source_width: wide } = params;
  const seam = model === 'combustion' && params.edges === 'periodic' ? params.seam : 0;
  const half = Math.min(wide, across) / 2;
  const max = Math.max((0.5 - seam) * across - half, 0);
  return {
    x: within(params.source_x, -max, max),
    y: within(params.source_height, seam * up, (1 - seam) * up),
    half,
    max,
  };
}

/**
 * The solid that the first source is on; undefined if the source is a line.
 * @param {import('../../hearth-fire.js').HearthFire} fire
 */
function solidOf({ params, objects }) {
  if (params.source_shape !== 'solid') return undefined;
  return /** @type {any[]} */ (objects).find(({ kind, id }) => kind === 'solid' && id === params.source_solid);
}

/**
 * Whether a point relative to the centre of a solid is in the box of the solid, or so near to it.
 * @type {(solid: any, from: Point, near: number) => boolean}
 */
function isOn(solid, { x, y }, near) {
  const turn = solid.shape === 'circle' ? 0 : (solid.angle * Math.PI) / 180;
  const [along, across] = [x * Math.cos(turn) + y * Math.sin(turn), y * Math.cos(turn) - x * Math.sin(turn)].map(
    Math.abs,
  );
  const [wide, high] = halvesOf(solid);
  return along <= wide + near && across <= high + near;
}

/** @type {(value: number, low: number, high: number) => number} */
const within = (value, low, high) => Math.max(low, Math.min(high, value));
