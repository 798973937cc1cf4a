/**
 * The gas whose steps are measured: a square of the classic model at rest. The programs in JavaScript compute it with
 * Hearth's equations; `cargo xtask test baselines` compares their densities and velocities with Hearth's.
 */

/** @typedef {{positions: ArrayLike<number>, velocities: ArrayLike<number>}} Start  x and y of each particle. */

export const GAS = {
  /** Smoothing length [m]. */
  h: 0.012,
  /** Neighbours of a particle within 2h, from which follows how far apart they are. */
  neighbours: 20,
  restDensity: 2,
  gasConstant: 0.6,
  viscosity: 0.001,
  buoyancy: 0.12,
  thermalBuoyancy: 0.2,
  ambientDensity: 1.2,
  ambientTemperature: 293,
  gravity: 0,
  terminalSpeed: 2.5,
  speedLimit: 4,
  coolingRate: 900,
  temperature: 1000,
  lifetime: 1e6,
  timeStep: 1 / 480,
  /** Least density that a force reckons with. */
  densityFloor: 0.3,
};

/** Distance of particles [m]. */
export const SPACING = 2 * GAS.h * Math.sqrt(Math.PI / (GAS.neighbours + 1));

/** Mass of a particle [kg/m]. */
export const MASS = GAS.restDensity * SPACING * SPACING;

/**
 * Acceleration by buoyancy, which the resistance of the air balances at the terminal speed [m/s²].
 * @param {number} density  [kg/m³]
 * @param {number} temperature  [K]
 * @param {number} speed  Upward [m/s].
 */
export function lift(density, temperature, speed) {
  const a =
    GAS.gravity *
    (GAS.buoyancy * (GAS.ambientDensity / density - 1) +
      GAS.thermalBuoyancy * (1 - GAS.ambientTemperature / temperature));
  const along = a < 0 ? -speed : speed;
  const drag = (along * Math.abs(along)) / (GAS.terminalSpeed * GAS.terminalSpeed);
  return a * Math.min(2, Math.max(-1, 1 - drag));
}
