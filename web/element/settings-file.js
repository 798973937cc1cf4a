/**
 * Files with settings: loaded where `src` names one.
 */

/**
 * The text of a file; undefined where it is too long, which is found out early.
 * @param {URL} url
 * @param {number} longest in bytes
 */
export async function textOf(url, longest) {
  const response = await fetch(url, { credentials: 'same-origin' });
  if (!response.ok) throw new Error(`the server says ${response.status}`);
  const parts = [];
  const reader = response.body?.getReader();
  for (let length = 0; reader; ) {
    const { done, value } = await reader.read();
    if (done) break;
    length += value.length;
    if (length > longest) {
      reader.cancel().catch(() => {});
      return undefined;
    }
    parts.push(value);
  }
  return new Blob(parts).text();
}
