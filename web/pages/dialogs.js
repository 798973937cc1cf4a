/**
 * The dialogs of the page: what Hearth is, and the code that embeds the fire in another page.
 */

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
  if (id === 'embed') await (await import('./embed/dialog.js')).openEmbed(dialog, fire);
  else dialog.showModal();
}

/** @param {HTMLDialogElement} dialog */
function prepare(dialog) {
  // The fire's shortcuts do not work in a dialog.
  dialog.addEventListener('keydown', (event) => event.stopPropagation());
  dialog.addEventListener('click', (event) => {
    // The dialog has no padding, so this is its backdrop.
    if (event.target === dialog) dialog.close();
  });
}
