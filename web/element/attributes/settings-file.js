/**
 * Files with settings. This code is loaded when `src` names one.
 */

/** The maximum time until a file has arrived [ms]. */
const FILE_MS = 10_000;

/**
 * The text of a file. A download that is too long stops early.
 * @param {string} src its URL
 * @param {number} max the maximum length in bytes
 * @param {string} id its name in errors
 * @param {AbortSignal} unwanted ends the download
 * @returns {Promise<string>}
 * @throws {RangeError} it is too long
 * @throws {Error} it did not arrive
 */
export async function textOf(src, max, id, unwanted) {
  const limit = AbortSignal.timeout(FILE_MS);
  // Browsers before 2024 have no `AbortSignal.any`.
  const ended = new AbortController();
  for (const signal of [unwanted, limit]) signal.addEventListener('abort', () => ended.abort());
  if (unwanted.aborted) ended.abort();
  let text;
  try {
    text = await download(new URL(src, document.baseURI), max, ended.signal);
  } catch (error) {
    const why = limit.aborted ? `it did not arrive within ${FILE_MS / 1000} s` : /** @type {Error} */ (error).message;
    throw new Error(`${id} is refused: ${why}`);
  }
  if (text === undefined) throw new RangeError(`${id} is refused: it is longer than ${max / 1000} KB`);
  return text;
}

/** @type {(url: URL, max: number, signal: AbortSignal) => Promise<string | undefined>} */
async function download(url, max, signal) {
  const response = await fetch(url, { credentials: 'same-origin', signal });
  if (!response.ok) throw new Error(`the server answers ${response.status}`);
  const chunks = [];
  const reader = response.body?.getReader();
  for (let length = 0; reader; ) {
    const { done, value } = await reader.read();
    if (done) break;
    length += value.length;
    if (length > max) {
      reader.cancel().catch(() => {});
      return undefined;
    }
    chunks.push(value);
  }
  return new Blob(chunks).text();
}
