/** The link of a fire, which the system's share sheet or the clipboard gets. */

import { pageLink } from '../share.js';

/**
 * Shares the link of a fire, and nothing else, by the system or by the clipboard.
 * @param {import('../hearth-fire.js').HearthFire} fire
 */
export async function shareLink(fire) {
  const url = await pageLink(await fire.exportConfig(), location.href);
  if (!navigator.share) return navigator.clipboard.writeText(url);
  // A visitor may close the sheet.
  return navigator.share({ url }).catch((error) => error.name === 'AbortError' || Promise.reject(error));
}
