/**
 * The paper's loop in plain JavaScript, as a yardstick: particle objects, and
 * every particle looks at every other one, twice a step. Written from the
 * paper's equations 1–7 (with the corrections that Hearth makes, so that both
 * compute the same gas); it knows no grid, as the paper's program did not.
 */

const GAS = {
  restDensity: 1,
  ambientDensity: 1.2,
  gasConstant: 0.3,
  viscosity: 0.001,
  buoyancy: 0.12,
  gravity: 0,
};

/** Particles of a block at rest with `neighbours` within two smoothing lengths. */
export class PaperFire {
  /** @param {number} count @param {number} [neighbours] */
  constructor(count, neighbours = 20) {
    this.h = 0.02;
    this.dt = 1 / 480;
    const spacing = 2 * this.h * Math.sqrt(Math.PI / (neighbours + 1));
    this.mass = GAS.restDensity * spacing * spacing;
    const columns = Math.ceil(Math.sqrt(count));
    this.particles = Array.from({ length: count }, (_, i) => ({
      x: ((i % columns) + 0.2 * scatter(i)) * spacing,
      y: (Math.floor(i / columns) + 0.2 * scatter(i + count)) * spacing,
      vx: 0,
      vy: 0,
      ax: 0,
      ay: 0,
      density: 0,
      pressure: 0,
    }));
  }

  /** One step: density and pressure, forces, motion. */
  step() {
    for (const a of this.particles) {
      a.density = 0;
      for (const b of this.particles) {
        a.density += this.mass * this.kernel(distance(a, b));
      }
      a.pressure = Math.max(0, GAS.gasConstant * (a.density - GAS.restDensity));
    }
    for (const a of this.particles) {
      a.ax = 0;
      a.ay = GAS.buoyancy * (GAS.ambientDensity / a.density - 1) * GAS.gravity;
      for (const b of this.particles) {
        if (a !== b) this.push(a, b);
      }
    }
    for (const a of this.particles) {
      a.vx += a.ax * this.dt;
      a.vy += a.ay * this.dt;
      a.x += a.vx * this.dt;
      a.y += a.vy * this.dt;
    }
  }

  /** What `b` does to `a`: pressure and viscosity. */
  push(a, b) {
    const dx = a.x - b.x;
    const dy = a.y - b.y;
    const r = Math.sqrt(dx * dx + dy * dy);
    if (r >= 2 * this.h || r === 0) return;
    const slope = this.slope(r);
    const share = this.mass / (a.density * b.density);
    const pressure = (-share * (a.pressure + b.pressure) * slope) / r;
    const drag = (2 * GAS.viscosity * share * slope * r) / (r * r + 0.01 * this.h * this.h);
    a.ax += pressure * dx + drag * (a.vx - b.vx);
    a.ay += pressure * dy + drag * (a.vy - b.vy);
  }

  /** Cubic spline in two dimensions. */
  kernel(r) {
    const q = r / this.h;
    const norm = 10 / (7 * Math.PI * this.h * this.h);
    if (q < 1) return norm * (1 - 1.5 * q * q + 0.75 * q * q * q);
    const t = 2 - q;
    return t > 0 ? norm * 0.25 * t * t * t : 0;
  }

  /** Its derivative by the distance. */
  slope(r) {
    const q = r / this.h;
    const norm = 10 / (7 * Math.PI * this.h * this.h * this.h);
    if (q < 1) return norm * (2.25 * q * q - 3 * q);
    const t = 2 - q;
    return t > 0 ? -norm * 0.75 * t * t : 0;
  }

  /** Neighbours of a particle within two smoothing lengths, on average. */
  neighbours() {
    let pairs = 0;
    for (const a of this.particles) {
      for (const b of this.particles) {
        if (a !== b && distance(a, b) < 2 * this.h) pairs += 1;
      }
    }
    return pairs / this.particles.length;
  }
}

/** `Math.hypot` is many times slower and would flatter Hearth. */
function distance(a, b) {
  const dx = a.x - b.x;
  const dy = a.y - b.y;
  return Math.sqrt(dx * dx + dy * dy);
}

/** A number from −0.5 to 0.5 that looks like chance and is always the same. */
function scatter(i) {
  const mixed = Math.imul(i ^ (i >>> 15) ^ 0x51, 0x9e3779b9);
  return ((mixed ^ (mixed >>> 15)) >>> 8) / 16777216 - 0.5;
}
