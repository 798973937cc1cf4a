/**
 * Files with settings. This code is loaded when `src` names one.
 */

/**
 * The text of a file. A download that is too long stops early.
 * @param {string} src its URL
 * @param {number} max the maximum length in bytes
 * @param {string} id its name in errors
 * @returns {Promise<string>}
 * @throws {RangeError} it is too long
 * @throws {Error} it did not arrive
 */
export async function textOf(src, max, id) {
  let text;
  try {
    text = await download(new URL(src, document.baseURI), max);
  } catch (error) {
    throw new Error(`${id} is refused: ${/** @type {Error} */ (error).message}`);
  }
  if (text === undefined) throw new RangeError(`${id} is refused: it is longer than ${max / 1024} KiB`);
  return text;
}

/** @type {(url: URL, max: number) => Promise<string | undefined>} */
async function download(url, max) {
  const response = await fetch(url, { credentials: 'same-origin' });
  if (!response.ok) throw new Error(`the server answers ${response.status}`);
  const parts = [];
  const reader = response.body?.getReader();
  for (let length = 0; reader; ) {
    const { done, value } = await reader.read();
    if (done) break;
    length += value.length;
    if (length > max) {
      reader.cancel().catch(() => {});
      return undefined;
    }
    parts.push(value);
  }
  return new Blob(parts).text();
}
