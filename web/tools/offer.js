/**
 * The button that shows and hides the toolbar of a fire. The toolbar's code is loaded with the first press.
 */

/** A pencil. */
const ICON = 'M4 20l1-5L16 4l4 4L9 19zM13 7l4 4';

/**
 * Lets a button show and hide the toolbar.
 * @param {object} parts
 * @param {HTMLElement} parts.button
 * @param {HTMLElement} parts.host  Gets the toolbar.
 * @param {import('../hearth-fire.js').HearthFire} parts.fire
 * @param {boolean} [parts.page]  Whether the page is about this fire.
 * @param {(shown: boolean) => void} [parts.shown]
 * @param {(why: unknown) => void} parts.failed
 * @returns {() => void} removes the toolbar
 */
export function offerTools({ button, host, fire, page, shown = () => {}, failed }) {
  /** @type {Promise<{destroy(): void}> | undefined} */
  let mounted;
  const show = (/** @type {boolean} */ open) => {
    button.setAttribute('aria-expanded', String(open));
    shown(open);
  };
  const close = () => {
    const tools = mounted;
    mounted = undefined;
    show(false);
    tools?.then((one) => one.destroy(), () => {});
  };
  const open = () => {
    show(true);
    const closed = () => {
      close();
      button.focus();
    };
    const opening = import('../tools.js').then(({ mountTools }) => mountTools({ host, fire, page, closed }));
    mounted = opening;
    opening.catch((why) => {
      if (mounted === opening) close();
      failed(why);
    });
  };
  button.addEventListener('click', () => (mounted ? close() : open()));
  return close;
}

/**
 * Offers the toolbar inside a fire.
 * @param {import('../hearth-fire.js').HearthFire} fire
 * @param {(why: unknown) => void} failed
 * @returns {() => void} removes the button and the toolbar
 */
export function offerInside(fire, failed) {
  const host = document.createElement('div');
  host.className = 'hands';
  const button = document.createElement('button');
  button.type = 'button';
  button.className = 'hearth-fold hearth-draw';
  button.setAttribute('aria-label', 'Tools');
  button.setAttribute('aria-expanded', 'false');
  button.title = 'Draw, move and erase things';
  const icon = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  icon.setAttribute('viewBox', '0 0 24 24');
  icon.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
  path.setAttribute('d', ICON);
  icon.append(path);
  button.append(icon);
  fire.shadowRoot?.append(host, button);
  const close = offerTools({ button, host, fire, failed });
  return () => {
    close();
    host.remove();
    button.remove();
  };
}
