/**
 * The objects attached to a source: a drag of the source moves its logs and stones, too.
 *
 * @typedef {{kind: string, id: number, x: number, y: number, [name: string]: any}} Fields
 */

/** The largest gap between attached objects, in widths of the source. */
const MAX_GAP = 1 / 8;

/**
 * Half of width and height of the box of an object before it is turned [m].
 * @type {(object: any) => [number, number]}
 */
export function halvesOf({ kind, shape, width, height, points }) {
  if (kind === 'source') return [width / 2, 0];
  if (shape === 'polygon' || shape === 'stroke') {
    const line = shape === 'stroke' ? height / 2 : 0;
    const all = String(points)
      .split(/[\s,]+/)
      .map(Number);
    const reach = (/** @type {number} */ axis) =>
      line + Math.max(...all.filter((_, at) => at % 2 === axis).map(Math.abs));
    return [reach(0), reach(1)];
  }
  const half = (shape === 'circle' ? width : height) / 2;
  return [width / 2 + (shape === 'line' ? half : 0), half];
}

/** Half of width and height of the upright box of an object [m]. @param {Fields} object */
function extentOf(object) {
  const [along, across] = halvesOf(object);
  const turn = object.shape === 'circle' ? 0 : ((object.angle ?? 0) * Math.PI) / 180;
  const [cosine, sine] = [Math.abs(Math.cos(turn)), Math.abs(Math.sin(turn))];
  return [cosine * along + sine * across, sine * along + cosine * across];
}

/**
 * The objects that touch the first source or each other, or nearly. Excluded are fuels, moving objects, children with a
 * target, and objects as wide as the domain.
 * @param {import('../../hearth-fire.js').HearthFire} fire
 * @returns {Fields[]} copies of the objects
 */
export function attachedObjects(fire) {
  const objects = /** @type {Fields[]} */ (/** @type {unknown} */ (fire.objects));
  const first = objects.find(({ kind }) => kind === 'source');
  if (!first) return [];
  const followers = /** @type {any[]} */ ([...fire.querySelectorAll(':scope>[of]')]).map(({ objectId }) => objectId);
  const candidates = objects.filter(
    (object) =>
      object !== first &&
      object.shape !== 'solid' &&
      (object.fuel ?? 'none') === 'none' &&
      (object.motion ?? 'still') === 'still' &&
      !followers.includes(object.id) &&
      2 * extentOf(object)[0] < fire.params.domain_width,
  );
  const gap = MAX_GAP * first.width;
  const group = [first];
  // The group grows while the loop goes through it.
  for (const object of group) {
    const [wide, high] = extentOf(object);
    for (const other of [...candidates]) {
      const [across, up] = extentOf(other);
      if (Math.abs(other.x - object.x) > wide + across + gap || Math.abs(other.y - object.y) > high + up + gap)
        continue;
      group.push(other);
      candidates.splice(candidates.indexOf(other), 1);
    }
  }
  return group.slice(1);
}
