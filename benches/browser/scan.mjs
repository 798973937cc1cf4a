/**
 * The common typed-array step: it stores no pairs, and each particle visits the cells
 * around it twice, for density and for forces.
 */
import { GAS, MASS, lift } from '../../web/paper/bench/gas.js';
import { TypedFire } from './typed.mjs';

const INVERSE_H = 1 / GAS.h;
const REACH = 4 * GAS.h * GAS.h;
const NORM = 10 / (7 * Math.PI * GAS.h * GAS.h);

export class ScanFire extends TypedFire {
  findPairs() {
    const { columns, rows, begin, x, y, density } = this;
    for (let row = 0; row < rows; row += 1) {
      for (let column = 0; column < columns; column += 1) {
        const c = row * columns + column;
        const end = begin[c + 1];
        for (let i = begin[c]; i < end; i += 1) {
          const xi = x[i];
          const yi = y[i];
          let sum = 0;
          for (let near = row > 0 ? row - 1 : 0; near <= row + 1; near += 1) {
            const n = near * columns + column;
            const stop = column + 1 < columns ? begin[n + 2] : begin[n + 1];
            for (let j = column > 0 ? begin[n - 1] : begin[n]; j < stop; j += 1) {
              const dx = xi - x[j];
              const dy = yi - y[j];
              const square = dx * dx + dy * dy;
              if (square < REACH) {
                const q = Math.sqrt(square) * INVERSE_H;
                const outer = 2 - q;
                sum += outer * outer * outer;
                if (q < 1) {
                  const inner = 1 - q;
                  sum -= 4 * inner * inner * inner;
                }
              }
            }
          }
          density[i] = 0.25 * NORM * MASS * sum;
        }
      }
    }
  }

  interact() {
    const { columns, rows, begin, x, y, vx, vy, ax, ay } = this;
    const { density, temperature, pressure, volume } = this;
    const softening = 0.01 * GAS.h * GAS.h;
    const viscous = 2 * GAS.viscosity;
    const slopeNorm = 0.75 * NORM * INVERSE_H * MASS;
    let seen = 0;
    for (let row = 0; row < rows; row += 1) {
      for (let column = 0; column < columns; column += 1) {
        const c = row * columns + column;
        const end = begin[c + 1];
        for (let i = begin[c]; i < end; i += 1) {
          const xi = x[i];
          const yi = y[i];
          const vxi = vx[i];
          const vyi = vy[i];
          const pressureI = pressure[i];
          let sumX = 0;
          let sumY = 0;
          for (let near = row > 0 ? row - 1 : 0; near <= row + 1; near += 1) {
            const n = near * columns + column;
            const stop = column + 1 < columns ? begin[n + 2] : begin[n + 1];
            for (let j = column > 0 ? begin[n - 1] : begin[n]; j < stop; j += 1) {
              const dx = xi - x[j];
              const dy = yi - y[j];
              const square = dx * dx + dy * dy;
              if (square < REACH && square > 1e-18) {
                const r = Math.sqrt(square);
                const q = r * INVERSE_H;
                const outer = 2 - q;
                let minusDw = outer * outer;
                if (q < 1) {
                  const inner = 1 - q;
                  minusDw -= 4 * inner * inner;
                }
                const weight = (minusDw * volume[j]) / r;
                const push = weight * (pressureI + pressure[j]);
                const drag = (weight * viscous * square) / (square + softening);
                sumX += push * dx - drag * (vxi - vx[j]);
                sumY += push * dy - drag * (vyi - vy[j]);
                seen += 1;
              }
            }
          }
          const share = slopeNorm * volume[i];
          ax[i] = share * sumX;
          ay[i] = share * sumY + lift(density[i], temperature[i], vyi);
        }
      }
    }
    this.pairs = seen / 2;
  }
}
