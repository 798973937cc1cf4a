/**
 * The paper's program, without drawing: particles are objects, and each looks at every other one, twice a
 * step. Numbers in brackets are the paper's equations.
 *
 * Three of them are corrected, or the gas would explode: the factor of the kernel is that of two dimensions
 * (1), the Laplacian of the kernel never changes its sign (4), and forces on a volume of gas are divided by its
 * density (5, 7). None changes the time of a step by much.
 */

/**
 * @typedef {object} Gas
 * @property {number} smoothing  The smoothing length h [m].
 * @property {number} mass  Of a particle [kg/m].
 * @property {number} restDensity  [kg/m³]
 * @property {number} ambientDensity  [kg/m³]
 * @property {number} gasConstant  [m²/s²]
 * @property {number} viscosity  [Pa·s]
 * @property {number} buoyancy
 * @property {number} gravity  [m/s²]
 * @property {number} timeStep  [s]
 */

/**
 * @typedef {object} Particle
 * @property {number} x
 * @property {number} y
 * @property {number} vx
 * @property {number} vy
 * @property {number} ax
 * @property {number} ay
 * @property {number} density
 * @property {number} pressure
 * @property {number} life  Time until it is removed [s].
 */

/** Density of gas so thin that a force would grow without limit [kg/m³]. */
const MIN_DENSITY = 0.3;

/** Time until a particle is removed [s]: longer than any measurement. */
const LIFE = 1e6;

export class PaperLoop {
  /**
   * @param {Gas} gas
   * @param {ArrayLike<number>} positions  x and y of each particle [m].
   */
  constructor(gas, positions) {
    this.gas = gas;
    this.positions = positions;
    /** @type {Particle[]} */
    this.particles = [];
    this.rewind();
  }

  /** Restores the particles of the start, at rest. */
  rewind() {
    const { positions } = this;
    this.particles = Array.from({ length: positions.length / 2 }, (_, at) => ({
      x: positions[2 * at],
      y: positions[2 * at + 1],
      vx: 0,
      vy: 0,
      ax: 0,
      ay: 0,
      density: 0,
      pressure: 0,
      life: LIFE,
    }));
  }

  /** One loop: densities and pressures, forces, motion. */
  step() {
    for (const one of this.particles) this.findDensity(one);
    for (const one of this.particles) this.findAcceleration(one);
    for (const one of this.particles) move(one, this.gas.timeStep);
    this.particles = this.particles.filter((one) => one.life > 0);
  }

  /** Density (2) and pressure. @param {Particle} one */
  findDensity(one) {
    const { smoothing, mass, gasConstant, restDensity } = this.gas;
    one.density = 0;
    for (const other of this.particles) {
      one.density += mass * kernel(distance(one, other), smoothing);
    }
    one.pressure = Math.max(0, gasConstant * (one.density - restDensity));
  }

  /** Pressure (3), viscosity (4) and buoyancy (7), divided by the density (5). @param {Particle} one */
  findAcceleration(one) {
    const { smoothing, mass, viscosity, buoyancy, ambientDensity, gravity } = this.gas;
    const density = Math.max(MIN_DENSITY, one.density);
    let fx = 0;
    let fy = -buoyancy * (one.density - ambientDensity) * gravity;
    for (const other of this.particles) {
      const r = distance(one, other);
      if (other === one || r >= 2 * smoothing || r === 0) continue;
      const volume = mass / Math.max(MIN_DENSITY, other.density);
      const slope = kernelSlope(r, smoothing);
      const push = (-volume * 0.5 * (one.pressure + other.pressure) * slope) / r;
      // The Laplacian of the kernel is replaced by one that never changes its sign.
      const drag = (-2 * viscosity * volume * slope) / r;
      fx += push * (one.x - other.x) + drag * (other.vx - one.vx);
      fy += push * (one.y - other.y) + drag * (other.vy - one.vy);
    }
    one.ax = fx / density;
    one.ay = fy / density;
  }
}

/** Euler's method with the new velocity (§3.1.2). @param {Particle} one @param {number} dt */
function move(one, dt) {
  one.vx += one.ax * dt;
  one.vy += one.ay * dt;
  one.x += one.vx * dt;
  one.y += one.vy * dt;
  one.life -= dt;
}

/** The cubic spline (1). @param {number} r @param {number} h */
function kernel(r, h) {
  const q = r / h;
  const norm = 10 / (7 * Math.PI * h * h);
  if (q < 1) return norm * (1 - 1.5 * q * q + 0.75 * q * q * q);
  return q < 2 ? norm * 0.25 * (2 - q) ** 3 : 0;
}

/** Its derivative by the distance. @param {number} r @param {number} h */
function kernelSlope(r, h) {
  const q = r / h;
  const norm = 10 / (7 * Math.PI * h * h * h);
  if (q < 1) return norm * (2.25 * q * q - 3 * q);
  return q < 2 ? -norm * 0.75 * (2 - q) ** 2 : 0;
}

/** Far faster than `Math.hypot`, which would flatter Hearth. @param {Particle} a @param {Particle} b */
function distance(a, b) {
  const dx = a.x - b.x;
  const dy = a.y - b.y;
  return Math.sqrt(dx * dx + dy * dy);
}
