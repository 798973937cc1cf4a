/**
 * The dialogs of the page: what Hearth is, and the code that embeds the fire in another page, which are in its HTML, and the
 * one that saves the fire.
 */

import { onLightPage, shownAs } from '../editing/exchange.js';
import { elementCode, iframeCode } from '../share.js';

/** The dialogs that have their listeners. @type {Set<string>} */
const ready = new Set();

/**
 * Opens the dialog of that id.
 * @param {string} id
 * @param {import('../hearth-fire.js').HearthFire} fire
 */
export async function openDialog(id, fire) {
  if (id === 'save') {
    const { openRecorder } = await import('../record/dialog.js');
    openRecorder(fire);
    return;
  }
  const dialog = /** @type {HTMLDialogElement} */ (document.getElementById(id));
  if (!ready.has(id)) prepare(dialog);
  ready.add(id);
  if (id === 'embed') await embed(dialog, fire);
  dialog.showModal();
  for (const field of dialog.querySelectorAll('textarea')) showAll(field);
}

/** Fits the height of a field to its text, and scrolls to the start. @param {HTMLTextAreaElement} field */
function showAll(field) {
  field.style.height = 'auto';
  field.style.height = `${field.scrollHeight + field.offsetHeight - field.clientHeight}px`;
  field.setSelectionRange(0, 0);
  field.scrollTop = 0;
}

/** @param {HTMLDialogElement} dialog */
function prepare(dialog) {
  // The fire's shortcuts do not work in a dialog.
  dialog.addEventListener('keydown', (event) => event.stopPropagation());
  dialog.addEventListener('click', (event) => {
    // The dialog has no padding, so this is its backdrop.
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
        if (copied) copied.textContent = 'This browser does not let the page copy. Copy the selected text yourself.';
      }
    });
  }
  dialog.addEventListener('close', () => copied?.replaceChildren());
}

/**
 * Fills in the code of the current fire, again when the page on which it stands becomes light or dark.
 * @param {HTMLDialogElement} dialog
 * @param {import('../hearth-fire.js').HearthFire} fire
 */
async function embed(dialog, fire) {
  const config = await fire.exportConfig();
  const shown = shownAs(fire);
  const light = /** @type {HTMLInputElement} */ (dialog.querySelector('#light-page'));
  const fill = () => write(dialog, light.checked ? onLightPage(config) : config, shown);
  light.onchange = fill;
  await fill();
}

/**
 * Fills in code.
 * @param {HTMLDialogElement} dialog
 * @param {import('../share.js').HearthSharedConfig} config
 * @param {import('../share.js').HearthShown} shown
 */
async function write(dialog, config, shown) {
  const beside = (/** @type {string} */ file) => new URL(`../${file}`, import.meta.url);
  const codes = {
    element: elementCode(config, beside('hearth-fire.js'), shown),
    iframe: await iframeCode(config, beside('embed.html'), shown).catch(({ message }) => message),
    module: `import 'hearth-fire';\n\n${elementCode(config, undefined, shown)}`,
  };
  for (const [what, code] of Object.entries(codes)) {
    const field = /** @type {HTMLTextAreaElement} */ (dialog.querySelector(`[data-code="${what}"]`));
    field.value = code;
  }
}
