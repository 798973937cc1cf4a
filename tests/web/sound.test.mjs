/**
 * The sound of a fire without a browser: its spectrum, crackle, level, silence and fades, measured of its samples.
 */
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { STEP_NUMBERS, Synthesis } from '../../web/sound.js';
import { Cracks } from '../../web/sound/cracks.js';
import { Filter, generator, highPass, lowPass } from '../../web/sound/filters.js';
import {
  RATE,
  between,
  densityOf,
  exponentOf,
  flame,
  jumpOf,
  levelOf,
  peakOf,
  seriesOf,
  soundOf,
} from './sound-signal.mjs';

/** −80 dBFS. */
const SILENT = 1e-4;

describe('the roar', () => {
  test('has a power spectral density whose exponent is −2.5 above the low band', () => {
    for (const power of [20, 300]) {
      const { left } = soundOf(seriesOf(8, flame(power)), { crackle: 0, air: false });
      const exponent = exponentOf(densityOf(between(left, 1, 8)), 200, 5000);
      assert.ok(Math.abs(exponent + 2.5) < 0.4, `${exponent}`);
    }
  });

  test('has the frequency at which the power changes, whatever the lengths of the steps', () => {
    const beat = (time) => ({ power: 200 + 0.5 * Math.sin(2 * Math.PI * 60 * time) });
    const density = densityOf(between(soundOf(seriesOf(6, beat), { crackle: 0 }).left, 1, 6));
    const bin = Math.round((60 * 2 * density.length) / RATE);
    const near = density.subarray(bin - 2, bin + 3).reduce((sum, x) => sum + x, 0);
    const all = density.reduce((sum, x) => sum + x, 0);
    assert.ok(near > 0.8 * all, `${near / all}`);
  });

  test('swells with the puffs of a flame', () => {
    const flicker = flame(200);
    const puffs = (time, random) => {
      const { power } = flicker(time, random);
      return { power: 200 + (power - 200) * (1 + 0.8 * Math.sin(2 * Math.PI * 2.4 * time)) };
    };
    const { left } = soundOf(seriesOf(12, puffs), { crackle: 0 });
    // The level in windows of a twentieth of a second, and how strong each frequency is in it.
    const levels = Array.from({ length: 220 }, (_, at) => levelOf(between(left, 1 + at / 20, 1 + (at + 1) / 20)));
    const mean = levels.reduce((sum, x) => sum + x, 0) / levels.length;
    const strength = (frequency) => {
      const parts = [Math.cos, Math.sin].map((wave) =>
        levels.reduce((sum, level, at) => sum + (level - mean) * wave((2 * Math.PI * frequency * at) / 20), 0),
      );
      return Math.hypot(...parts);
    };
    const frequencies = Array.from({ length: 80 }, (_, at) => 0.5 + at / 10);
    const loudest = frequencies.reduce((best, frequency) => (strength(frequency) > strength(best) ? frequency : best));
    assert.ok(Math.abs(loudest - 2.4) < 0.15, `${loudest} Hz`);
  });

  test('of the classic model follows from births and deaths', () => {
    const lives = (_, random) => ({ births: Math.floor(7 * random()), deaths: Math.floor(7 * random()) });
    const { left } = soundOf(seriesOf(2, lives));
    assert.ok(levelOf(between(left, 1, 2)) > 0.01);
  });

  test('is louder for a flame of more power', () => {
    const levels = [3, 30, 300].map((power) => levelOf(between(soundOf(seriesOf(3, flame(power))).left, 1, 3)));
    assert.ok(levels[0] < levels[1] && levels[1] < levels[2], `${levels}`);
  });
});

describe('crackle', () => {
  test('at a constant rate has exponential times between cracks', () => {
    const [rate, cracksPerSecond] = [2000, 8];
    const cracks = new Cracks(generator(3), rate);
    const times = [];
    for (let last = 0, at = 0; times.length < 3000; at += 1) {
      if (cracks.advance(cracksPerSecond, 12, 0)) {
        times.push((at - last) / rate);
        last = at;
      }
    }
    times.sort((a, b) => a - b);
    // Kolmogorov and Smirnov, at a significance of 1 %; a sample is a sixtieth of a mean time.
    const distances = times.map((time, at) =>
      Math.abs((at + 0.5) / times.length - (1 - Math.exp(-cracksPerSecond * time))),
    );
    assert.ok(Math.max(...distances) < 1.63 / Math.sqrt(times.length), `${Math.max(...distances)}`);
  });

  test('needs fuel that dries or chars, or sparks', () => {
    const burns = flame(100);
    const series = (more) => seriesOf(3, (time, random) => ({ ...burns(time, random), ...more }));
    const adds = (more) => {
      const [without, loud] = [0, 1].map((crackle) => soundOf(series(more), { crackle }).left);
      return peakOf(loud.map((x, at) => x - without[at]));
    };
    assert.ok(adds({}) < 0.05 && adds({ place: 0.2, load: 12, jet: 0 }) < 0.05);
    for (const more of [{ sparks: 0.5 }, { dried: 1e-5, load: 12 }, { charred: 1e-5, load: 12 }])
      assert.ok(adds(more) > 0, JSON.stringify(more));
  });

  test('of a fire without fuel and sparks is none: its samples are those without crackle', () => {
    const [without, loud] = [0, 1].map((crackle) => soundOf(seriesOf(1, flame(100)), { crackle }).left);
    assert.deepEqual(loud, without);
  });

  test('is where its sparks are', () => {
    const right = soundOf(
      seriesOf(4, () => ({ sparks: 1, place: 0.8 })),
      { halfWidth: 1, crackle: 1 },
    );
    assert.ok(levelOf(right.right) > 1.5 * levelOf(right.left), `${levelOf(right.left)}, ${levelOf(right.right)}`);
  });

  test('of a light sheet is higher than that of a log', () => {
    const centre = (load) => {
      const { left } = soundOf(
        seriesOf(6, () => ({ charred: 2e-5, load })),
        { crackle: 1 },
      );
      const density = densityOf(left);
      const sum = density.reduce((all, x) => all + x, 0);
      return density.reduce((all, x, bin) => all + x * bin, 0) / sum;
    };
    assert.ok(centre(1) > 1.5 * centre(12), `${centre(1)}, ${centre(12)}`);
  });
});

describe('steam, jets and strikes', () => {
  /** The level of 3 to 8 kHz. */
  const hiss = (more) => {
    const { left } = soundOf(
      seriesOf(2, () => more),
      { crackle: 0, air: false },
    );
    const filters = [highPass(3000 / RATE), lowPass(8000 / RATE)].map((values) => new Filter(values));
    return levelOf(between(left, 0.5, 2).map((x) => filters.reduce((sample, filter) => filter.run(sample), x)));
  };

  test('steam hisses with the root of its mass, whose sound has random phases', () => {
    const ratio = hiss({ steam: 4e-5 }) / hiss({ steam: 1e-5 });
    assert.ok(Math.abs(ratio - 2) < 0.1, `${ratio}`);
  });

  test('a jet hisses with the fourth power of its speed', () => {
    const ratio = hiss({ power: 20, jet: 0.8 }) / hiss({ power: 20, jet: 0.4 });
    assert.ok(Math.abs(ratio - 16) < 1, `${ratio}`);
  });

  test('a narrow source that is lit strikes once', () => {
    const lit = (time) => ({ power: time < 0.5 ? 0 : 5, jet: time < 0.5 ? 0 : 0.15 });
    const { left } = soundOf(seriesOf(3, lit), { crackle: 0 });
    const [strike, later] = [between(left, 0.5, 0.9), between(left, 2, 3)].map(levelOf);
    assert.ok(strike > 0.02 && strike > 100 * later, `${strike}, ${later}`);
  });
});

describe('silence and fades', () => {
  const burns = seriesOf(2, (time, random) => ({ ...flame(300)(time, random), sparks: 0.2 }));

  test('a fire that is out is silent', () => {
    const flicker = flame(300);
    const goes = seriesOf(5, (time, random) => (time < 2 ? flicker(time, random) : {}));
    const { left } = soundOf(goes);
    assert.ok(levelOf(between(left, 1, 2)) > 0.01);
    assert.ok(peakOf(between(left, 4, 4.9)) < SILENT);
  });

  test('a fire that gives no more steps fades within 80 ms and stays silent', () => {
    const { left } = soundOf(burns, {}, { rest: 1 });
    const end = left.length / RATE - 1;
    assert.ok(peakOf(between(left, end - 0.1, end)) > 0.01);
    assert.equal(peakOf(between(left, end + 0.081, end + 1)), 0);
  });

  const clicks = {
    'a pause': { rest: 0.5 },
    mute: { act: (sound, time) => time > 1 && sound.mix(0, 0.5) },
    'another volume': { act: (sound, time) => sound.mix(time > 1 ? 0.2 : 1, 0) },
  };
  for (const [name, how] of Object.entries(clicks)) {
    test(`${name} makes no click`, () => {
      const flicker = flame(300);
      const series = seriesOf(2, flicker);
      const usual = jumpOf(between(soundOf(series, { crackle: 0 }).left, 0.5, 2));
      const { left } = soundOf(series, { crackle: 0 }, how);
      assert.ok(jumpOf(left.subarray(RATE / 2)) <= 1.1 * usual);
    });
  }

  test('another preset makes no click', () => {
    const [strong, weak] = [flame(300), flame(20)];
    const series = seriesOf(4, (time, random) => (time < 1 || time > 3 ? strong : weak)(time, random));
    const usual = jumpOf(between(soundOf(seriesOf(4, strong), { crackle: 0 }).left, 0.5, 4));
    const { left } = soundOf(series, { crackle: 0 });
    assert.ok(jumpOf(left) <= 2 * usual, `${jumpOf(left)} of ${usual}`);
  });

  test('four fires together stay below full scale, whatever their series', () => {
    const wild = (seed) =>
      seriesOf(
        2,
        (_, random) => ({
          power: 600 * random() ** 8 * (random() < 0.5 ? 0 : 100),
          dried: random(),
          charred: random(),
          load: 100 * random(),
          broken: 9 * random(),
          sparks: 200 * random(),
          steam: random(),
          jet: 3 * random(),
          births: 1e4 * random(),
        }),
        seed,
      );
    const fires = [1, 2, 3, 4].map((seed) => soundOf(wild(seed), { seed, crackle: 1 }).left);
    const length = Math.min(...fires.map((fire) => fire.length));
    const sum = Float32Array.from({ length }, (_, at) => fires.reduce((all, fire) => all + fire[at], 0));
    assert.ok(peakOf(sum) > 0.1 && peakOf(sum) <= 1, `${peakOf(sum)}`);
  });

  test('the largest numbers keep the samples finite', () => {
    const { left } = soundOf(seriesOf(1, (time) => ({ power: time > 0.5 ? 1e6 : 0, steam: 1e6, place: -1e6 })));
    assert.ok(left.every(Number.isFinite));
  });
});

describe('the buffer', () => {
  test('the same series and seed give the same samples, another seed others', () => {
    const series = seriesOf(1, flame(100));
    assert.deepEqual(soundOf(series, { seed: 4 }), soundOf(series, { seed: 4 }));
    assert.notDeepEqual(soundOf(series, { seed: 5 }), soundOf(series, { seed: 4 }));
  });

  test('a fire at half of the speed of the clock has twice the samples', () => {
    const series = seriesOf(1, flame(100));
    const seconds = [1, 0.5].map((speed) => {
      const sound = new Synthesis({ rate: RATE });
      sound.push(series, speed);
      return sound.ahead;
    });
    assert.ok(Math.abs(seconds[1] - 2 * seconds[0]) < 1e-6, `${seconds}`);
  });

  test('what is older than the limit is dropped', () => {
    const sound = new Synthesis({ rate: RATE });
    sound.push(seriesOf(1, flame(100)));
    sound.trim(0.12);
    assert.ok(sound.ahead <= 0.12 && sound.ahead > 0.11, `${sound.ahead} s`);
    sound.push(new Float32Array(STEP_NUMBERS));
    assert.ok(sound.ahead <= 0.12, 'a step without a length adds none');
  });
});
