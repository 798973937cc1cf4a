/**
 * The paper's loop in plain JavaScript: particle objects, and all pairs twice a step. It
 * follows equations 1–7 of the paper with Hearth's corrections, so that both compute the
 * same gas, and has no grid, like the paper's program.
 */
import { GAS, MASS, lift } from './gas.mjs';

export class PaperFire {
  /** @param {import('./gas.mjs').Start} start */
  constructor(start) {
    this.start = start;
    this.rewind();
  }

  /** Goes back to the start. */
  rewind() {
    const { positions, velocities } = this.start;
    this.particles = Array.from({ length: positions.length / 2 }, (_, i) => ({
      x: positions[2 * i],
      y: positions[2 * i + 1],
      vx: velocities[2 * i],
      vy: velocities[2 * i + 1],
      ax: 0,
      ay: 0,
      density: 0,
      pressure: 0,
      temperature: GAS.temperature,
      age: 0,
    }));
  }

  /** One step: density and pressure, forces, motion. */
  step() {
    for (const a of this.particles) {
      a.density = 0;
      for (const b of this.particles) {
        a.density += MASS * kernel(distance(a, b));
      }
      a.pressure = Math.max(0, GAS.gasConstant * (a.density - GAS.restDensity));
    }
    for (const a of this.particles) {
      a.ax = 0;
      a.ay = lift(a.density, a.temperature, a.vy);
      for (const b of this.particles) {
        if (a !== b) push(a, b);
      }
    }
    for (const a of this.particles) {
      a.vx += a.ax * GAS.timeStep;
      a.vy += a.ay * GAS.timeStep;
      a.x += a.vx * GAS.timeStep;
      a.y += a.vy * GAS.timeStep;
      const cooled = a.temperature - GAS.coolingRate * GAS.timeStep;
      a.temperature = Math.max(GAS.ambientTemperature, cooled);
      a.age += GAS.timeStep;
    }
  }

  /** Neighbours of a particle within two smoothing lengths, on average. */
  neighbours() {
    let pairs = 0;
    for (const a of this.particles) {
      for (const b of this.particles) {
        if (a !== b && distance(a, b) < 2 * GAS.h) pairs += 1;
      }
    }
    return pairs / this.particles.length;
  }

  /** What the last step found: densities; velocities, x and y of each. */
  state() {
    return {
      densities: this.particles.map((a) => a.density),
      velocities: this.particles.flatMap((a) => [a.vx, a.vy]),
    };
  }
}

/** What `b` does to `a`: pressure and viscosity. */
function push(a, b) {
  const dx = a.x - b.x;
  const dy = a.y - b.y;
  const r = Math.sqrt(dx * dx + dy * dy);
  if (r >= 2 * GAS.h || r === 0) return;
  const slope = slopeOf(r);
  const share = MASS / (Math.max(GAS.densityFloor, a.density) * Math.max(GAS.densityFloor, b.density));
  const pressure = (-share * (a.pressure + b.pressure) * slope) / r;
  const drag = (2 * GAS.viscosity * share * slope * r) / (r * r + 0.01 * GAS.h * GAS.h);
  a.ax += pressure * dx + drag * (a.vx - b.vx);
  a.ay += pressure * dy + drag * (a.vy - b.vy);
}

/** Cubic spline in two dimensions. */
function kernel(r) {
  const q = r / GAS.h;
  const norm = 10 / (7 * Math.PI * GAS.h * GAS.h);
  if (q < 1) return norm * (1 - 1.5 * q * q + 0.75 * q * q * q);
  const t = 2 - q;
  return t > 0 ? norm * 0.25 * t * t * t : 0;
}

/** Its derivative by the distance. */
function slopeOf(r) {
  const q = r / GAS.h;
  const norm = 10 / (7 * Math.PI * GAS.h * GAS.h * GAS.h);
  if (q < 1) return norm * (2.25 * q * q - 3 * q);
  const t = 2 - q;
  return t > 0 ? -norm * 0.75 * t * t : 0;
}

/** `Math.hypot` is many times slower and would flatter Hearth. */
function distance(a, b) {
  const dx = a.x - b.x;
  const dy = a.y - b.y;
  return Math.sqrt(dx * dx + dy * dy);
}
