/**
 * Observes the size of an element, whether it is visible, and whether the visitor prefers reduced
 * motion.
 */

/** Maximum device pixels per CSS pixel: more are invisible in a fire and expensive. */
const MAX_DENSITY = 2;
/** The same on phones and tablets, whose graphics are slower. */
const MAX_DENSITY_TOUCH = 1.5;
/** Maximum side of a canvas, which nearly every graphics card can draw. */
const MAX_SIDE = 8192;

/** How often styles and pixel density are read: no event reports their changes [ms]. */
const READ_MS = 100;

/** @param {string} query */
const media = (query) => globalThis.matchMedia?.(`(${query})`);
const reducedMotion = () => media('prefers-reduced-motion: reduce');

/** Whether the visitor prefers reduced motion. */
export const motionIsReduced = () => reducedMotion()?.matches ?? false;

/** Whether the device is a phone or a tablet. */
const isTouch = () => media('pointer: coarse')?.matches ?? false;

/** The quality that a fire starts with, before its speed is measured. */
export const guess = () => (isTouch() || navigator.hardwareConcurrency <= 2 ? 'low' : 'medium');

/**
 * The size of a canvas within the limits of density and side. The engine limits the number of pixels.
 * @param {number} width in device pixels
 * @param {number} height in device pixels
 * @param {number} density device pixels per CSS pixel
 * @param {boolean} touch
 * @returns {{width: number, height: number}}
 */
export function cappedSize(width, height, density, touch) {
  const scale = Math.min(1, (touch ? MAX_DENSITY_TOUCH : MAX_DENSITY) / density, MAX_SIDE / Math.max(width, height, 1));
  return { width: Math.round(width * scale), height: Math.round(height * scale) };
}

/**
 * Settles when a fire is to be loaded: `eager`, at once; `lazy`, when it comes near the window;
 * `auto`, at once if it is visible, else when the page has loaded.
 *
 * @typedef {'auto' | 'lazy' | 'eager'} Loading
 * @param {HTMLElement} host
 * @param {Loading} loading
 * @param {AbortSignal} stopped ends the wait
 * @returns {Promise<void>}
 */
export async function due(host, loading, stopped) {
  if (loading === 'eager' || (loading === 'auto' && document.readyState === 'complete')) return;
  await new Promise((resolve) => {
    const views = new IntersectionObserver(
      (entries) => entries.some((entry) => entry.isIntersecting) && end(),
      // `lazy` begins half a window before the element is visible.
      { rootMargin: loading === 'lazy' ? '50%' : '0%' },
    );
    const end = () => {
      views.disconnect();
      removeEventListener('load', end);
      stopped.removeEventListener('abort', end);
      resolve(undefined);
    };
    views.observe(host);
    if (loading === 'auto') addEventListener('load', end);
    stopped.addEventListener('abort', end);
  });
}

/** Whether styles show an element, and a transform leaves it an area. @param {HTMLElement} host */
export function isShown(host) {
  const { width, height } = host.getBoundingClientRect();
  const styled =
    host.checkVisibility?.({ opacityProperty: true, visibilityProperty: true, contentVisibilityAuto: true }) ??
    getComputedStyle(host).visibility === 'visible';
  return styled && width * height > 0;
}

/**
 * Starts to observe.
 * @param {HTMLElement} host
 * @param {HTMLCanvasElement} canvas
 * @param {object} on
 * @param {(width: number, height: number, side: number) => void} on.resized with the height in CSS
 *   pixels, or that of a square of its area if it is wider than high
 * @param {(visible: boolean) => void} on.visible
 * @param {(reduced: boolean) => void} on.motion
 * @returns {() => void} stops
 */
export function observe(host, canvas, on) {
  const stopped = new AbortController();
  const touch = isTouch();
  const densityNow = () => globalThis.devicePixelRatio || 1;
  let density = densityNow();
  const sizes = new ResizeObserver((entries) => {
    const { contentRect: css, devicePixelContentBoxSize } = entries[entries.length - 1];
    const exact = devicePixelContentBoxSize?.[0];
    density = densityNow();
    const side = (/** @type {number} */ length, /** @type {number | undefined} */ counted) => {
      const pixels = length * density;
      // The browser's count includes how the layout snaps to pixels. Some emulated screens count in
      // another unit.
      return counted !== undefined && Math.abs(counted - pixels) <= 1 ? counted : Math.round(pixels);
    };
    const { width, height } = cappedSize(
      side(css.width, exact?.inlineSize),
      side(css.height, exact?.blockSize),
      density,
      touch,
    );
    on.resized(width, height, Math.min(css.height, Math.sqrt(css.width * css.height)));
  });
  const measure = () => {
    try {
      sizes.observe(canvas, { box: 'device-pixel-content-box' });
    } catch {
      sizes.observe(canvas);
    }
  };
  measure();

  let inView = false;
  let shown = true;
  const update = () => {
    shown = isShown(host);
    on.visible(inView && shown && document.visibilityState === 'visible');
  };
  // An element that only touches the edge of the window intersects and is invisible.
  const views = new IntersectionObserver(
    (entries) => {
      inView = entries[entries.length - 1].intersectionRatio > 0;
      update();
    },
    { threshold: [0, 1e-6] },
  );
  views.observe(host);
  document.addEventListener('visibilitychange', update, stopped);

  const motion = reducedMotion();
  motion?.addEventListener('change', () => on.motion(motion.matches), stopped);

  const reading = setInterval(() => {
    if (density !== densityNow()) {
      density = densityNow();
      sizes.unobserve(canvas);
      measure();
    }
    if (inView && shown !== isShown(host)) update();
  }, READ_MS);

  return () => {
    stopped.abort();
    clearInterval(reading);
    sizes.disconnect();
    views.disconnect();
  };
}
