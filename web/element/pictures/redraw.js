/**
 * A frame for a saved picture, in another width or over another background. This code is loaded by the first such
 * picture.
 *
 * The engine draws it in place of the next frame. A copy of the last one hides it, and no event reports its values.
 */

import { countdown } from '../../engine/time-limit.js';
import { cut } from '../../quoted.js';

/** Maximum time until the frame is drawn [s]. */
const FRAME_S = 10;

/**
 * Maximum time until a frame as before is drawn, which there is none of if the element has another size meanwhile [s].
 */
const BACK_S = 2;

/** Limits of a side and of the pixels of a picture: those of nearly every graphics card, and of `max-pixels`. */
const MIN_SIDE = 16;
const MAX_SIDE = 8192;
const MAX_PIXELS = 16_777_216;
const MIN_LIMIT = 1024;

/** The picture before, which ends first. @type {Promise<unknown>} */
let before = Promise.resolve();

/**
 * Draws a frame and resolves to what `take` makes of it.
 * @template T
 * @param {import('../session/session.js').FireSession} session
 * @param {HTMLCanvasElement} canvas
 * @param {{width?: number, background?: string}} how
 * @param {() => Promise<T>} take reads the canvas, at once
 * @returns {Promise<T>}
 * @throws {RangeError} a value is refused
 */
export function redraw(session, canvas, how, take) {
  return new Promise((resolve, reject) => {
    before = before.then(() => draw(session, canvas, how, async () => resolve(await take()))).catch(reject);
  });
}

/**
 * @type {(session: import('../session/session.js').FireSession, canvas: HTMLCanvasElement, how: {width?: number,
 *   background?: string}, take: () => Promise<void>) => Promise<void>}
 */
async function draw(session, canvas, { width = canvas.width, background = 'scene' }, take) {
  const height = Math.round((canvas.height * width) / canvas.width);
  const fits = [width, height].every((side) => side >= MIN_SIDE && side <= MAX_SIDE) && width * height <= MAX_PIXELS;
  if (!fits || width % 1 !== 0) {
    throw new RangeError(
      `width ${cut(String(width))}: a picture has whole sides from ${MIN_SIDE} to ${MAX_SIDE} pixels, and at most ${MAX_PIXELS} pixels`,
    );
  }
  const { fire, view } = session;
  /** @type {{[id: string]: string}} */
  const values = background === 'scene' ? {} : { backdrop: 'none', ground: 'none', background };
  const css = getComputedStyle(canvas);
  const [across, up] = [parseFloat(css.width), parseFloat(css.height)];
  const copy = document.createElement('canvas');
  copy.className = 'before';
  copy.setAttribute('aria-hidden', 'true');
  [copy.width, copy.height] = [canvas.width, canvas.height];
  copy.getContext('2d')?.drawImage(canvas, 0, 0);
  canvas.after(copy);
  try {
    // A new limit is drawn, even if nothing else is new.
    session.send('max_pixels', Math.max(width * height, MIN_LIMIT));
    session.send('resize', width, height, Math.min(up, Math.sqrt(across * up)));
    // The answer comes after the frames before.
    await session.change(['set', values], 'picture');
    await next(view, canvas, (frame) => frame.width === width, take);
  } finally {
    session.send('max_pixels', limitOf(fire));
    // A value that has changed meanwhile is the present one.
    const { params } = session.state;
    const ids = /** @type {(keyof typeof params)[]} */ (Object.keys(values));
    const present = Object.fromEntries(ids.map((id) => [id, params[id]]));
    await session.change(['set', present], 'picture').catch(() => {});
    await observedAgain(view, canvas, copy.width);
    copy.remove();
  }
}

/** Waits for a frame of the display, in which the browser also observes sizes. */
function displayed() {
  return new Promise((resolve) => requestAnimationFrame(resolve));
}

/**
 * Makes the element observe its size again and send it to the engine, and waits for a frame of that size. A size that
 * has not changed is not observed.
 * @param {import('../view/view.js').FireView} view
 * @param {HTMLCanvasElement} canvas
 * @param {number} width that of the frame
 */
async function observedAgain(view, canvas, width) {
  canvas.style.inlineSize = 'calc(100% - 8px)';
  await displayed();
  await displayed();
  const drawn = next(
    view,
    canvas,
    (frame) => frame.width === width,
    async () => {},
    BACK_S,
  );
  canvas.style.inlineSize = '';
  await drawn.catch(() => {});
}

/** The limit of pixels that the element's attribute sets. @param {Element} fire */
function limitOf(fire) {
  const pixels = Number(fire.getAttribute('max-pixels') ?? NaN);
  return pixels >= MIN_LIMIT && pixels <= MAX_PIXELS ? pixels : undefined;
}

/**
 * Waits for the next frame of some kind and takes it before another one can follow.
 * @param {import('../view/view.js').FireView} view
 * @param {HTMLCanvasElement} canvas
 * @param {(canvas: HTMLCanvasElement) => boolean} suits
 * @param {() => Promise<void>} take
 * @param {number} [seconds]
 * @returns {Promise<void>}
 */
function next(view, canvas, suits, take, seconds = FRAME_S) {
  return new Promise((resolve, reject) => {
    const { draw: show } = view;
    const end = () => {
      cancel();
      view.draw = show;
    };
    const cancel = countdown(seconds, () => {
      end();
      reject(new Error(`no frame was drawn in ${seconds} s, because the fire is not visible`));
    });
    view.draw = (frame) => {
      show.call(view, frame);
      if (!suits(canvas)) return;
      end();
      take().then(resolve, reject);
    };
  });
}
