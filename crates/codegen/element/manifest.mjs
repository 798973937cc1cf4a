/**
 * `web/custom-elements.json`: the element for editors, catalogues and the generators of wrappers,
 * in the format that these share, the Custom Elements Manifest.
 *
 * @typedef {import('../element.mjs').Element} Element
 */

const MODULE = 'hearth-fire.js';
const CLASS = 'HearthFire';

/** @param {Element} element */
export function manifest({ doc, properties, methods, parameters, events, slots, parts, cssProperties, states, children }) {
  const own = properties.filter(({ attribute }) => attribute);
  const others = properties.filter(({ attribute }) => !attribute);
  const lists = {
    attributes: [
      ...own.map((one) => ({
        name: one.attribute, fieldName: one.name, type: kind(one.accepts ?? one.type), default: one.default, description: one.doc,
      })),
      ...parameters.map((one) => ({
        name: one.attribute, fieldName: one.property, type: kind(one.type), default: one.default, description: one.about,
      })),
    ],
    members: [
      ...own.map((one) => ({
        kind: 'field',
        name: one.name,
        attribute: one.attribute,
        reflects: true,
        type: kind(one.accepts ?? one.type),
        default: one.default,
        description: one.doc,
      })),
      ...others.map((one) => ({
        kind: 'field',
        name: one.name,
        static: one.ofClass || undefined,
        readonly: one.readonly || undefined,
        type: kind(one.type),
        description: one.doc,
      })),
      ...methods.map(({ name, signatures }) => {
        const { parameters: all, returns, template, doc: description } = /** @type {import('../element.mjs').Signature} */ (signatures.at(-1));
        // The format has no generics.
        const plain = (/** @type {string} */ type) => (template ? type.replace(new RegExp(`\\b${template.name}\\b`, 'g'), template.type) : type);
        return {
          kind: 'method',
          name,
          parameters: all.map((one) => ({
            name: one.name, optional: one.optional || undefined, rest: one.rest || undefined, type: kind(plain(one.type)),
          })),
          return: { type: kind(plain(returns)) },
          description,
        };
      }),
      ...parameters.map((one) => ({
        kind: 'field', name: one.property, attribute: one.attribute, type: kind(one.type), default: one.default, description: one.doc,
      })),
    ],
    events: events.map((one) => ({ name: one.name, type: kind(`CustomEvent<${one.type}>`), description: one.doc })),
    slots: slots.map(named),
    cssParts: parts.map(named),
    cssProperties: cssProperties.map(named),
    cssStates: states.map(named),
  };
  const declaration = { name: CLASS, module: MODULE };
  const ofChildren = children.map((child) => ({
    kind: 'class',
    customElement: true,
    tagName: child.tag,
    name: child.type,
    superclass: { name: 'HTMLElement' },
    description: child.doc,
    attributes: `list of ${child.type}Attributes`,
    members: `list of ${child.type}Members`,
  }));
  /** @type {{[name: string]: object[]}} */
  const all = { ...lists };
  for (const { type, attributes, members } of children) {
    all[`${type}Attributes`] = attributes.map((one) => ({ name: one.name, type: kind(one.type), description: one.doc }));
    all[`${type}Members`] = members.map((one) => ({ kind: 'field', name: one.name, readonly: true, type: kind(one.type), description: one.doc }));
  }
  const text = JSON.stringify({
    schemaVersion: '2.1.0',
    readme: 'README.md',
    modules: [{
      kind: 'javascript-module',
      path: MODULE,
      declarations: [{
        kind: 'class',
        customElement: true,
        tagName: 'hearth-fire',
        name: CLASS,
        superclass: { name: 'HTMLElement' },
        description: doc,
        ...Object.fromEntries(Object.keys(lists).map((name) => [name, `list of ${name}`])),
      }, ...ofChildren],
      exports: [
        { kind: 'js', name: CLASS, declaration },
        { kind: 'custom-element-definition', name: 'hearth-fire', declaration },
        ...children.map(({ tag, type: name }) => ({ kind: 'custom-element-definition', name: tag, declaration: { name, module: MODULE } })),
      ],
    }],
  }, null, 2);
  // One entry a line, so that a change is a line.
  return `${text.replace(/"list of (\w+)"/g, (_, name) => listed(all[name]))}\n`;
}

/** @param {object[]} entries */
function listed(entries) {
  return `[\n${entries.map((entry) => `            ${JSON.stringify(entry)}`).join(',\n')}\n          ]`;
}

/** @param {import('../element.mjs').Named} one */
function named({ name, doc }) {
  return { name, description: doc };
}

/** @param {string} text */
function kind(text) {
  return { text: text.replaceAll('"', "'") };
}
