/**
 * Fails unless two folders contain the same site: `node same.mjs OURS THEIRS`. White space of pages
 * may differ.
 */
import { differences } from './bytes.mjs';

const [ours, theirs] = process.argv.slice(2);
const withoutLayout = (/** @type {Buffer} */ html) => html.toString().split(/\s+/).join(' ').trim();
const found = await differences(ours, theirs, (name, bytes) => (name.endsWith('.html') ? withoutLayout(bytes) : bytes));
for (const difference of found) console.error(difference);
if (found.length) process.exitCode = 1;
