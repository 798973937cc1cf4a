/**
 * The reference of the methods in `docs/element.md`: a table, and a page with a button for each example.
 *
 * @typedef {import('../element.mjs').Element} Element
 * @typedef {import('../element.mjs').Method} Method
 */

/** @param {Element} element */
export function reference({ methods }) {
  const rows = methods.flatMap((method) => methodRows(method, '')).join('');
  const buttons = methods
    .flatMap(({ examples }) => examples)
    .map(({ label, code }) => `<button onclick="${code}">${label}</button>\n`)
    .join('');
  return `| method | |\n|---|---|\n${rows}
\`\`\`html
<!doctype html>
<script type="module" src="./web/hearth-fire.js"></script>
<hearth-fire id="fire" style="width: 320px; height: 400px"></hearth-fire>
${buttons}\`\`\`
`;
}

/**
 * The rows of a method: one for each signature.
 * @param {Method} method
 * @param {string} page  The document of the sections that rows name.
 */
export function methodRows({ name, signatures, see }, page) {
  return seen(signatures).map(({ doc, parameters }) => {
    const names = parameters.map(
      (parameter) => (parameter.rest ? `…${parameter.name}` : parameter.name) + (parameter.optional ? '?' : ''),
    );
    const described = parameters
      .filter((parameter) => parameter.doc)
      .map((parameter) => `\`${parameter.name}\`: ${parameter.doc}`)
      .join('; ');
    const section = see && `See [${see}](${page}#${see.toLowerCase()}).`;
    return row(`${name}(${names.join(', ')})`, [doc, described && `${described}.`, section].filter(Boolean).join(' '));
  });
}

/** @type {(code: string, doc: string) => string} */
export function row(code, doc) {
  return `| \`${code}\` | ${doc.replace(/\{@link (\w+)\}/g, '`$1`').replaceAll('|', '\\|')} |\n`;
}

/**
 * The signatures that a caller sees: one that takes all calls of the others is the implementation's.
 * @param {import('../element.mjs').Signature[]} signatures
 */
function seen(signatures) {
  return signatures.length > 1 ? signatures.slice(0, -1) : signatures;
}
