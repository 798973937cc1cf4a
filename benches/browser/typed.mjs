/**
 * Hearth's classic step in careful JavaScript: typed arrays, particles sorted by cell with
 * a counting sort, each pair found once and stored for the forces, no allocation in a
 * step.
 */
import { GAS, MASS, lift } from '../../web/paper/bench/gas.js';

/** Pairs that there is room for, a particle; an even gas has half as many as neighbours. */
const PAIRS = 24;

/** What moves with a particle when particles are sorted. */
const CARRIED = ['x', 'y', 'vx', 'vy', 'temperature', 'age', 'id'];

export class TypedFire {
  /** @param {import('../../web/paper/bench/gas.js').Start} start */
  constructor({ positions, velocities }) {
    const count = positions.length / 2;
    this.count = count;
    this.start = { positions, velocities };
    const numbers = () => new Float32Array(count);
    for (const name of CARRIED) {
      this[name] = numbers();
      this[`${name}Sorted`] = numbers();
    }
    this.rewind();
    this.density = numbers();
    this.pressure = numbers();
    this.volume = numbers();
    this.ax = numbers();
    this.ay = numbers();
    this.cell = new Int32Array(count);
    this.other = new Int32Array(PAIRS * count);
    this.dx = new Float32Array(PAIRS * count);
    this.dy = new Float32Array(PAIRS * count);
    this.slope = new Float32Array(PAIRS * count);
    /** Where the pairs of each particle begin. */
    this.first = new Int32Array(count + 1);

    // The domain: as large as the block and some room around it.
    const room = 12 * GAS.h;
    this.left = least(this.x) - room;
    this.bottom = least(this.y) - room;
    this.columns = Math.ceil((room - least(this.x.map((x) => -x)) - this.left) / (2 * GAS.h)) + 1;
    this.rows = Math.ceil((room - least(this.y.map((y) => -y)) - this.bottom) / (2 * GAS.h)) + 1;
    /** Where the particles of each cell begin; one more row, so that the last has one above. */
    this.begin = new Int32Array(this.columns * (this.rows + 1) + 2);
  }

  /** Goes back to the start. */
  rewind() {
    const { positions, velocities } = this.start;
    for (let i = 0; i < this.count; i += 1) {
      this.x[i] = positions[2 * i];
      this.y[i] = positions[2 * i + 1];
      this.vx[i] = velocities[2 * i];
      this.vy[i] = velocities[2 * i + 1];
      this.id[i] = i;
    }
    this.temperature.fill(GAS.temperature);
    this.age.fill(0);
  }

  /** One step: sort, density and pressure, forces, motion. */
  step() {
    this.sort();
    this.findPairs();
    this.press();
    this.interact();
    this.move();
  }

  sort() {
    const { count, cell, begin, columns, left, bottom, x, y } = this;
    const scale = 1 / (2 * GAS.h);
    begin.fill(0);
    for (let i = 0; i < count; i += 1) {
      const c = Math.trunc((y[i] - bottom) * scale) * columns + Math.trunc((x[i] - left) * scale);
      cell[i] = c;
      begin[c + 2] += 1;
    }
    for (let c = 2; c < begin.length; c += 1) begin[c] += begin[c - 1];
    for (let i = 0; i < count; i += 1) {
      const c = cell[i] + 1;
      cell[i] = begin[c];
      begin[c] += 1;
    }
    for (const name of CARRIED) {
      const from = this[name];
      const to = this[`${name}Sorted`];
      for (let i = 0; i < count; i += 1) to[cell[i]] = from[i];
      this[name] = to;
      this[`${name}Sorted`] = from;
    }
  }

  /** Finds each pair once: in the cell, the next one, and the three above. */
  findPairs() {
    const { columns, rows, begin, x, y, density, first, other } = this;
    const pairDx = this.dx;
    const pairDy = this.dy;
    const pairSlope = this.slope;
    const inverseH = 1 / GAS.h;
    const reach = 4 * GAS.h * GAS.h;
    const norm = 10 / (7 * Math.PI * GAS.h * GAS.h);
    const kernelNorm = 0.25 * norm * MASS;
    const slopeNorm = 0.75 * norm * inverseH;
    density.fill(norm * MASS);
    let pairs = 0;
    for (let row = 0; row < rows; row += 1) {
      for (let column = 0; column < columns; column += 1) {
        const c = row * columns + column;
        const end = begin[c + 1];
        // The last column has no next one, the first none before.
        const last = column + 1 < columns ? begin[c + 2] : end;
        const above = c + columns;
        const aboveBegin = column > 0 ? begin[above - 1] : begin[above];
        const aboveEnd = column + 1 < columns ? begin[above + 2] : begin[above + 1];
        for (let i = begin[c]; i < end; i += 1) {
          first[i] = pairs;
          const xi = x[i];
          const yi = y[i];
          let sum = 0;
          let j = i + 1;
          let stop = last;
          for (let sweep = 0; sweep < 2; sweep += 1) {
            for (; j < stop; j += 1) {
              const dx = xi - x[j];
              const dy = yi - y[j];
              const square = dx * dx + dy * dy;
              if (square < reach) {
                const r = Math.sqrt(square);
                const q = r * inverseH;
                const outer = 2 - q;
                let minusDw = outer * outer;
                let kernel = minusDw * outer;
                if (q < 1) {
                  const inner = 1 - q;
                  const part = 4 * inner * inner;
                  minusDw -= part;
                  kernel -= part * inner;
                }
                kernel *= kernelNorm;
                sum += kernel;
                density[j] += kernel;
                other[pairs] = j;
                pairDx[pairs] = dx;
                pairDy[pairs] = dy;
                pairSlope[pairs] = r > 1e-9 ? (slopeNorm * minusDw) / r : 0;
                pairs += 1;
              }
            }
            j = aboveBegin;
            stop = aboveEnd;
          }
          density[i] += sum;
        }
      }
    }
    first[this.count] = pairs;
    this.pairs = pairs;
  }

  press() {
    const { count, density, pressure, volume } = this;
    for (let i = 0; i < count; i += 1) {
      pressure[i] = Math.max(0, GAS.gasConstant * (density[i] - GAS.restDensity));
      volume[i] = 1 / Math.max(GAS.densityFloor, density[i]);
    }
  }

  /** Pressure and viscosity of each pair, then lift. */
  interact() {
    const { count, first, other, dx, dy, slope, pressure, volume, vx, vy, ax, ay } = this;
    const softening = 0.01 * GAS.h * GAS.h;
    const viscous = 2 * GAS.viscosity;
    ax.fill(0);
    ay.fill(0);
    for (let i = 0; i < count; i += 1) {
      const pressureI = pressure[i];
      const share = MASS * volume[i];
      const vxi = vx[i];
      const vyi = vy[i];
      let sumX = 0;
      let sumY = 0;
      const end = first[i + 1];
      for (let k = first[i]; k < end; k += 1) {
        const j = other[k];
        const x = dx[k];
        const y = dy[k];
        const square = x * x + y * y;
        const weight = share * volume[j] * slope[k];
        const push = weight * (pressureI + pressure[j]);
        const drag = (weight * viscous * square) / (square + softening);
        const fx = push * x - drag * (vxi - vx[j]);
        const fy = push * y - drag * (vyi - vy[j]);
        sumX += fx;
        sumY += fy;
        ax[j] -= fx;
        ay[j] -= fy;
      }
      ax[i] += sumX;
      ay[i] += sumY;
    }
    const { density, temperature } = this;
    for (let i = 0; i < count; i += 1) ay[i] += lift(density[i], temperature[i], vy[i]);
  }

  move() {
    const { count, x, y, vx, vy, ax, ay, temperature, age } = this;
    const dt = GAS.timeStep;
    const limit = GAS.speedLimit * GAS.speedLimit;
    for (let i = 0; i < count; i += 1) {
      let u = vx[i] + ax[i] * dt;
      let v = vy[i] + ay[i] * dt;
      const square = u * u + v * v;
      if (square > limit) {
        const share = GAS.speedLimit / Math.sqrt(square);
        u *= share;
        v *= share;
      }
      vx[i] = u;
      vy[i] = v;
      x[i] += u * dt;
      y[i] += v * dt;
      temperature[i] = Math.max(GAS.ambientTemperature, temperature[i] - GAS.coolingRate * dt);
      age[i] += dt;
    }
  }

  /** Neighbours of a particle within two smoothing lengths, on average. */
  neighbours() {
    return (2 * this.pairs) / this.count;
  }

  /** What the last step found, in the order of the start: densities; velocities, x and y of each. */
  state() {
    const densities = new Float64Array(this.count);
    const velocities = new Float64Array(2 * this.count);
    for (let i = 0; i < this.count; i += 1) {
      const id = this.id[i];
      densities[id] = this.density[i];
      velocities[2 * id] = this.vx[i];
      velocities[2 * id + 1] = this.vy[i];
    }
    return { densities, velocities };
  }
}

function least(numbers) {
  return numbers.reduce((a, b) => Math.min(a, b), Infinity);
}
