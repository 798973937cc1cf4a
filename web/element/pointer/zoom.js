/**
 * The gestures that enlarge the picture of an interactive fire: a wheel with Ctrl and a pinch zoom at
 * the pointer, a drag with Shift and two fingers move the enlarged picture, a double click shows it as
 * before. They write the attributes `zoom` and `pan`. A wheel without Ctrl scrolls the page.
 */

/** Zoom of a wheel that turns by a pixel, and pixels of a line. */
const PER_PIXEL = 1.005;
const LINE_PX = 16;

/**
 * Starts to listen.
 * @param {import('../session/session.js').FireSession} session
 * @param {(event: Event) => boolean} isForFire
 * @param {AbortSignal} signal ends it
 * @returns {(event: PointerEvent) => boolean} whether a pointer moves the picture, not the gas
 */
export function listenToZoom({ fire, view }, isForFire, signal) {
  /** The attributes before the first gesture. @type {{zoom: any, pan: any} | undefined} */
  let before;
  /** The positions of the fingers, and of a mouse with Shift. @type {Map<number, {x: number, y: number}>} */
  const moving = new Map();

  /** A position in the picture as shares from the left and from below. */
  const share = (/** @type {{x: number, y: number}} */ at) => {
    const { x, y } = view.sharesAt(at.x, at.y);
    return [x, 1 - y];
  };
  /** Enlarges the picture; what was at the share `from` moves to the share `to`. */
  const enlarge = (/** @type {number} */ factor, /** @type {number[]} */ from, to = from) => {
    const { zoom, panX, panY } = view.camera;
    const next = Math.max(1, Math.min(view.maxZoom, zoom * factor));
    const hidden = 1 - 1 / next;
    const pan = [panX, panY]
      .map((pan, axis) => {
        const edge = pan * (1 - 1 / zoom) + from[axis] / zoom - to[axis] / next;
        return hidden > 0 ? Math.max(0, Math.min(1, edge / hidden)).toFixed(4) : '0.5';
      })
      .join(' ');
    if (next === zoom && (hidden === 0 || pan === `${panX.toFixed(4)} ${panY.toFixed(4)}`)) return false;
    before ??= { zoom: fire.getAttribute('zoom'), pan: fire.getAttribute('pan') };
    fire.setAttribute('pan', pan);
    fire.setAttribute('zoom', String(Math.round(next * 1e4) / 1e4));
    return true;
  };
  /** The middle of the moving pointers, and how far they are apart. */
  const span = () => {
    const [first, other = first] = moving.values();
    return {
      x: (first.x + other.x) / 2,
      y: (first.y + other.y) / 2,
      apart: Math.hypot(first.x - other.x, first.y - other.y),
    };
  };
  const moves = (/** @type {PointerEvent} */ event) =>
    moving.has(event.pointerId) && (moving.size > 1 || event.pointerType !== 'touch');

  fire.addEventListener(
    'wheel',
    (event) => {
      if (!event.ctrlKey || !isForFire(event) || !view.canvas) return;
      const pixels = event.deltaY * (event.deltaMode ? LINE_PX : 1);
      // The page gets the wheel over a picture that is not enlarged.
      if (enlarge(PER_PIXEL ** -pixels, share({ x: event.clientX, y: event.clientY })) || view.camera.zoom > 1)
        event.preventDefault();
    },
    { signal, passive: false },
  );
  fire.addEventListener(
    'pointerdown',
    (event) => {
      if ((event.pointerType === 'touch' || (event.shiftKey && fire.zoom > 1)) && isForFire(event)) {
        moving.set(event.pointerId, { x: event.clientX, y: event.clientY });
      }
    },
    { signal },
  );
  fire.addEventListener(
    'pointermove',
    (event) => {
      if (!moving.has(event.pointerId) || !view.canvas) return;
      const from = span();
      moving.set(event.pointerId, { x: event.clientX, y: event.clientY });
      if (!moves(event)) return;
      const to = span();
      enlarge(from.apart > 0 ? to.apart / from.apart : 1, share(from), share(to));
    },
    { signal },
  );
  for (const type of ['pointerup', 'pointercancel', 'pointerleave']) {
    fire.addEventListener(type, (event) => moving.delete(/** @type {PointerEvent} */ (event).pointerId), { signal });
  }
  fire.addEventListener(
    'dblclick',
    (event) => {
      if (!before || !isForFire(event)) return;
      Object.assign(fire, before);
      before = undefined;
    },
    { signal },
  );
  return moves;
}
