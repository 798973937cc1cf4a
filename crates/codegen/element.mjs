/**
 * Derives what tools and users read about `<hearth-fire>` from the JSDoc of its class:
 * `web/hearth-fire.d.ts`, the names of its own attributes, the reference of its methods in
 * `docs/element.md`, and what an iframe offers to its page: `web/generated/iframe-methods.js`, and lists in
 * `web/embed-client.js` and `docs/iframe.md`. Prints the path of each file that was behind and is written.
 * `node element.mjs FOLDER` writes there what the package alone has: `react.d.ts`, `embed-client.d.ts` and
 * `custom-elements.json`.
 *
 * The class states its methods, accessors, events (`@fires`), slots, parts, custom properties and
 * states; `HearthReflected` in `web/element/types.d.ts` states the properties that only live in
 * an attribute; `web/parameters.js` and `web/parameters.d.ts` state the parameters. An accessor with
 * `@attribute` reflects the attribute of its name with hyphens. A member with `@posted` answers messages of
 * the page around an iframe. `@example` and `@see` are for the reference. `HearthSourceElement` and
 * `HearthSolidElement` in `web/element/types.d.ts` state the children, and the objects of
 * `web/parameters.d.ts` their attributes.
 */
import { readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { API, SyntaxKind } from '../xtask/scripts/typescript.mjs';
import { clientList, clientTypes, iframeMethods, reference as iframeReference } from './element/iframe.mjs';
import { manifest } from './element/manifest.mjs';
import { reference } from './element/reference.mjs';
import { elementTypes, reactTypes } from './element/types.mjs';
import { read } from './element/jsdoc.mjs';

/**
 * @typedef {object} Property
 * @property {string} name
 * @property {string} type  What reading it gives.
 * @property {string} [accepts]  What it can be set to, where that is more.
 * @property {boolean} ofClass
 * @property {boolean} readonly
 * @property {string} [attribute]
 * @property {string} [default]
 * @property {boolean} [posted]
 * @property {string} doc
 *
 * @typedef {{name: string, type: string, optional: boolean, rest: boolean, doc: string}} Argument
 * @typedef {{template?: {name: string, type: string}, parameters: Argument[], returns: string, doc: string}} Signature
 *
 * @typedef {object} Method
 * @property {string} name
 * @property {Signature[]} signatures  The last one takes all calls.
 * @property {boolean} posted
 * @property {string} [see]  The heading of its section in the reference.
 * @property {{label: string, code: string}[]} examples
 *
 * @typedef {{name: string, type: string, doc: string}} Named
 *
 * @typedef {object} Parameter
 * @property {string} id
 * @property {string} attribute
 * @property {string} property
 * @property {string} kind
 * @property {string} type
 * @property {string} default
 * @property {string} doc  Of its property.
 * @property {string} about  The same with unit, defaults and ranges.
 *
 * @typedef {object} Child  An element that is a child of the element.
 * @property {string} tag
 * @property {string} type
 * @property {string} doc
 * @property {Named[]} members
 * @property {Named[]} attributes
 *
 * @typedef {object} Element  The description of the element.
 * @property {string} doc
 * @property {Property[]} properties
 * @property {Method[]} methods
 * @property {Parameter[]} parameters
 * @property {Named[]} events
 * @property {Named[]} slots
 * @property {Named[]} parts
 * @property {Named[]} cssProperties
 * @property {Named[]} states
 * @property {Child[]} children
 * @property {{[file: string]: string[]}} types  The names that each file of types declares.
 */

const ROOT = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const WEB = path.join(ROOT, 'web');

const api = new API({ cwd: ROOT });
try {
  const config = path.join(ROOT, 'tsconfig.json');
  const [project] = api.updateSnapshot({ openProjects: [config] }).getProjects();
  /** The declaration of that name in a file of `web/`. @type {(file: string, name: string) => any} */
  const declared = (file, name) => {
    const source = project.program.getSourceFile(path.join(WEB, file));
    const found = /** @type {any} */ (source?.statements)?.find(
      (statement) => statement.name?.text === name && statement.members,
    );
    if (!found) throw new Error(`web/${file} declares no ${name}`);
    return found;
  };
  /** The types that a file of `web/` exports. @param {string} file @returns {string[]} */
  const exported = (file) => {
    const { statements } = /** @type {any} */ (project.program.getSourceFile(path.join(WEB, file)));
    const types = [SyntaxKind.InterfaceDeclaration, SyntaxKind.TypeAliasDeclaration];
    return [...statements]
      .filter(({ kind }) => types.includes(kind))
      .map(({ name }) => name.text)
      .sort();
  };
  const element = await describe(declared, exported);
  const own = element.properties.flatMap(({ attribute }) => attribute ?? []);
  const { OPTIONS } = await load('pages/url-parameters.js');
  const [folder] = process.argv.slice(2);
  if (folder) {
    await writeFile(path.join(folder, 'react.d.ts'), reactTypes(element));
    await writeFile(path.join(folder, 'embed-client.d.ts'), clientTypes(element, OPTIONS));
    await writeFile(path.join(folder, 'custom-elements.json'), manifest(element));
  } else {
    await refresh('web/hearth-fire.d.ts', elementTypes(element));
    await refresh(
      'web/generated/attributes.js',
      [
        '// Generated from the class in web/hearth-fire.js by `cargo xtask codegen`; edit its JSDoc instead.\n',
        '/** The attributes that are no parameters. */',
        `export const OWN_ATTRIBUTES = [${own.map((name) => `"${name}"`).join(', ')}];\n`,
      ].join('\n'),
    );
    await refresh('web/generated/iframe-methods.js', iframeMethods(element));
    await refreshPart('web/embed-client.js', ['// methods: begin', '// methods: end'], clientList(element));
    await refreshPart('docs/element.md', marks('methods'), `\n${reference(element)}\n`);
    await refreshPart('docs/iframe.md', marks('methods'), `\n${iframeReference(element)}\n`);
  }
} finally {
  api.close();
}

/**
 * @param {(file: string, name: string) => any} declared
 * @param {(file: string) => string[]} exported
 * @returns {Promise<Element>}
 */
async function describe(declared, exported) {
  const type = declared('hearth-fire.js', 'HearthFire');
  const about = read(type);
  const named = (/** @type {string} */ tag) =>
    about.all(tag).map(({ name, type: kind, text }) => ({ name, type: kind, doc: text }));
  const members = [...type.members, ...declared('element/attributes/attributes.js', 'FireAttributes').members].filter(
    isPublic,
  );
  const reflected = [...declared('element/types.d.ts', 'HearthReflected').members];
  const properties = [
    ...members
      .filter(({ kind }) => kind === SyntaxKind.PropertyDeclaration || kind === SyntaxKind.GetAccessor)
      .map((member) => accessor(member, members)),
    ...reflected.filter(({ kind }) => kind !== SyntaxKind.SetAccessor).map((member) => reflection(member, reflected)),
  ];
  return {
    doc: about.doc,
    // A class names what it overrides a second time.
    properties: properties.filter(({ name }, at) => properties.findIndex((other) => other.name === name) === at),
    // The compiler lists an `@overload` as a method without a body.
    methods: members.filter(({ kind, body }) => kind === SyntaxKind.MethodDeclaration && body).map(method),
    parameters: await parameters(declared('parameters.d.ts', 'HearthParameters').members),
    events: named('fires'),
    slots: named('slot'),
    parts: named('csspart'),
    cssProperties: named('cssproperty'),
    states: named('cssstate'),
    children: ['source', 'solid'].map((kind) => child(kind, declared)),
    types: Object.fromEntries(
      ['element/types', 'parameters'].map((file) => [`./${file}.js`, exported(`${file}.d.ts`)]),
    ),
  };
}

/** @type {(kind: string, declared: (file: string, name: string) => any) => Child} */
function child(kind, declared) {
  const name = kind.replace(/^./, (letter) => letter.toUpperCase());
  const type = `Hearth${name}Element`;
  const element = declared('element/types.d.ts', type);
  const isSolid = kind === 'solid';
  const of = {
    name: 'of',
    type: '`#$' + '{string}`',
    doc: `The element of the page whose border box it has${isSolid ? ', or of an image what is opaque in it' : ''}, as \`#\` and an id.`,
  };
  const ofText = {
    name: 'of-text',
    type: 'boolean',
    doc: 'With `of`: it has the shape of the glyphs of that element.',
  };
  const member = (/** @type {any} */ node) => ({
    name: node.name.text,
    // An attribute is a text where a property may be a list as well.
    type: node.type.getText().replace(/^string \|.*/, 'string'),
    doc: read(node).doc,
  });
  const properties = declared('parameters.d.ts', `Hearth${name}`)
    .members.map(member)
    .filter((/** @type {Named} */ property) => property.name !== 'kind' && property.name !== 'id')
    .map((/** @type {Named} */ property) => ({ ...property, name: property.name.replaceAll('_', '-') }));
  // The element that is a solid, or the id of its object.
  for (const property of properties)
    if (property.name === 'solid') property.type = 'number | `#$' + '{string}` | `$' + '{number}`';
  return {
    tag: `hearth-${kind}`,
    type,
    doc: read(element).doc,
    members: element.members.map(member),
    attributes: [of, ...(isSolid ? [ofText] : []), ...properties],
  };
}

/** Whether a member is the page's to use. @param {any} member */
function isPublic({ name }) {
  return name && name.kind !== SyntaxKind.PrivateIdentifier && !/Callback$|^observedAttributes$/.test(name.text);
}

/** @type {(member: any, members: any[]) => Property} */
function accessor(member, members) {
  const name = member.name.text;
  const about = read(member);
  const field = member.kind === SyntaxKind.PropertyDeclaration;
  const settable = field || members.some((other) => other.kind === SyntaxKind.SetAccessor && other.name.text === name);
  return {
    name,
    type: about.first(field ? 'type' : 'returns')?.type ?? missing(name, field ? '@type' : '@returns'),
    ofClass: (member.modifiers ?? []).some((/** @type {any} */ modifier) => modifier.kind === SyntaxKind.StaticKeyword),
    readonly: !settable,
    attribute: about.first('attribute') && hyphened(name),
    default: about.first('default')?.text,
    posted: about.first('posted') !== undefined,
    doc: about.doc,
  };
}

/** @type {(member: any, members: any[]) => Property} */
function reflection(member, members) {
  const name = member.name.text;
  const about = read(member);
  const setter = members.find((other) => other.kind === SyntaxKind.SetAccessor && other.name.text === name);
  return {
    name,
    type: member.type.getText(),
    accepts: setter?.parameters[0].type.getText(),
    ofClass: false,
    readonly: false,
    attribute: hyphened(name),
    default: about.first('default')?.text,
    doc: about.doc,
  };
}

/** @type {(member: any) => Method} */
function method(member) {
  const name = member.name.text;
  const comments = member.jsDoc ?? [];
  const last = read(member);
  return {
    name,
    posted: last.first('posted') !== undefined,
    see: last.first('see')?.text,
    examples: last.all('example').map(({ text }) => {
      const [, label, code] = /^<caption>(.*?)<\/caption> (.*)$/.exec(text) ?? missing(name, 'caption of @example');
      return { label, code };
    }),
    signatures: comments.map((/** @type {any} */ _, /** @type {number} */ at) => {
      const about = read(member, at);
      return {
        doc: about.doc,
        template: about.first('template'),
        parameters: about.all('param').map((parameter) => ({
          name: parameter.name,
          doc: parameter.text,
          optional: parameter.optional,
          rest: parameter.type.startsWith('...'),
          type: parameter.type.startsWith('...') ? `${parameter.type.slice(3)}[]` : parameter.type,
        })),
        returns: about.first('returns')?.type ?? missing(name, '@returns'),
      };
    }),
  };
}

/** @type {(members: any[]) => Promise<Parameter[]>} */
async function parameters(members) {
  const { PARAMETERS } = await load('parameters.js');
  const typed = new Map(members.map((member) => [member.name.text, member]));
  return PARAMETERS.map((/** @type {any} */ parameter) => {
    const member = typed.get(parameter.id);
    return { ...parameter, default: String(parameter.default), type: member.type.getText(), about: read(member).doc };
  });
}

/** Imports a script of `web/`. @param {string} file @returns {Promise<any>} */
function load(file) {
  return import(pathToFileURL(path.join(WEB, file)).href);
}

/** `reducedMotion` → `reduced-motion`. @param {string} name */
function hyphened(name) {
  return name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
}

/** @type {(name: string, tag: string) => never} */
function missing(name, tag) {
  throw new Error(`the JSDoc of ${name} has no ${tag}`);
}

/** Writes a file that is out of date, and prints its name. @param {string} file @param {string} text */
async function refresh(file, text) {
  const target = path.join(ROOT, file);
  const present = await readFile(target, 'utf8').catch(() => '');
  // A checkout on Windows may have turned line ends.
  if (present.replaceAll('\r\n', '\n') === text) return;
  await writeFile(target, text);
  console.log(file);
}

/** The marks around a generated part of a document. @param {string} name */
function marks(name) {
  return [`<!-- ${name}: begin -->\n`, `<!-- ${name}: end -->`];
}

/**
 * Writes what is between two marks of a file if it is out of date.
 * @type {(file: string, marks: string[], text: string) => Promise<void>}
 */
async function refreshPart(file, [begin, end], text) {
  const present = (await readFile(path.join(ROOT, file), 'utf8')).replaceAll('\r\n', '\n');
  const [from, to] = [present.indexOf(begin) + begin.length, present.indexOf(end)];
  if (from < begin.length || to < from) throw new Error(`${file} lacks the marks ${begin.trim()} and ${end}`);
  await refresh(file, present.slice(0, from) + text + present.slice(to));
}
