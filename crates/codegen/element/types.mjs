/**
 * `react.d.ts` of the package: the element in JSX.
 *
 * @typedef {import('../element.mjs').Element} Element
 */

const HEADER = `\
// Generated from the class in web/hearth-fire.js, its types and the table of parameters by
// \`cargo xtask codegen\`; edit the JSDoc of the class or web/element/types.d.ts instead.
`;

/** A number in JSX. */
const NUMBER = 'number | `$' + '{number}`';

/** @param {Element} element */
export function reactTypes({ properties, parameters, events, children, types }) {
  const own = properties.filter(({ attribute }) => attribute);
  const attributes = [
    ...own.map((attribute) => entry(attribute.doc, String(attribute.attribute), attribute.accepts ?? attribute.type)),
    ...parameters.map((parameter) => entry(parameter.about, parameter.attribute, asText(parameter))),
  ].join('');
  const listens = events
    .map((event) => entry(event.doc, `on${event.name}`, `((event: ${event.type}) => void)`))
    .join('');
  const ofChildren = children
    .map(
      ({ tag, attributes: all }) => `
/** The attributes of \`<${tag}>\`; one that is taken away is back at its default. */
export interface ${attributesOf(tag)} {
${all.map(({ name, type, doc }) => entry(doc, name, type === 'number' ? NUMBER : type)).join('')}}
`,
    )
    .join('');
  const elements = children
    .map(
      ({ tag, type }) => `\
      '${tag}': React.DetailedHTMLProps<${attributesOf(tag)} & React.HTMLAttributes<${type}>, ${type}>;
`,
    )
    .join('');
  const names = [...types, 'HearthFire'].sort();
  return `${HEADER}
/**
 * \`<hearth-fire>\` in JSX, for React 19 and newer: \`import 'hearth-fire/react'\`
 * instead of \`'hearth-fire'\`, and attributes and events have their types.
 */

/// <reference path="./react-global.d.cts" />

${imports(names, './hearth-fire.js', `HearthFire ${attributes}${listens}${elements}`)}

export * from './hearth-fire.js';

import React = globalThis.React;

declare module './react-global.cjs' {
  namespace JSX {
    interface IntrinsicElements {
      'hearth-fire': React.DetailedHTMLProps<HearthFireProps, HearthFire>;
${elements}    }
  }
}

/** Everything that \`<hearth-fire>\` takes in JSX. */
export type HearthFireProps = HearthFireAttributes &
  HearthFireListeners &
  Omit<React.HTMLAttributes<HearthFire>, keyof HearthFireAttributes | keyof HearthFireListeners>;

/** The attributes of \`<hearth-fire>\`; one that is taken away is back at its default. */
export interface HearthFireAttributes {
${attributes}}

/** The events of \`<hearth-fire>\`. */
export interface HearthFireListeners {
${listens}}
${ofChildren}`;
}

/**
 * An attribute of JSX; a number may be written as text, as HTML does.
 * @param {import('../element.mjs').Parameter} parameter
 */
function asText({ kind, type }) {
  if (kind === 'number' || kind === 'integer') return NUMBER;
  return kind === 'seed' ? `${NUMBER} | 'auto'` : type;
}

/** `hearth-solid` → `HearthSolidAttributes`. @param {string} tag */
function attributesOf(tag) {
  return `${tag.replace(/(?:^|-)(.)/g, (_, letter) => letter.toUpperCase())}Attributes`;
}

/** @type {(doc: string, name: string, type: string) => string} */
function entry(doc, name, type) {
  return `${comment(doc, '  ')}  ${quoted(name)}?: ${type} | null | undefined;\n`;
}

/** @param {string} name */
export function quoted(name) {
  return name.includes('-') ? `'${name}'` : name;
}

/**
 * The import of those names of a file that a text has.
 * @type {(names: string[], file: string, text: string) => string}
 */
export function imports(names, file, text) {
  const used = names.filter((name) => new RegExp(`\\b${name}\\b`).test(text));
  return `import type {\n${used.map((name) => `  ${name},\n`).join('')}} from '${file}';`;
}

/** @type {(doc: string, indent: string) => string} */
export function comment(doc, indent) {
  return `${indent}/** ${doc} */\n`;
}
