/**
 * The panel of sliders, in any element of a page.
 *
 * `mountPanel` makes a canvas in `host`, loads the panel's wasm on demand, and adds the accessible
 * controls, which are native controls of the page (panel/accessible-controls.js). If the panel cannot
 * start, a message gives the reason and the accessible controls become visible instead. In the shadow root
 * of its own fire the panel has a position of its own and can be folded.
 */

import { element } from './element/controls/icon-button.js';
import { mountAccessibleControls } from './panel/accessible-controls.js';
import { PanelController } from './panel/controller.js';
import { addFold } from './panel/fold.js';
import { listenToKeys } from './panel/keys.js';
import { listenToDrops } from './panel/own-scenes.js';
import { addSheet } from './panel/sheet.js';
import { addStyle, check, optionsOf } from './editing/style.js';
import { addTooltip } from './panel/tooltip.js';
import { zoomKey } from './panel/zoom-keys.js';
import { speakerControls } from './sound/speaker.js';

/** The maximum time until the panel's wasm arrives [ms]. */
const WASM_MS = 120_000;

/** How often a panel restarts after it lost its WebGL context. */
const RESTARTS = 3;

/**
 * The module of the panel's wasm, loaded once for all panels of a page. After a failure the next panel
 * tries again.
 *
 * @type {Promise<typeof import('./wasm/hearth-panel.js')> | undefined}
 */
let loading;

function load() {
  loading ??= (async () => {
    const wasm = await import('./wasm/hearth-panel.js');
    const url = new URL('./wasm/hearth-panel_bg.wasm', import.meta.url);
    await wasm.default({ module_or_path: fetch(url, { signal: AbortSignal.timeout(WASM_MS) }) });
    return wasm;
  })().catch((error) => {
    loading = undefined;
    throw error;
  });
  return loading;
}

/**
 * Keeps a panel at the bottom of the window above the on-screen keyboard, which some browsers lay over
 * the page.
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
    // A zoomed page has a small viewport as well; only a keyboard is this high.
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
 * Shows the panel of a fire in an element that has a size, or in the fire's own shadow root.
 *
 * @param {object} options
 * @param {HTMLElement} options.host  The element that receives the panel.
 * @param {import('./hearth-fire.js').HearthFire} options.fire  The `<hearth-fire>` that the panel controls, or any
 *   object with its methods, properties and events.
 * @param {string | URL} [options.page]  The URL of the page, if the page is about this fire and applies its
 *   URL parameters. The panel then copies links to it, handles its keys while nothing has the focus, and
 *   its full screen is the whole page.
 * @param {string | URL} [options.script]  The URL of `hearth-fire.js` in the HTML that the panel copies, if it
 *   is not beside this module.
 * @param {string | URL} [options.embed]  The URL of `embed.html` in that HTML.
 * @param {string[]} [options.only]  The ids of the parameters to show, in this order; all parameters without
 *   it.
 * @returns {Promise<{destroy(): void}>} settles when the panel is shown, or when a message in its place reports
 *   why it is not
 */
export async function mountPanel(options) {
  const { host, fire, page, script, embed, only } = optionsOf(options);
  for (const [name, address] of Object.entries({ page, script, embed }))
    check(name, 'a text or a URL', /^(undefined|string)$/.test(typeof address) || address instanceof URL);
  const areIds = only === undefined || (Array.isArray(only) && only.every((id) => typeof id === 'string'));
  check('only', 'a list of ids', areIds);
  let ended = false;
  let restarts = 0;
  /** @type {import('./wasm/hearth-panel.js').Panel | undefined} */
  let panel;
  /** @type {HTMLElement | undefined} */
  let stage;
  /** @type {HTMLCanvasElement | undefined} */
  let canvas;
  /** Why there is no panel. @type {HTMLElement | undefined} */
  let message;
  /** Ends each part of the panel, the last one first. @type {(() => void)[]} */
  const ends = [];

  /** @param {() => void} end */
  const atEnd = (end) => ends.push(end);
  /**
   * @type {(target: EventTarget, name: string, listener: (event: any) => void, options?: AddEventListenerOptions) =>
   *   void}
   */
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
  const { styled, removeStyle } = addStyle(host, new URL('./panel/panel.css', import.meta.url).href);
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
  // The page of a fire has a speaker button of its own; a panel of chosen parameters shows these alone.
  if (inside || (page === undefined && only === undefined && fire instanceof Node)) {
    const speaker = speakerControls(fire, inside ? 'hearth-fold hearth-speaker' : 'hearth-speaker');
    host.append(...speaker.parts);
    atEnd(speaker.remove);
  }
  if (inside || page !== undefined) atEnd(addSheet(host, inside ? fire : undefined));
  atEnd(listenToKeys({ own: [host, fire], page: page !== undefined, fire, controller, hide: fold?.toggle, zoomKey }));
  atEnd(listenToDrops(host, page === undefined ? [fire, host] : [document], (file) => controller.open(file)));
  // Escape closes things in the panel, not the dialog around it.
  listen(host, 'keydown', (event) => {
    if (event.key !== 'Escape') return;
    event.preventDefault();
    event.stopPropagation();
  });

  const tooltip = addTooltip(host);
  atEnd(() => tooltip.remove());
  const update = () => {
    if (!canvas) return;
    const shown = canvas.getBoundingClientRect();
    const scale = shown.width / canvas.offsetWidth || 1;
    accessible.position(/** @type {Record<string, number[]>} */ (panel?.rectangles() ?? {}), shown, scale);
    const [text, top, height] = panel?.tooltip() ?? [];
    tooltip.show(text && [text, shown.y + top * scale, height * scale]);
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
  const painted = () => {
    queueMicrotask(() => {
      sharpen();
      update();
    });
  };
  const lost = (/** @type {Event} */ event) => {
    event.preventDefault();
    stop();
    if (!ended && restarts++ < RESTARTS) setTimeout(start, 200);
    else if (!ended) warn('its graphics context was lost');
  };

  function stop() {
    canvas?.removeEventListener('webglcontextlost', lost);
    canvas?.removeEventListener('panel-painted', painted);
    panel?.destroy();
    panel = undefined;
    // The number of contexts on a page is limited: this one is released at once.
    canvas?.getContext('webgl2')?.getExtension('WEBGL_lose_context')?.loseContext();
    stage?.remove();
    stage = canvas = undefined;
    tooltip.show();
  }

  /** Shows a message and the accessible controls. @param {string} reason */
  function warn(reason) {
    const again = element('button', { type: 'button' }, 'Try again');
    again.addEventListener('click', start);
    const words = `The panel cannot be shown: ${reason}. These plain controls replace it. `;
    message = element('p', { class: 'hearth-panel-message', role: 'alert' }, words, again);
    accessible.show(true, message);
  }

  async function start() {
    if (ended || plain.matches) return;
    message?.remove();
    accessible.show(false);
    stage = document.createElement('div');
    stage.className = 'hearth-panel-stage';
    const target = document.createElement('canvas');
    target.setAttribute('aria-hidden', 'true');
    // egui smooths edges itself. Four samples a pixel would only cost time and memory; eframe takes this context over.
    target.getContext('webgl2', { antialias: false, depth: false });
    canvas = target;
    host.prepend(stage);
    try {
      const wasm = await load();
      if (ended) return;
      // eframe adds a text field to the tree of its canvas, which takes the focus in a document.
      const tree = new DocumentFragment();
      tree.append(target);
      const started = await wasm.Panel.start(target, fire, controller);
      if (ended) {
        started.destroy();
        return;
      }
      panel = started;
      stage.append(tree);
      // eframe scrolls the page to canvas and text field when it gives them the focus.
      for (const element of /** @type {HTMLCollectionOf<HTMLElement>} */ (stage.children)) {
        element.focus = () => HTMLElement.prototype.focus.call(element, { preventScroll: true });
      }
      panel.update(controller.state);
      controller.hovered = () => panel?.hovered();
      // An accessible control may have had the focus before the panel started.
      if (revealed) panel.reveal(revealed);
      target.addEventListener('webglcontextlost', lost);
      target.addEventListener('panel-painted', painted);
    } catch (error) {
      stage?.remove();
      stage = canvas = undefined;
      if (ended) return;
      warn(error instanceof Error ? error.message : String(error));
    }
  }

  // Forced colours do not reach a canvas: the accessible controls replace it.
  const plain = matchMedia('(forced-colors: active)');
  const replace = () => {
    accessible.show(plain.matches);
    if (plain.matches) stop();
    else if (!panel) start();
  };
  listen(plain, 'change', replace);
  if (plain.matches) accessible.show();
  atEnd(stop);
  listen(controller, 'search', () => {
    if (plain.matches || !canvas?.checkVisibility()) return;
    canvas.focus({ preventScroll: true });
    panel?.reveal('search');
  });
  listen(controller, 'change', () => panel?.update(controller.state));
  // A drag is one step of the undo history, and so is a key that is held down.
  listen(host, 'pointerdown', () => controller.press(), { capture: true });
  listen(window, 'keydown', (event) => event.repeat || controller.press(), { capture: true });
  listen(window, 'scroll', update, { passive: true, capture: true });
  listen(window, 'resize', update);
  await start();
  return { destroy };
}
