/**
 * A pointer that stirs the fire: gas near it is carried along.
 */

/** Longest time between two events of one movement [ms]. */
const PAUSE_MS = 200;

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
  const move = (event) => {
    const { left, top } = host.getBoundingClientRect();
    const place = toMetres(event.clientX - left, event.clientY - top);
    const before = last.get(event.pointerId);
    if (!place) return;
    last.set(event.pointerId, { ...place, time: event.timeStamp });
    const seconds = (event.timeStamp - before?.time) / 1000;
    if (!(seconds > 0 && seconds < PAUSE_MS / 1000)) return;
    const [u, v] = [(place.x - before.x) / seconds, (place.y - before.y) / seconds];
    stir({ ...place, u, v });
  };
  const leave = (event) => last.delete(event.pointerId);
  host.addEventListener('pointermove', move, ended);
  for (const type of ['pointerleave', 'pointercancel', 'pointerup']) {
    host.addEventListener(type, leave, ended);
  }
  return () => ended.abort();
}
