/**
 * Elements with attributes, and a button with an icon.
 */

const SVG = 'http://www.w3.org/2000/svg';

/**
 * An element with attributes and content.
 * @template {keyof HTMLElementTagNameMap} Name
 * @param {Name} name
 * @param {{[attribute: string]: string}} [attributes]
 * @param {(string | Node)[]} content
 */
export function element(name, attributes = {}, ...content) {
  const made = document.createElement(name);
  for (const [attribute, value] of Object.entries(attributes)) made.setAttribute(attribute, value);
  made.append(...content);
  return made;
}

/**
 * @param {string} icon  An SVG path in a square of 24 units.
 * @param {{[name: string]: string}} attributes
 */
export function iconButton(icon, attributes) {
  const button = element('button', { type: 'button', ...attributes });
  const picture = document.createElementNS(SVG, 'svg');
  picture.setAttribute('viewBox', '0 0 24 24');
  picture.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS(SVG, 'path');
  path.setAttribute('d', icon);
  picture.append(path);
  button.append(picture);
  return button;
}
