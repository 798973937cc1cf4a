/**
 * The panel of sliders, in any element of a page.
 *
 * `mountPanel` makes a canvas in `host`, loads the panel's wasm on demand, and adds the accessible
 * controls, which are native controls of the page (panel/accessible-controls.js). If the panel cannot
 * start, a message says why and the accessible controls become visible instead. In the shadow root
 * of its own fire the panel places itself and can be folded away.
 */

import { mountAccessibleControls } from './panel/accessible-controls.js';
import { PanelController } from './panel/controller.js';
import { addFold } from './panel/fold.js';
import { listenToKeys } from './panel/keys.js';
import { addSheet } from './panel/sheet.js';
import { addStyle } from './panel/style.js';

/** How often a panel whose WebGL context was lost is started again. */
const RESTARTS = 3;

/**
 * The module of the panel's wasm, loaded once for all panels of a page; a load
 * that failed is tried again by the next panel.
 *
 * @type {Promise<typeof import('./wasm/hearth-panel.js')> | undefined}
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
 * Shows the panel of a fire in an element that has a size, or in the fire's own
 * shadow root.
 *
 * @param {object} place
 * @param {HTMLElement} place.host  Where.
 * @param {import('./hearth-fire.js').HearthFire} place.fire  For which `<hearth-fire>`; anything with its methods,
 *   properties and events will do.
 * @param {string | URL} [place.page]  The address of the page, where it is a page for
 *   this fire and shows what its query says: the panel copies links to it, hears its
 *   keys where the focus is nowhere too, and its full screen is the whole page.
 * @param {string | URL} [place.script]  Where other pages find `hearth-fire.js`, for the HTML
 *   that the panel copies, if that is not beside this module.
 * @param {string | URL} [place.embed]  And where they find `embed.html`.
 * @param {string[]} [place.only]  The ids of the parameters that it shows, in this order;
 *   without it, all of them.
 * @returns {Promise<{destroy(): void}>} settles when the panel stands, or when
 *   it is clear, and said in the panel's place, that it cannot
 */
export async function mountPanel({ host, fire, page, script, embed, only }) {
  let ended = false;
  let restarts = 0;
  /** @type {import('./wasm/hearth-panel.js').Panel | undefined} */
  let panel;
  /** @type {HTMLElement | undefined} */
  let stage;
  /** @type {HTMLCanvasElement | undefined} */
  let canvas;
  /** What ends each part of the panel, the last one first. @type {(() => void)[]} */
  const ends = [];

  /** @param {() => void} end */
  const atEnd = (end) => ends.push(end);
  /** @type {(target: EventTarget, name: string, listener: (event: any) => void, options?: AddEventListenerOptions) => void} */
  const listen = (target, name, listener, options) => {
    target.addEventListener(name, listener, options);
    atEnd(() => target.removeEventListener(name, listener, options));
  };

  function destroy() {
    if (ended) return;
    ended = true;
    for (const end of ends.reverse()) end();
  }

  const root = host.getRootNode();
  const inside = root instanceof ShadowRoot && root.host === fire;
  host.classList.add('hearth-panel');
  atEnd(() => host.classList.remove('hearth-panel'));
  const { styled, removeStyle } = addStyle(host);
  atEnd(removeStyle);
  // Without the styles the accessible controls would be visible for a moment.
  await styled;
  const controller = new PanelController({ fire, host, page, script, embed, only });
  atEnd(() => controller.close());
  let revealed = '';
  const reveal = (/** @type {string} */ id) => {
    revealed = id;
    panel?.reveal(id);
  };
  const accessible = mountAccessibleControls({ host, fire, controller, reveal });
  atEnd(() => accessible.destroy());
  const fold = inside ? addFold(host) : undefined;
  atEnd(fold?.remove ?? stayAboveKeyboard(host));
  if (inside || page !== undefined) atEnd(addSheet(host, inside ? fire : undefined));
  atEnd(listenToKeys({ own: [host, fire], page: page !== undefined, fire, controller, hide: fold?.toggle }));
  // Nothing around the panel is closed by a key that closes things in it.
  listen(host, 'keydown', (event) => {
    if (event.key !== 'Escape') return;
    event.preventDefault();
    event.stopPropagation();
  });

  const update = () => {
    if (!canvas) return;
    const shown = canvas.getBoundingClientRect();
    accessible.place(/** @type {Record<string, number[]>} */ (panel?.rectangles() ?? {}), shown, shown.width / canvas.offsetWidth || 1);
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
  const lost = (/** @type {Event} */ event) => {
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
    stage?.remove();
    stage = canvas = undefined;
  }

  /** @param {string} reason */
  function say(reason) {
    if (host.querySelector('.hearth-panel-message')) return;
    const message = document.createElement('p');
    message.className = 'hearth-panel-message';
    message.setAttribute('role', 'alert');
    message.textContent = `The panel cannot be shown: ${reason}. Here are plain controls instead.`;
    host.prepend(message);
    atEnd(() => message.remove());
    accessible.stand();
  }

  async function start() {
    if (ended || plain.matches) return;
    stage = document.createElement('div');
    stage.className = 'hearth-panel-stage';
    // eframe takes the focus when it starts; in here it cannot.
    stage.inert = true;
    const place = document.createElement('canvas');
    place.setAttribute('aria-hidden', 'true');
    stage.append(place);
    canvas = place;
    host.prepend(stage);
    try {
      const wasm = await load();
      if (ended) return;
      const started = await wasm.Panel.start(place, fire, controller);
      if (ended) {
        started.destroy();
        return;
      }
      panel = started;
      stage.inert = false;
      panel.tell(controller.state);
      controller.hovered = () => panel?.hovered();
      // The accessible controls may have had the focus before there was a panel.
      if (revealed) panel.reveal(revealed);
      place.addEventListener('webglcontextlost', lost);
      place.addEventListener('panel-painted', painted);
    } catch (error) {
      stage?.remove();
      stage = canvas = undefined;
      if (ended) return;
      say(error instanceof Error ? error.message : String(error));
    }
  }

  // A canvas has the colours that it has: where the system's are wanted, the page's own
  // controls stand in its place.
  const plain = matchMedia('(forced-colors: active)');
  const stand = () => {
    accessible.stand(plain.matches);
    if (plain.matches) stop();
    else if (!panel) start();
  };
  listen(plain, 'change', stand);
  if (plain.matches) accessible.stand();
  atEnd(stop);
  listen(controller, 'search', () => {
    if (plain.matches || !canvas?.checkVisibility()) return;
    canvas.focus({ preventScroll: true });
    panel?.reveal('search');
  });
  listen(controller, 'change', () => panel?.tell(controller.state));
  // A drag, however long, and a key that is held down are one step each.
  listen(host, 'pointerdown', () => controller.press(), { capture: true });
  listen(window, 'keydown', (event) => event.repeat || controller.press(), { capture: true });
  listen(window, 'scroll', update, { passive: true, capture: true });
  listen(window, 'resize', update);
  await start();
  return { destroy };
}
