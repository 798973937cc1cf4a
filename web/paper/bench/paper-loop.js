/**
 * The paper's program, without drawing: particles are objects, and each looks at every other one, twice a step. Numbers
 * in brackets are the paper's equations.
 *
 * The equations are Hearth's corrected ones, so that both compute the same gas: the factor of the kernel is that of two
 * dimensions (1), the Laplacian of the kernel never changes its sign (4), and forces on a volume of gas are divided by
 * its density (5, 7). No correction changes the time of a step by much.
 */

import { GAS, MASS, lift } from './gas.js';

/** @typedef {{positions: ArrayLike<number>, velocities?: ArrayLike<number>}} Start  x and y of each particle. */

export class PaperLoop {
  /** @param {Start} start  Without velocities, the particles are at rest. */
  constructor(start) {
    this.start = start;
    this.particles = particlesOf(start);
  }

  /** Restores the particles of the start. */
  rewind() {
    this.particles = particlesOf(this.start);
  }

  /** One loop: densities and pressures, forces, motion, lives. */
  step() {
    for (const particle of this.particles) this.findDensity(particle);
    for (const particle of this.particles) this.findAcceleration(particle);
    for (const particle of this.particles) move(particle);
    this.particles = this.particles.filter(({ age }) => age < GAS.lifetime);
  }

  /** Density (2) and pressure. @param {Particle} particle */
  findDensity(particle) {
    particle.density = 0;
    for (const other of this.particles) particle.density += MASS * kernel(distance(particle, other));
    particle.pressure = Math.max(0, GAS.gasConstant * (particle.density - GAS.restDensity));
  }

  /** Pressure (3), viscosity (4) and buoyancy (7), divided by the density (5). @param {Particle} particle */
  findAcceleration(particle) {
    particle.ax = 0;
    particle.ay = lift(particle.density, particle.temperature, particle.vy);
    for (const other of this.particles) {
      if (particle !== other) addForces(particle, other);
    }
  }

  /** Neighbours of a particle within two smoothing lengths, on average. */
  neighbours() {
    let pairs = 0;
    for (const particle of this.particles) {
      for (const other of this.particles) {
        if (particle !== other && distance(particle, other) < 2 * GAS.h) pairs += 1;
      }
    }
    return pairs / this.particles.length;
  }

  /** What the last step found: densities; velocities, x and y of each. */
  state() {
    return {
      densities: this.particles.map(({ density }) => density),
      velocities: this.particles.flatMap(({ vx, vy }) => [vx, vy]),
    };
  }
}

/** @typedef {ReturnType<typeof particlesOf>[number]} Particle */

/** @param {Start} start */
function particlesOf({ positions, velocities }) {
  return Array.from({ length: positions.length / 2 }, (_, at) => ({
    x: positions[2 * at],
    y: positions[2 * at + 1],
    vx: velocities?.[2 * at] ?? 0,
    vy: velocities?.[2 * at + 1] ?? 0,
    ax: 0,
    ay: 0,
    density: 0,
    pressure: 0,
    temperature: GAS.temperature,
    age: 0,
  }));
}

/** Adds what pressure and viscosity of another particle do. @param {Particle} particle @param {Particle} other */
function addForces(particle, other) {
  const dx = particle.x - other.x;
  const dy = particle.y - other.y;
  const r = Math.sqrt(dx * dx + dy * dy);
  if (r >= 2 * GAS.h || r === 0) return;
  const slope = kernelSlope(r);
  const share = MASS / (Math.max(GAS.densityFloor, particle.density) * Math.max(GAS.densityFloor, other.density));
  const pressure = (-share * (particle.pressure + other.pressure) * slope) / r;
  const drag = (2 * GAS.viscosity * share * slope * r) / (r * r + 0.01 * GAS.h * GAS.h);
  particle.ax += pressure * dx + drag * (particle.vx - other.vx);
  particle.ay += pressure * dy + drag * (particle.vy - other.vy);
}

/** Euler's method with the new velocity (6), cooling and age. @param {Particle} particle */
function move(particle) {
  particle.vx += particle.ax * GAS.timeStep;
  particle.vy += particle.ay * GAS.timeStep;
  particle.x += particle.vx * GAS.timeStep;
  particle.y += particle.vy * GAS.timeStep;
  particle.temperature = Math.max(GAS.ambientTemperature, particle.temperature - GAS.coolingRate * GAS.timeStep);
  particle.age += GAS.timeStep;
}

/** The cubic spline (1). @param {number} r */
function kernel(r) {
  const q = r / GAS.h;
  const norm = 10 / (7 * Math.PI * GAS.h * GAS.h);
  if (q < 1) return norm * (1 - 1.5 * q * q + 0.75 * q * q * q);
  return q < 2 ? norm * 0.25 * (2 - q) ** 3 : 0;
}

/** Its derivative by the distance. @param {number} r */
function kernelSlope(r) {
  const q = r / GAS.h;
  const norm = 10 / (7 * Math.PI * GAS.h * GAS.h * GAS.h);
  if (q < 1) return norm * (2.25 * q * q - 3 * q);
  return q < 2 ? -norm * 0.75 * (2 - q) ** 2 : 0;
}

/** Far faster than `Math.hypot`, which would flatter Hearth. @param {Particle} a @param {Particle} b */
function distance(a, b) {
  const dx = a.x - b.x;
  const dy = a.y - b.y;
  return Math.sqrt(dx * dx + dy * dy);
}
