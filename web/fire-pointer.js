/**
 * A pointer that stirs the fire: gas near it is carried along.
 */

/** Longest time between two events of one movement [ms]. */
const PAUSE_MS = 200;

/** Fastest that gas is carried along [m/s]. */
const FASTEST = 20;

/**
 * Starts to listen.
 * @param {HTMLElement} host
 * @param {(x: number, y: number) => {x: number, y: number} | null} toMetres
 * @param {(stir: {x: number, y: number, u: number, v: number}) => void} stir
 * @returns {() => void} ends it
 */
export function listenToPointer(host, toMetres, stir) {
  const ended = new AbortController();
  /** The last place of each pointer: fingers may be many. */
  const last = new Map();
  const leave = (event) => last.delete(event.pointerId);
  const move = (event) => {
    const { left, top, width, height } = host.getBoundingClientRect();
    const [x, y] = [event.clientX - left, event.clientY - top];
    const place = x >= 0 && y >= 0 && x <= width && y <= height ? toMetres(x, y) : null;
    const before = last.get(event.pointerId);
    if (!place) {
      // A finger may go on beyond the fire.
      leave(event);
      return;
    }
    last.set(event.pointerId, { ...place, time: event.timeStamp });
    const seconds = (event.timeStamp - before?.time) / 1000;
    if (!(seconds > 0 && seconds < PAUSE_MS / 1000)) return;
    const speed = (metres) => Math.max(-FASTEST, Math.min(FASTEST, metres / seconds));
    const [u, v] = [speed(place.x - before.x), speed(place.y - before.y)];
    stir({ ...place, u, v });
  };
  host.addEventListener('pointermove', move, ended);
  for (const type of ['pointerleave', 'pointercancel', 'pointerup']) {
    host.addEventListener(type, leave, ended);
  }
  return () => ended.abort();
}
