/** Copies a text, and shows it for browsers that let no page copy. */

/**
 * @param {HTMLTextAreaElement} field
 * @param {HTMLElement} status
 * @param {string} text
 */
export async function copyText(field, status, text) {
  field.value = text;
  field.hidden = false;
  try {
    await navigator.clipboard.writeText(text);
    status.textContent = 'Copied.';
  } catch {
    field.focus();
    field.select();
    status.textContent = 'This browser does not let the page copy. Copy the selected text yourself.';
  }
}
