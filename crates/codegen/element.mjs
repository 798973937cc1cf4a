/**
 * Derives what tools and users read about `<hearth-fire>` from the JSDoc of its class: the names of its own
 * attributes, the reference of its methods in `docs/element.md`, and what an iframe offers to its page in
 * `web/generated/iframe-methods.js`, `web/embed-client.js` and `docs/iframe.md`. Prints the path of each file that was
 * behind and is written. `node element.mjs FOLDER` writes there what the package alone has: `react.d.ts` and
 * `custom-elements.json`.
 *
 * The class states its methods, accessors, slots, parts, custom properties and states. In `web/element/types.d.ts`,
 * `HearthFireEvents` states the events, `HearthReflected` the properties that only live in an attribute, and
 * `HearthSourceElement` and `HearthSolidElement` the children, whose attributes are the objects of
 * `web/parameters.d.ts`. `web/parameters.js` and `web/parameters.d.ts` state the parameters. An accessor with
 * `@attribute` reflects the attribute of its name with hyphens. A member with `@posted` answers messages of the page
 * around an iframe. `@example` and `@see` are for the reference.
 */
import { readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { API, SyntaxKind } from '../xtask/scripts/typescript.mjs';
import { clientList, iframeMethods, reference as iframeReference } from './element/iframe.mjs';
import { manifest } from './element/manifest.mjs';
import { reference } from './element/reference.mjs';
import { reactTypes } from './element/types.mjs';

/**
 * @typedef {object} Property
 * @property {string} name
 * @property {string} type  What reading it gives.
 * @property {string} [accepts]  What it can be set to, where that is more.
 * @property {boolean} ofClass
 * @property {boolean} readonly
 * @property {string} [attribute]
 * @property {string} [default]
 * @property {boolean} posted
 * @property {string} doc
 *
 * @typedef {{name: string, type: string, optional: boolean, rest: boolean, doc: string}} Argument
 * @typedef {{template?: {name: string, type: string}, parameters: Argument[], returns: string, doc: string}} Signature
 *
 * @typedef {object} Method
 * @property {string} name
 * @property {Signature[]} signatures  The last one takes all calls.
 * @property {boolean} [ofClass]
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
 * @typedef {{tag: string, type: string, doc: string, members: Named[], attributes: Named[]}} Child
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
 * @property {Child[]} children  The elements that are children of the element.
 * @property {string[]} types  The names of all types.
 */

const ROOT = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const WEB = path.join(ROOT, 'web');
/** A field, a property of an interface, or what reads a property. */
const PROPERTIES = [SyntaxKind.PropertyDeclaration, SyntaxKind.PropertySignature, SyntaxKind.GetAccessor];

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
  const [folder] = process.argv.slice(2);
  if (folder) {
    await writeFile(path.join(folder, 'react.d.ts'), reactTypes(element));
    await writeFile(path.join(folder, 'custom-elements.json'), manifest(element));
  } else {
    await refresh(
      'web/generated/attributes.js',
      [
        '// Generated from the class in web/hearth-fire.js by `cargo xtask codegen`; edit its JSDoc instead.\n',
        '/** The attributes that are no parameters. */',
        `export const OWN_ATTRIBUTES = [${own.map((name) => `"${name}"`).join(', ')}];\n`,
      ].join('\n'),
    );
    await refresh('web/generated/iframe-methods.js', iframeMethods(element));
    await refreshPart('web/embed-client.js', ['  // methods: begin\n', '  // methods: end'], clientList(element));
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
  const type = declared('hearth-fire.js', 'FireElement');
  const about = read(type);
  const named = (/** @type {string} */ tag) =>
    about.all(tag).map(({ text }) => {
      const [, name, doc] = /^(\S+) (.*)$/.exec(text) ?? missing(tag, 'text');
      return { name, type: '', doc };
    });
  const members = [...type.members, ...declared('element/attributes/attributes.js', 'FireAttributes').members].filter(
    isPublic,
  );
  const reflected = [...declared('element/types.d.ts', 'HearthReflected').members];
  const properties = [...members, ...reflected]
    .filter(({ kind }) => PROPERTIES.includes(kind))
    .map((member) => property(member, [...members, ...reflected], reflected.includes(member)));
  return {
    doc: about.doc,
    // A class names what it overrides a second time.
    properties: properties.filter(({ name }, at) => properties.findIndex((other) => other.name === name) === at),
    // The compiler lists an `@overload` as a method without a body.
    methods: members
      .filter(({ kind, body }) => kind === SyntaxKind.MethodDeclaration && body)
      .map((last) =>
        method(last, [...members.filter(({ name, body }) => name.text === last.name.text && !body), last]),
      ),
    parameters: await parameters(declared('parameters.d.ts', 'HearthParameters').members),
    events: declared('element/types.d.ts', 'HearthFireEvents').members.map(member),
    slots: named('slot'),
    parts: named('csspart'),
    cssProperties: named('cssproperty'),
    states: named('cssstate'),
    children: ['source', 'solid'].map((kind) => child(kind, declared)),
    types: [...exported('element/types.d.ts'), ...exported('parameters.d.ts')],
  };
}

/** A member of an interface. @param {any} node @returns {Named} */
function member(node) {
  return { name: node.name.text, type: typeOf(node), doc: read(node).doc };
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
  const ofSolid = [
    ['of-text', 'boolean', 'With `of`: it has the shape of the glyphs of that element.'],
    ['text', 'string', 'A word whose letters it has as its shape.'],
    ['font', 'string', 'The font of `text`, as in a style sheet.'],
    ['burning', 'boolean', 'It burns along its outline, by the recipe of the scene *Burning word*.'],
  ].map(([name, kind, doc]) => ({ name, type: kind, doc }));
  const properties = declared('parameters.d.ts', `Hearth${name}`)
    .members.map(member)
    .filter((/** @type {Named} */ property) => property.name !== 'kind' && property.name !== 'id')
    .map((/** @type {Named} */ { name, type, doc }) => ({
      name: name.replaceAll('_', '-'),
      // An attribute is a text where a property may be a list as well.
      type: type.replace(/^string \|.*/, 'string'),
      doc,
    }));
  // The element that is a solid, or the id of its object.
  for (const property of properties)
    if (property.name === 'solid') property.type = 'number | `#$' + '{string}` | `$' + '{number}`';
  return {
    tag: `hearth-${kind}`,
    type,
    doc: read(element).doc,
    members: element.members.map(member),
    attributes: [of, ...(isSolid ? ofSolid : []), ...properties],
  };
}

/** Whether a member is the page's to use. @param {any} member */
function isPublic({ name }) {
  return name && name.kind !== SyntaxKind.PrivateIdentifier && !/Callback$|^observedAttributes$/.test(name.text);
}

/** @type {(node: any, all: any[], reflects: boolean) => Property} */
function property(node, all, reflects) {
  const name = node.name.text;
  const about = read(node);
  const setter = all.find((other) => other.kind === SyntaxKind.SetAccessor && other.name.text === name);
  const accepted = setter?.parameters[0].type;
  return {
    name,
    type: typeOf(node),
    accepts: accepted && flat(accepted.getText()),
    ofClass: isStatic(node),
    readonly: node.kind === SyntaxKind.GetAccessor && !setter,
    attribute: reflects || about.first('attribute') ? hyphened(name) : undefined,
    default: about.first('default')?.text,
    posted: about.first('posted') !== undefined,
    doc: about.doc,
  };
}

/** Whether a member is one of the class. @param {any} node @returns {boolean} */
function isStatic({ modifiers = [] }) {
  return modifiers.some((/** @type {any} */ { kind }) => kind === SyntaxKind.StaticKeyword);
}

/** @type {(node: any, signatures: any[]) => Method} */
function method(node, signatures) {
  const name = node.name.text;
  const last = read(node);
  return {
    name,
    ofClass: isStatic(node),
    posted: last.first('posted') !== undefined,
    see: last.first('see')?.name,
    examples: last.all('example').map(({ text }) => {
      const [, label, code] = /^<caption>(.*?)<\/caption> (.*)$/.exec(text) ?? missing(name, 'caption of @example');
      return { label, code };
    }),
    signatures: signatures.map((signature, at) => {
      const about = read(node, at);
      const [template] = signature.typeParameters ?? [];
      return {
        doc: about.doc,
        template: template && { name: template.name.text, type: flat(template.constraint.getText()) },
        parameters: [...signature.parameters].map((parameter) => ({
          name: parameter.name.text,
          doc: about.all('param').find((tag) => tag.name === parameter.name.text)?.text ?? '',
          optional: Boolean(parameter.questionToken),
          rest: Boolean(parameter.dotDotDotToken),
          type: typeOf(parameter).replace(/^\.\.\.(.*)/, '$1[]'),
        })),
        returns: typeOf(signature),
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
    return { ...parameter, default: String(parameter.default), type: typeOf(member), about: read(member).doc };
  });
}

/**
 * The JSDoc of a node as the compiler parses it: its last comment, or that at `at`.
 * @param {any} node
 * @param {number} [at]
 */
function read(node, at = -1) {
  const comment = [...(node.jsDoc ?? [])].at(at);
  const tags = [...(comment?.tags ?? [])].map((tag) => ({
    tag: tag.tagName.text,
    // Of a parameter, or of a section that `@see` names.
    name: (tag.name ?? tag.nameExpression)?.getText(),
    text: textIn(tag),
  }));
  return {
    doc: textIn(comment),
    all: (/** @type {string} */ tag) => tags.filter((entry) => entry.tag === tag),
    first: (/** @type {string} */ tag) => tags.find((entry) => entry.tag === tag),
  };
}

/** The text of a comment or of a tag. @param {any} node */
function textIn(node) {
  const parts = [...(node?.comment ?? [])];
  return flat(parts.map((part) => (part.kind === SyntaxKind.JSDocText ? part.text : part.getText())).join(''));
}

/** A text as one line. @param {string} text */
function flat(text) {
  return text.replace(/\s+/g, ' ').trim();
}

/** The type that a node states. @param {any} node */
function typeOf(node) {
  return flat(node.type?.getText() ?? missing(node.name.text, 'type'));
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
