/**
 * `web/hearth-fire.d.ts`: the element's class for TypeScript; `react.d.ts` of the package: the element in JSX.
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
export function elementTypes({ doc, properties, methods, events, children, types }) {
  const members = [
    ...properties.map((member) => `${comment(member.doc, '  ')}${property(member)}`),
    ...methods.flatMap((method) => declarations(method)),
    listeners('HearthFire'),
  ];
  const body = `\
${comment('The events of a fire.', '')}\
export interface HearthFireEventMap extends Omit<HTMLElementEventMap, 'error'> {
${events.map((event) => `${comment(event.doc, '  ')}  ${quoted(event.name)}: CustomEvent<${event.type}>;\n`).join('')}}

/** Every parameter is a property as well; a value out of range is refused aloud and changes nothing. */
export interface HearthFire extends HearthProperties {}

${comment(`The class of \`<hearth-fire>\`. ${doc}`, '')}\
export class HearthFire extends HTMLElement {
${members.join('')}}

declare global {
  interface HTMLElementTagNameMap {
    'hearth-fire': HearthFire;
${children.map(({ tag, type }) => `    '${tag}': ${type};\n`).join('')}  }
}
`;
  return `${HEADER}
${Object.entries(types)
  .map(([file, names]) => `${imports(names, file, body)}\n`)
  .join('')}
export type * from './element/types.js';
export type * from './parameters.js';

${body}`;
}

/** @param {Element} element */
export function reactTypes({ properties, parameters, events, children, types }) {
  const own = properties.filter(({ attribute }) => attribute);
  const attributes = [
    ...own.map((attribute) => entry(attribute.doc, String(attribute.attribute), attribute.accepts ?? attribute.type)),
    ...parameters.map((parameter) => entry(parameter.about, parameter.attribute, asText(parameter))),
  ].join('');
  const listens = events
    .map((event) => entry(event.doc, `on${event.name}`, `((event: CustomEvent<${event.type}>) => void)`))
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
  const names = [...Object.values(types).flat(), 'HearthFire'].sort();
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

/** @param {import('../element.mjs').Property} property */
function property({ name, type, accepts, ofClass, readonly }) {
  if (accepts) return `  get ${name}(): ${type};\n  set ${name}(value: ${accepts});\n`;
  return `  ${ofClass ? 'static ' : ''}${readonly ? 'readonly ' : ''}${name}: ${type};\n`;
}

/**
 * The declaration of each signature that a caller sees.
 * @param {import('../element.mjs').Method} method
 */
export function declarations({ name, signatures }) {
  return seen(signatures).map(
    (signature) =>
      `${described(signature)}  ${name}${signature.template ? `<${signature.template.name} extends ${signature.template.type}>` : ''}(${signature.parameters.map(argument).join(', ')}): ${signature.returns};\n`,
  );
}

/**
 * The signatures that a caller sees: one that takes all calls of the others is the implementation's.
 * @param {import('../element.mjs').Signature[]} signatures
 */
export function seen(signatures) {
  return signatures.length > 1 ? signatures.slice(0, -1) : signatures;
}

/** The comment of a signature. @param {import('../element.mjs').Signature} signature */
function described({ doc, parameters }) {
  const documented = parameters.filter((parameter) => parameter.doc);
  if (documented.length === 0) return comment(doc, '  ');
  const lines = [doc, ...documented.map((parameter) => `@param ${parameter.name} ${parameter.doc}`)];
  return `  /**\n${lines.map((line) => `   * ${line}\n`).join('')}   */\n`;
}

/** @param {import('../element.mjs').Argument} argument */
function argument({ name, type, optional, rest }) {
  return `${rest ? '...' : ''}${name}${optional ? '?' : ''}: ${type}`;
}

/**
 * The two methods for the events of `type`, whose map of events is `${type}EventMap`.
 * @param {string} type
 */
export function listeners(type) {
  return ['add', 'remove']
    .map((verb) => {
      const options = `options?: boolean | ${verb === 'add' ? 'AddEventListenerOptions' : 'EventListenerOptions'},`;
      return `\
  ${verb}EventListener<Type extends keyof ${type}EventMap>(
    type: Type,
    listener: (this: ${type}, event: ${type}EventMap[Type]) => unknown,
    ${options}
  ): void;
  ${verb}EventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    ${options}
  ): void;
`;
    })
    .join('');
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
