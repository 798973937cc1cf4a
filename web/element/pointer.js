/**
 * A pointer on a fire: gas near it is carried along, twice as fast while it is pressed;
 * a click throws sparks; a drag that begins on the source moves that.
 *
 * @typedef {object} Ways
 * @property {(...call: import('../engine/engine.js').Call) => unknown} send calls the engine
 * @property {(x: number) => unknown} move puts the source there [m]
 * @typedef {import('../hearth-fire.js').HearthPoint} Point
 * @typedef {{x: number, y: number, held: number | undefined, clicks: boolean}} Press
 */

/** Longest time between two events of one movement [ms]. */
const PAUSE_MS = 200;

/** Fastest that gas is carried along [m/s]. */
const FASTEST = 20;

/** How far a pointer may go and still have clicked, and how far a source reaches at least [px]. */
const STILL = 6;
const HAND = 16;

/** Sparks of a click. */
const SPARKS = 24;

/** What inside a fire has pointers of its own. */
const OTHERS = '.panel, .message, a, button, input, select, textarea, label';

/**
 * Starts to listen.
 * @param {import('../hearth-fire.js').HearthFire} fire the element
 * @param {HTMLElement} root what stands inside it
 * @param {Ways} ways
 * @param {AbortSignal} signal ends it
 */
export function listenToPointer(fire, root, { send, move }, signal) {
  /** The last place of each pointer: fingers may be many. @type {Map<number, Point & {time: number}>} */
  const last = new Map();
  /** Where each was pressed, and what it holds: how far from the source's middle [m]. @type {Map<number, Press>} */
  const pressed = new Map();

  /** Where on the fire it is [px], and in its world; nothing where it is not. */
  const locate = (/** @type {MouseEvent} */ { clientX, clientY }) => {
    const { left, top, width, height } = fire.getBoundingClientRect();
    const [x, y] = [clientX - left, clientY - top];
    const inside = x >= 0 && y >= 0 && x <= width && y <= height;
    return { x, y, width, inside, metres: fire.toMetres(x, y) };
  };
  const isOurs = (/** @type {Event} */ event) => !event.composedPath().some((node) => (
    // Not `instanceof`: the fire may have moved to another window's document.
    node !== fire && /** @type {Partial<Element>} */ (node).matches?.(OTHERS) && fire.shadowRoot?.contains(/** @type {Node} */ (node))
  ));
  /** How far from the middle of the source it grips that [m]; nothing where it does not. */
  const grip = (/** @type {MouseEvent} */ event) => {
    const { x, y, inside, metres } = locate(event);
    const source = sourceOf(fire.params);
    const foot = fire.toPixels(source.x, source.y);
    if (!inside || !foot || !metres || !isOurs(event)) return undefined;
    const half = (fire.toPixels(source.x + source.half, source.y)?.x ?? foot.x) - foot.x;
    const near = Math.abs(x - foot.x) <= Math.max(half, HAND) && Math.abs(y - foot.y) <= HAND;
    return near ? metres.x - source.x : undefined;
  };

  const leave = (/** @type {PointerEvent} */ event) => last.delete(event.pointerId);
  const press = (/** @type {PointerEvent} */ event) => {
    if (event.button !== 0 || !isOurs(event)) return;
    const { x, y, inside } = locate(event);
    if (!inside) return;
    const held = grip(event);
    pressed.set(event.pointerId, { x, y, held, clicks: true });
    if (held === undefined) return;
    // A pointer that is gone already cannot be captured.
    try {
      fire.setPointerCapture(event.pointerId);
    } catch {}
  };
  const drag = (/** @type {number} */ held, /** @type {ReturnType<typeof locate>} */ { width, metres }) => {
    const [left, right] = [fire.toMetres(0, 0), fire.toMetres(width, 0)];
    if (!metres || !left || !right) return;
    const { most } = sourceOf(fire.params);
    const seen = Math.max(left.x, Math.min(right.x, metres.x - held));
    const limit = Math.min(most, 3);
    // As the panel shows numbers, and no more of them in an address.
    move(Math.round(Math.max(-limit, Math.min(limit, seen)) * 1000) / 1000);
  };
  const follow = (/** @type {PointerEvent} */ event) => {
    const at = locate(event);
    const press = pressed.get(event.pointerId);
    if (press && Math.hypot(at.x - press.x, at.y - press.y) > STILL) press.clicks = false;
    if (press?.held !== undefined) {
      root.style.cursor = 'grabbing';
      if (!press.clicks) drag(press.held, at);
      return;
    }
    root.style.cursor = event.pointerType === 'mouse' && grip(event) !== undefined ? 'grab' : '';
    const before = last.get(event.pointerId);
    const place = at.inside && isOurs(event) ? at.metres : null;
    if (!place) {
      // A finger may go on beyond the fire.
      leave(event);
      return;
    }
    last.set(event.pointerId, { ...place, time: event.timeStamp });
    if (!before) return;
    const seconds = (event.timeStamp - before.time) / 1000;
    if (!(seconds > 0 && seconds < PAUSE_MS / 1000)) return;
    const strength = event.buttons & 1 ? 2 : 1;
    const speed = (/** @type {number} */ metres) => Math.max(-FASTEST, Math.min(FASTEST, (strength * metres) / seconds));
    send('stir', place.x, place.y, speed(place.x - before.x), speed(place.y - before.y));
  };
  const lift = (/** @type {PointerEvent} */ event) => {
    leave(event);
    const press = pressed.get(event.pointerId);
    pressed.delete(event.pointerId);
    root.style.cursor = '';
    const { inside, metres } = locate(event);
    if (event.type === 'pointerup' && press?.clicks && inside && metres) {
      send('sparks', metres.x, metres.y, SPARKS);
    }
  };
  // A mouse that holds the source selects no text. A finger still scrolls the page up and
  // down: `touch-action` tells its scrolling from a drag.
  const keep = (/** @type {MouseEvent} */ event) => {
    if (grip(event) !== undefined) event.preventDefault();
  };

  fire.addEventListener('pointermove', follow, { signal });
  fire.addEventListener('pointerdown', press, { signal });
  fire.addEventListener('pointerleave', leave, { signal });
  fire.addEventListener('pointerup', lift, { signal });
  fire.addEventListener('pointercancel', lift, { signal });
  fire.addEventListener('mousedown', keep, { signal });
  signal.addEventListener('abort', () => (root.style.cursor = ''));
}

/**
 * The source of a fire as the engine has it: middle and height of its foot, half of its
 * width, and how far from the middle it may stand [m].
 * @param {import('../parameters.js').HearthParameters} params
 */
function sourceOf(params) {
  const { model, domain_width: across, domain_height: up, source_width: wide } = params;
  const seam = model === 'combustion' ? params.seam : 0;
  const half = Math.min(wide, across) / 2;
  const most = Math.max((0.5 - seam) * across - half, 0);
  /** @type {(value: number, min: number, max: number) => number} */
  const between = (value, min, max) => Math.max(min, Math.min(max, value));
  return {
    x: between(params.source_x, -most, most),
    y: between(params.source_height, seam * up, (1 - seam) * up),
    half,
    most,
  };
}
