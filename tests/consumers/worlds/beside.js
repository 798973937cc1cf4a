/**
 * The element beside a fire of another engine, and how much their pictures differ.
 */
import 'hearth-fire';

export const SIDE = 160;

/** An element whose fire is that old, and its picture. */
export async function elementAt(seconds) {
  const element = document.createElement('hearth-fire');
  element.style.cssText = `display: block; width: ${SIDE}px; height: ${SIDE}px`;
  const state = {
    quality: 'low',
    autoplay: 'false',
    seed: '7',
    'ember-rate': '0',
    fit: 'height',
    loading: 'eager',
  };
  for (const [name, value] of Object.entries(state)) element.setAttribute(name, value);
  document.body.append(element);
  await element.pause();
  await element.ready;
  await element.advance(seconds - (element.stats?.time ?? 0));
  return { element, picture: await createImageBitmap(await element.toBlob()) };
}

/** The pixels of a picture over a colour. */
export function read(picture, background) {
  const canvas = new OffscreenCanvas(SIDE, SIDE);
  const context = canvas.getContext('2d');
  context.fillStyle = background;
  context.fillRect(0, 0, SIDE, SIDE);
  context.drawImage(picture, 0, 0, SIDE, SIDE);
  return context.getImageData(0, 0, SIDE, SIDE).data;
}

/** CIE L*a*b* of a colour of eight bits (D65). */
function lab(data, at) {
  const [r, g, b] = [0, 1, 2].map((channel) => {
    const value = data[at + channel] / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  });
  const [x, y, z] = [
    (0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505,
    0.2126 * r + 0.7152 * g + 0.0722 * b,
    (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089,
  ].map((value) => (value > 0.008856 ? Math.cbrt(value) : 7.787 * value + 16 / 116));
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

/** Mean ΔE of two pictures where the second one is not the background, and away from the rim, where a world has no edge. */
export function difference(a, b, background) {
  let [sum, count] = [0, 0];
  for (let at = 0; at < a.length; at += 4) {
    const [x, y] = [(at / 4) % SIDE, Math.floor(at / 4 / SIDE)];
    const isRim = x < 0.1 * SIDE || x > 0.9 * SIDE || y < 0.1 * SIDE;
    if (isRim || [0, 1, 2].every((channel) => Math.abs(b[at + channel] - background) < 6)) continue;
    const [one, other] = [lab(a, at), lab(b, at)];
    sum += Math.hypot(...one.map((value, i) => value - other[i]));
    count += 1;
  }
  return { mean: sum / count, count };
}
