/**
 * A fire's settings from a JSON file: what the attribute `src` names.
 */

/** Longest file that is read, in bytes. */
const LONGEST = 65_536;

/**
 * The text of the file.
 * @param {string} src as the attribute has it
 * @returns {Promise<string>}
 * @throws {Error} in words that name the file
 */
export async function readSettings(src) {
  const failed = (why) => new Error(`src = "${src}" is refused: ${why}`);
  let response;
  try {
    response = await fetch(new URL(src, document.baseURI), { credentials: 'same-origin' });
  } catch (error) {
    throw failed(error instanceof Error ? error.message : error);
  }
  if (!response.ok) throw failed(`the server says ${response.status}`);
  const reader = response.body?.getReader();
  const parts = [];
  for (let length = 0; reader; ) {
    const { done, value } = await reader.read();
    if (done) break;
    length += value.length;
    if (length > LONGEST) {
      reader.cancel().catch(() => {});
      throw failed('it has more than 64 KiB');
    }
    parts.push(value);
  }
  return new Blob(parts).text();
}
