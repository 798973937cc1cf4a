/**
 * The button that shows and hides the toolbar of a fire. The toolbar's code is loaded with the first press.
 */

/**
 * Lets a button show and hide the toolbar.
 * @param {object} options
 * @param {HTMLElement} options.button
 * @param {HTMLElement} options.host  Gets the toolbar.
 * @param {import('../hearth-fire.js').HearthFire} options.fire
 * @param {boolean} [options.page]  Whether the page is about this fire.
 * @param {(shown: boolean) => void} [options.shown]
 * @param {(why: unknown) => void} options.failed
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
    tools?.then(
      (toolbar) => toolbar.destroy(),
      () => {},
    );
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
