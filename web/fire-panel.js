/**
 * The panel of sliders inside an element, where it has the attribute `controls`. Its
 * code is loaded only then.
 */

/**
 * Shows the panel of a fire.
 * @param {HTMLElement} fire
 * @param {ShadowRoot} root
 * @param {(why: unknown) => void} fail
 * @returns {() => void} takes it away
 */
export function showPanel(fire, root, fail) {
  const host = document.createElement('div');
  host.className = 'panel';
  host.setAttribute('part', 'panel');
  root.append(host);
  let ended = false;
  /** @type {{destroy(): void} | undefined} */
  let panel;
  import('./panel.js')
    .then(({ mountPanel }) => (ended ? undefined : mountPanel({ host, fire })))
    .then((mounted) => {
      panel = mounted;
      if (ended) panel?.destroy();
    })
    .catch((error) => {
      host.remove();
      if (!ended) fail(error);
    });
  return () => {
    ended = true;
    panel?.destroy();
    host.remove();
  };
}
