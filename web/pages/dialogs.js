/**
 * The dialogs of the page, as the HTML has them: what Hearth is, and the code that puts
 * the fire onto another page.
 */

import { elementCode, iframeCode } from '../share.js';

/** What the page itself gives its fire: the element's code gives it as well. */
const MANNERS = 'warm interactive';

/** The dialogs whose buttons work. @type {Set<string>} */
const ready = new Set();

/**
 * Opens the dialog of that id.
 * @param {string} id
 * @param {import('../hearth-fire.js').HearthFire} fire
 */
export async function openDialog(id, fire) {
  const dialog = /** @type {HTMLDialogElement} */ (document.getElementById(id));
  if (!ready.has(id)) prepare(dialog);
  ready.add(id);
  if (id === 'embed') write(dialog, await fire.exportConfig());
  dialog.showModal();
}

/** @param {HTMLDialogElement} dialog */
function prepare(dialog) {
  // A key in a dialog does not reach the fire.
  dialog.addEventListener('keydown', (event) => event.stopPropagation());
  dialog.addEventListener('click', (event) => {
    // Its padding is its children's, so this is the ground around it.
    if (event.target === dialog) dialog.close();
  });
  const copied = dialog.querySelector('#copied');
  for (const button of dialog.querySelectorAll('[data-copies]')) {
    button.addEventListener('click', async () => {
      const what = /** @type {HTMLElement} */ (button).dataset.copies;
      const field = /** @type {HTMLTextAreaElement} */ (dialog.querySelector(`[data-code="${what}"]`));
      field.select();
      try {
        await navigator.clipboard.writeText(field.value);
        if (copied) copied.textContent = 'Copied.';
      } catch {
        field.focus();
        if (copied) copied.textContent = 'This browser lets the page copy nothing. The text is selected: copy it by hand.';
      }
    });
  }
  dialog.addEventListener('close', () => copied?.replaceChildren());
}

/**
 * Writes the code of the fire as it burns now.
 * @param {HTMLDialogElement} dialog
 * @param {import('../share.js').HearthSharedConfig} config
 */
function write(dialog, config) {
  const beside = (/** @type {string} */ file) => new URL(`../${file}`, import.meta.url);
  const within = (/** @type {string} */ html) => html.replace('></hearth-fire>', ` ${MANNERS}></hearth-fire>`);
  const codes = {
    element: within(elementCode(config, beside('hearth-fire.js'))),
    iframe: iframeCode(config, beside('embed.html')),
    module: `import 'hearth-fire';\n\n${within(elementCode(config))}`,
  };
  for (const [what, code] of Object.entries(codes)) {
    const field = /** @type {HTMLTextAreaElement} */ (dialog.querySelector(`[data-code="${what}"]`));
    field.value = code;
  }
}
