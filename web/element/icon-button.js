/**
 * A button with an icon.
 */

const SVG = 'http://www.w3.org/2000/svg';

/**
 * @param {string} icon  An SVG path in a square of 24 units.
 * @param {{[name: string]: string}} attributes
 */
export function iconButton(icon, attributes) {
  const button = document.createElement('button');
  for (const [name, value] of Object.entries({ type: 'button', ...attributes })) button.setAttribute(name, value);
  const picture = document.createElementNS(SVG, 'svg');
  picture.setAttribute('viewBox', '0 0 24 24');
  picture.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS(SVG, 'path');
  path.setAttribute('d', icon);
  picture.append(path);
  button.append(picture);
  return button;
}
