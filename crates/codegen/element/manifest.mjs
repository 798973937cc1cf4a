/**
 * `custom-elements.json` of the package: the element for editors, catalogues and the generators of
 * wrappers, in the format that these share, the Custom Elements Manifest.
 *
 * @typedef {import('../element.mjs').Element} Element
 */

const MODULE = 'hearth-fire.js';
const CLASS = 'HearthFire';

/** @param {Element} element */
export function manifest({
  doc,
  properties,
  methods,
  parameters,
  events,
  slots,
  parts,
  cssProperties,
  states,
  children,
}) {
  const own = properties.filter(({ attribute }) => attribute);
  const others = properties.filter(({ attribute }) => !attribute);
  const lists = {
    attributes: [
      ...own.map((property) => ({
        name: property.attribute,
        fieldName: property.name,
        type: kind(property.accepts ?? property.type),
        default: property.default,
        description: property.doc,
      })),
      ...parameters.map((parameter) => ({
        name: parameter.attribute,
        fieldName: parameter.property,
        type: kind(parameter.type),
        default: parameter.default,
        description: parameter.about,
      })),
    ],
    members: [
      ...own.map((property) => ({
        kind: 'field',
        name: property.name,
        attribute: property.attribute,
        reflects: true,
        type: kind(property.accepts ?? property.type),
        default: property.default,
        description: property.doc,
      })),
      ...others.map((property) => ({
        kind: 'field',
        name: property.name,
        static: property.ofClass || undefined,
        readonly: property.readonly || undefined,
        type: kind(property.type),
        description: property.doc,
      })),
      ...methods.map(({ name, signatures, ofClass }) => {
        const {
          parameters: all,
          returns,
          template,
          doc: description,
        } = /** @type {import('../element.mjs').Signature} */ (signatures.at(-1));
        // The format has no generics.
        const plain = (/** @type {string} */ type) =>
          template ? type.replace(new RegExp(`\\b${template.name}\\b`, 'g'), template.type) : type;
        return {
          kind: 'method',
          name,
          static: ofClass || undefined,
          parameters: all.map((parameter) => ({
            name: parameter.name,
            optional: parameter.optional || undefined,
            rest: parameter.rest || undefined,
            type: kind(plain(parameter.type)),
          })),
          return: { type: kind(plain(returns)) },
          description,
        };
      }),
      ...parameters.map((parameter) => ({
        kind: 'field',
        name: parameter.property,
        attribute: parameter.attribute,
        type: kind(parameter.type),
        default: parameter.default,
        description: parameter.doc,
      })),
    ],
    events: events.map((event) => ({
      name: event.name,
      type: kind(event.type),
      description: event.doc,
    })),
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
    attributes: child.attributes.map(({ name, type, doc: description }) => ({ name, type: kind(type), description })),
    members: child.members.map(({ name, type, doc: description }) => ({
      kind: 'field',
      name,
      readonly: true,
      type: kind(type),
      description,
    })),
  }));
  const whole = {
    schemaVersion: '2.1.0',
    readme: 'README.md',
    modules: [
      {
        kind: 'javascript-module',
        path: MODULE,
        declarations: [
          {
            kind: 'class',
            customElement: true,
            tagName: 'hearth-fire',
            name: CLASS,
            superclass: { name: 'HTMLElement' },
            description: doc,
            ...lists,
          },
          ...ofChildren,
        ],
        exports: [
          { kind: 'js', name: CLASS, declaration },
          { kind: 'custom-element-definition', name: 'hearth-fire', declaration },
          ...children.map(({ tag, type: name }) => ({
            kind: 'custom-element-definition',
            name: tag,
            declaration: { name, module: MODULE },
          })),
        ],
      },
    ],
  };
  return `${JSON.stringify(whole)}\n`;
}

/** @param {import('../element.mjs').Named} entry */
function named({ name, doc }) {
  return { name, description: doc };
}

/** @param {string} text */
function kind(text) {
  return { text: text.replaceAll('"', "'") };
}
