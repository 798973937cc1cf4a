/**
 * Fails unless two folders contain the same site: `node same.mjs OURS THEIRS`. White space of pages
 * may differ, and Trunk builds no pages of text.
 */
import { differences } from './bytes.mjs';

const [ours, theirs] = process.argv.slice(2);
const withoutLayout = (/** @type {Buffer} */ html) => html.toString().split(/\s+/).join(' ').trim();
const found = await differences(ours, theirs, (name, bytes) => (name.endsWith('.html') ? withoutLayout(bytes) : bytes));
const unexpected = found.filter((difference) => !/^(docs\/|404\.html)/.test(difference));
for (const difference of unexpected) console.error(difference);
if (unexpected.length) process.exitCode = 1;
