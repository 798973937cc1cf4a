/**
 * Observes the size of an element, whether it is visible, and whether the visitor wants reduced
 * motion. `stop` ends all observers.
 */

/** Most device pixels for a CSS pixel: more is not seen in a fire and costs much. */
const DENSEST = 2;
/** The same on phones and tablets, whose graphics are slower. */
const DENSEST_TOUCH = 1.5;
/** Longest side of a canvas: what nearly every graphics card can draw. */
const LONGEST_SIDE = 8192;

const REDUCED_MOTION = '(prefers-reduced-motion: reduce)';

/** Whether the visitor asked for less motion. */
export function motionIsReduced() {
  return globalThis.matchMedia?.(REDUCED_MOTION).matches ?? false;
}

/** How much a fire may ask of this device before it has been tried. */
export function guess() {
  return isTouch() || navigator.hardwareConcurrency <= 2 ? 'low' : 'medium';
}

/** Whether it is a phone or a tablet. */
function isTouch() {
  return globalThis.matchMedia?.('(pointer: coarse)').matches ?? false;
}

/**
 * The size that a canvas should have, within the caps; how many pixels that may be
 * is the engine's affair.
 * @param {number} width in device pixels
 * @param {number} height in device pixels
 * @param {number} density device pixels for a CSS pixel
 * @param {boolean} touch
 * @returns {{width: number, height: number}}
 */
export function cappedSize(width, height, density, touch) {
  const densest = touch ? DENSEST_TOUCH : DENSEST;
  const longest = Math.max(width, height, 1);
  const scale = Math.min(1, densest / density, LONGEST_SIDE / longest);
  return { width: Math.round(width * scale), height: Math.round(height * scale) };
}

/**
 * Settles when a fire is to be made: `eager`, at once; `lazy`, when somebody is about
 * to see it; `auto`, at once where it is in sight, elsewhere when the page has loaded.
 *
 * @typedef {'auto' | 'lazy' | 'eager'} Loading
 * @param {HTMLElement} host
 * @param {Loading} loading
 * @param {AbortSignal} stopped ends the wait
 * @returns {Promise<void>}
 */
export function sight(host, loading, stopped) {
  if (loading === 'eager' || (loading === 'auto' && document.readyState === 'complete')) {
    return Promise.resolve();
  }
  return new Promise((resolve) => {
    const views = new IntersectionObserver(
      (entries) => entries.some((entry) => entry.isIntersecting) && end(),
      // Half a window before it comes into sight.
      { rootMargin: loading === 'lazy' ? '50%' : '0%' },
    );
    const end = () => {
      views.disconnect();
      removeEventListener('load', end);
      stopped.removeEventListener('abort', end);
      resolve();
    };
    views.observe(host);
    if (loading === 'auto') addEventListener('load', end);
    stopped.addEventListener('abort', end);
  });
}

/**
 * Starts watching.
 * @param {HTMLElement} host
 * @param {HTMLCanvasElement} canvas
 * @param {object} tell
 * @param {(width: number, height: number, side: number) => void} tell.resized with the
 *   height, or that of a square of its area, in CSS pixels
 * @param {(visible: boolean) => void} tell.visible
 * @param {(reduced: boolean) => void} tell.motion
 * @returns {{stop: () => void}}
 */
export function watch(host, canvas, tell) {
  const stopped = new AbortController();
  const { signal } = stopped;

  const touch = isTouch();
  const sizes = new ResizeObserver((entries) => {
    const entry = entries[entries.length - 1];
    const density = globalThis.devicePixelRatio || 1;
    const exact = entry.devicePixelContentBoxSize?.[0];
    const side = (/** @type {number} */ css, /** @type {number | undefined} */ counted) => {
      const pixels = css * density;
      // The browser's own count knows how the layout snaps to pixels; where it
      // counts in another unit, as some emulated screens do, it is left alone.
      return counted !== undefined && Math.abs(counted - pixels) <= 1 ? counted : Math.round(pixels);
    };
    const { width, height } = cappedSize(
      side(entry.contentRect.width, exact?.inlineSize),
      side(entry.contentRect.height, exact?.blockSize),
      density,
      touch,
    );
    const css = entry.contentRect;
    tell.resized(width, height, Math.min(css.height, Math.sqrt(css.width * css.height)));
  });
  try {
    sizes.observe(canvas, { box: 'device-pixel-content-box' });
  } catch {
    sizes.observe(canvas);
  }

  let inView = false;
  const look = () => tell.visible(inView && document.visibilityState === 'visible');
  // What only touches the edge of the window counts as intersecting, and is not seen.
  const views = new IntersectionObserver((entries) => {
    inView = entries[entries.length - 1].intersectionRatio > 0;
    look();
  }, { threshold: [0, 1e-6] });
  views.observe(host);
  document.addEventListener('visibilitychange', look, { signal });

  const motion = globalThis.matchMedia?.(REDUCED_MOTION);
  motion?.addEventListener('change', () => tell.motion(motion.matches), { signal });

  return {
    stop() {
      stopped.abort();
      sizes.disconnect();
      views.disconnect();
    },
  };
}
