/**
 * The solids that forces move, from all numbers of one, then of the next.
 * @param {ArrayLike<number>} numbers
 */
export function freeSolidsOf(numbers) {
  return Array.from({ length: numbers.length / 11 }, (_, at) => {
    const [id, x, y, cosine, sine, u, v, spin, mass, asleep, object] = Array.from(numbers).slice(11 * at);
    return {
      id,
      x,
      y,
      angle: (Math.atan2(sine, cosine) * 180) / Math.PI,
      u,
      v,
      spin,
      mass,
      asleep: asleep > 0,
      object,
    };
  });
}
