/**
 * The panel of sliders, in any element of a page.
 *
 * `mountPanel` makes a canvas in `host`, loads the panel's wasm, which no page
 * pays for that never asks for it, and puts a mirror of the panel in the page's
 * own controls beside it (mirror.js). Where the panel cannot start it says so
 * in words and the mirror alone is left, in sight.
 */

import { mountMirror } from './mirror.js';

/** How often a panel whose WebGL context was lost is started again. */
const RESTARTS = 3;

/**
 * The module of the panel's wasm, loaded once for all panels of a page; a load
 * that failed is tried again by the next panel.
 *
 * @type {Promise<any> | undefined}
 */
let loading;

function load() {
  loading ??= (async () => {
    const wasm = await import('./wasm/hearth-panel.js');
    await wasm.default({ module_or_path: new URL('./wasm/hearth-panel_bg.wasm', import.meta.url) });
    return wasm;
  })().catch((error) => {
    loading = undefined;
    throw error;
  });
  return loading;
}

/**
 * The style sheet beside this file, once for each document or shadow root.
 *
 * @param {HTMLElement} host
 * @returns {Promise<void>}
 */
function addStyle(host) {
  const root = host.getRootNode();
  const place = root instanceof ShadowRoot ? root : document.head;
  const href = new URL('./panel.css', import.meta.url).href;
  const links = [...place.querySelectorAll('link[rel=stylesheet]')];
  if (links.some((link) => /** @type {HTMLLinkElement} */ (link).href === href)) {
    return Promise.resolve();
  }
  const link = document.createElement('link');
  link.rel = 'stylesheet';
  link.href = href;
  return new Promise((resolve) => {
    link.onload = link.onerror = () => resolve();
    place.append(link);
  });
}

/**
 * Keeps a panel at the bottom of the window above the keyboard on the screen,
 * which some browsers lay over the page.
 *
 * @param {HTMLElement} host
 * @returns {() => void} ends it
 */
function stayAboveKeyboard(host) {
  const viewport = window.visualViewport;
  if (!viewport) return () => {};
  const move = () => {
    const root = /** @type {Document | ShadowRoot} */ (host.getRootNode());
    const typing = host.contains(root.activeElement);
    const hidden = window.innerHeight - viewport.height - viewport.offsetTop;
    // A zoomed page has a small viewport too; only a keyboard is this high.
    const keyboard = typing && viewport.scale === 1 && hidden > 100 ? hidden : 0;
    const sheet = host.offsetHeight < viewport.height;
    host.style.translate = keyboard && sheet ? `0 ${-keyboard}px` : '';
    host.style.paddingBottom = keyboard && !sheet ? `${keyboard}px` : '';
  };
  viewport.addEventListener('resize', move);
  return () => {
    viewport.removeEventListener('resize', move);
    host.style.translate = '';
    host.style.paddingBottom = '';
  };
}

/**
 * Shows the panel of a fire in an element that has a size.
 *
 * @param {{host: HTMLElement, fire: any}} place where, and for which
 *   `<hearth-fire>` (anything with its methods, properties and events will do)
 * @returns {Promise<{destroy(): void}>} settles when the panel stands, or when
 *   it is clear, and said in the panel's place, that it cannot
 */
export async function mountPanel({ host, fire }) {
  let ended = false;
  let restarts = 0;
  /** @type {any} */
  let panel;
  /** @type {HTMLCanvasElement | undefined} */
  let canvas;
  host.classList.add('hearth-panel');
  const styled = addStyle(host);
  let revealed = '';
  const reveal = (id) => {
    revealed = id;
    panel?.reveal(id);
  };
  const mirror = mountMirror({ host, fire, reveal });
  const leaveKeyboard = stayAboveKeyboard(host);

  const update = () => {
    if (canvas) mirror.place(panel?.rectangles() ?? {}, canvas.getBoundingClientRect());
  };
  // eframe sizes the canvas from `devicePixelContentBoxSize`, which emulated
  // phones report at a ratio of 1: the panel would be painted too large.
  const sharpen = () => {
    if (!canvas || !panel) return;
    const width = Math.round(canvas.clientWidth * window.devicePixelRatio);
    const height = Math.round(canvas.clientHeight * window.devicePixelRatio);
    if (Math.abs(canvas.width - width) <= 1 && Math.abs(canvas.height - height) <= 1) return;
    canvas.width = width;
    canvas.height = height;
    panel.repaint();
  };
  const painted = () =>
    queueMicrotask(() => {
      sharpen();
      update();
    });
  const lost = (event) => {
    event.preventDefault();
    stop();
    if (!ended && restarts++ < RESTARTS) setTimeout(start, 200);
    else if (!ended) say('its drawing context was lost');
  };

  function stop() {
    canvas?.removeEventListener('webglcontextlost', lost);
    canvas?.removeEventListener('panel-painted', painted);
    panel?.destroy();
    panel = undefined;
    // A browser allows only some contexts on a page: give this one back now.
    canvas?.getContext('webgl2')?.getExtension('WEBGL_lose_context')?.loseContext();
    canvas?.remove();
    canvas = undefined;
  }

  /** @param {string} reason */
  function say(reason) {
    if (host.querySelector('.hearth-panel-message')) return;
    const message = document.createElement('p');
    message.className = 'hearth-panel-message';
    message.setAttribute('role', 'alert');
    message.textContent = `The panel cannot be shown: ${reason}. Here are plain controls instead.`;
    host.prepend(message);
    mirror.stand();
  }

  async function start() {
    if (ended) return;
    const place = document.createElement('canvas');
    place.setAttribute('aria-hidden', 'true');
    canvas = place;
    host.prepend(place);
    try {
      const [wasm] = await Promise.all([load(), styled]);
      if (ended) return;
      const started = await wasm.Panel.start(place, fire);
      if (ended) {
        started.destroy();
        return;
      }
      panel = started;
      // The mirror may have had the focus before there was a panel.
      if (revealed) panel.reveal(revealed);
      place.addEventListener('webglcontextlost', lost);
      place.addEventListener('panel-painted', painted);
    } catch (error) {
      place.remove();
      canvas = undefined;
      if (ended) return;
      say(error instanceof Error ? error.message : String(error));
    }
  }

  window.addEventListener('scroll', update, { passive: true, capture: true });
  window.addEventListener('resize', update);
  await start();

  return {
    destroy() {
      if (ended) return;
      ended = true;
      window.removeEventListener('scroll', update, { capture: true });
      window.removeEventListener('resize', update);
      leaveKeyboard();
      stop();
      mirror.destroy();
      host.querySelector('.hearth-panel-message')?.remove();
      host.classList.remove('hearth-panel');
    },
  };
}
