/**
 * The laws of the sound: its spectrum, crackle, level, silence and fades, measured of the samples of series.
 */
import assert from 'node:assert/strict';
import { describe, test } from 'node:test';
import { load } from './library.mjs';
import {
  RATE,
  above,
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

const { STEP_NUMBERS, createSynthesis } = await load('sound.js');

/** −80 dBFS. */
const SILENT = 1e-4;

/** Parts of the mix alone. */
const ROAR = { crackle: 0, hiss: 0 };
const CRACKLE = { roar: 0, hiss: 0 };
const HISS = { roar: 0, crackle: 0 };

/** The left channel. */
const leftOf = async (...how) => (await soundOf(...how)).left;

/** The envelope of a sound: its level in windows of so many seconds. */
const envelopeOf = (samples, window) =>
  Array.from({ length: Math.floor(samples.length / RATE / window) }, (_, at) =>
    levelOf(between(samples, at * window, (at + 1) * window)),
  );

/** The frequency from 0.5 Hz to `most` that is strongest in an envelope [Hz]. */
function loudestOf(levels, window, most) {
  const mean = levels.reduce((sum, x) => sum + x, 0) / levels.length;
  const strength = (frequency) => {
    const parts = [Math.cos, Math.sin].map((wave) =>
      levels.reduce((sum, level, at) => sum + (level - mean) * wave(2 * Math.PI * frequency * at * window), 0),
    );
    return Math.hypot(...parts);
  };
  const frequencies = Array.from({ length: Math.floor((most - 0.5) * 10) }, (_, at) => 0.5 + at / 10);
  return frequencies.reduce((best, frequency) => (strength(frequency) > strength(best) ? frequency : best));
}

/** A fire that pops once. @param {number} begin @param {object} [more] */
function popAt(begin, more) {
  let popped = false;
  return (time) => {
    const pops = Number(time > begin && !popped);
    popped ||= pops > 0;
    return { power: 100, pops, ...more };
  };
}

describe('the roar', () => {
  test('has a power spectral density whose exponent is −2.5 above the low band', async () => {
    for (const power of [20, 300]) {
      const left = await leftOf(seriesOf(8, flame(power)), ROAR);
      const exponent = exponentOf(densityOf(between(left, 1, 8)), 200, 5000);
      assert.ok(Math.abs(exponent + 2.5) < 0.4, `${exponent}`);
    }
  });

  test('has the frequency at which the power changes, whatever the lengths of the steps', async () => {
    const beat = (time) => ({ power: 200 + 0.5 * Math.sin(2 * Math.PI * 60 * time) });
    const density = densityOf(between(await leftOf(seriesOf(6, beat), ROAR), 1, 6));
    const bin = Math.round((60 * 2 * density.length) / RATE);
    const near = density.subarray(bin - 2, bin + 3).reduce((sum, x) => sum + x, 0);
    const all = density.reduce((sum, x) => sum + x, 0);
    assert.ok(near > 0.8 * all, `${near / all}`);
  });

  test('swells with the puffs of a flame', async () => {
    const flicker = flame(200);
    const puffs = (time, random) => {
      const { power } = flicker(time, random);
      return { power: 200 + (power - 200) * (1 + 0.8 * Math.sin(2 * Math.PI * 2.4 * time)) };
    };
    const left = await leftOf(seriesOf(12, puffs), ROAR);
    const loudest = loudestOf(envelopeOf(between(left, 1, 12), 0.05), 0.05, 8.5);
    assert.ok(Math.abs(loudest - 2.4) < 0.15, `${loudest} Hz`);
  });

  test('of the classic model follows from births and deaths', async () => {
    const lives = (_, random) => ({ births: Math.floor(7 * random()), deaths: Math.floor(7 * random()) });
    const left = await leftOf(seriesOf(2, lives));
    assert.ok(levelOf(between(left, 1, 2)) > 0.001);
  });

  test('grows with the 0.6th power of the power, whatever the size of the particles', async () => {
    const level = async (power, flicker = 4) => {
      const burns = flame(power);
      const series = seriesOf(5, (time, random) => ({ power: power + flicker * (burns(time, random).power - power) }));
      return levelOf(between(await leftOf(series, ROAR), 2, 5));
    };
    const [weak, usual, strong, coarse] = [await level(30), await level(300), await level(600), await level(300, 12)];
    for (const [ratio, wanted] of [
      [usual / weak, 10 ** 0.6],
      [strong / usual, 2 ** 0.6],
      [coarse / usual, 1],
    ])
      assert.ok(Math.abs(ratio / wanted - 1) < 0.15, `${ratio}, not ${wanted}`);
  });

  test('of a narrow source, which is laminar, is far below that of a wide one', async () => {
    const level = async (more) => {
      const burns = flame(50);
      const series = seriesOf(3, (time, random) => ({ ...burns(time, random), ...more }));
      return levelOf(between(await leftOf(series, ROAR), 1, 3));
    };
    assert.ok((await level({ jet: 0.2 })) < 0.2 * (await level({ flutter: 1 })));
  });

  test('flutters with the speed of its flame over its width, and sheets flutter', async () => {
    for (const [more, flaps] of [
      [{ flutter: 8 }, 8],
      [{ load: 0.1 }, 11],
    ]) {
      // A power that stays the same does not roar.
      const left = await leftOf(
        seriesOf(20, () => ({ power: 300, ...more })),
        ROAR,
      );
      const loudest = loudestOf(envelopeOf(between(left, 1, 20), 0.01), 0.01, 20);
      assert.ok(Math.abs(loudest / flaps - 1) < 0.4, `${loudest} Hz, not ${flaps}`);
    }
    const steady = await leftOf(
      seriesOf(2, () => ({ power: 300, flutter: 2, load: 12 })),
      ROAR,
    );
    assert.ok(peakOf(steady) < SILENT, 'a log in a calm flame does not flutter');
  });
});

describe('crackle', () => {
  /** When it snaps [s]: the rises of windows of half a millisecond, and how loud each is. */
  const snapsOf = (samples, window = 0.0005) => {
    const loud = envelopeOf(samples, window);
    const bed = loud.toSorted((a, b) => a - b)[loud.length >> 1];
    return loud.flatMap((level, at) => (level > 4 * (loud[at - 1] ?? 0) + bed + SILENT ? [at * window] : []));
  };

  test('comes in clusters', async () => {
    const left = await leftOf(
      seriesOf(60, () => ({ sparks: 0.05 })),
      CRACKLE,
    );
    const counts = new Array(1200).fill(0);
    for (const time of snapsOf(left)) counts[Math.min(Math.floor(20 * time), 1199)] += 1;
    const mean = counts.reduce((sum, count) => sum + count, 0) / counts.length;
    const variance = counts.reduce((sum, count) => sum + (count - mean) ** 2, 0) / counts.length;
    // It is 1 at random times.
    assert.ok(variance / mean > 1.2, `${variance / mean}`);
  });

  test('has sizes of a power law whose exponent is −2.5', async () => {
    const left = await leftOf(
      seriesOf(120, () => ({ sparks: 0.05 })),
      CRACKLE,
    );
    const peaks = snapsOf(left).map((time) => peakOf(between(left, time, time + 0.004)));
    // Hill's estimate above a size that few windows share.
    const least = peaks.toSorted((a, b) => b - a)[Math.floor(peaks.length / 4)];
    const large = peaks.filter((peak) => peak > least);
    const exponent = large.length / large.reduce((sum, peak) => sum + Math.log(peak / least), 0);
    assert.ok(Math.abs(exponent - 2.5) < 0.6, `${exponent}`);
  });

  test('a pop is sharp, short and bright, and begins with the step that throws its spark', async () => {
    for (const seed of [1, 2, 3, 4]) {
      const series = seriesOf(2, popAt(1));
      let [begins, time] = [0, 0];
      for (let at = 0; at < series.length && !begins; at += STEP_NUMBERS) {
        if (series[at + 11] > 0) begins = time - series[at] / 2;
        time += series[at];
      }
      const left = await leftOf(series, { ...CRACKLE, seed });
      const peak = peakOf(left);
      const loudest = left.findIndex((x) => Math.abs(x) === peak);
      const first = left.findIndex((x) => Math.abs(x) > 0.1 * peak);
      assert.ok(Math.abs(first / RATE - begins) < 0.005, `${first / RATE} s, not ${begins}`);
      const envelope = envelopeOf(left.subarray(first), 0.001);
      const rise = left.subarray(first).findIndex((x) => Math.abs(x) > 0.5 * peak) / RATE;
      assert.ok(rise < 0.0002 && loudest - first < 0.001 * RATE, `${rise} s, ${loudest - first}`);
      assert.ok(envelope[12] < 0.1 * envelope[0], `${envelope.slice(0, 13)}`);
      const bright = levelOf(between(above(left, 2000), first / RATE, first / RATE + 0.02));
      assert.ok(bright > 0.4 * levelOf(between(left, first / RATE, first / RATE + 0.02)));
    }
  });

  test('needs fuel that dries or chars, or sparks', async () => {
    const burns = flame(100);
    const adds = (more) =>
      leftOf(
        seriesOf(3, (time, random) => ({ ...burns(time, random), ...more })),
        CRACKLE,
      ).then(peakOf);
    assert.equal(await adds({}), 0);
    assert.equal(await adds({ place: 0.2, load: 12 }), 0);
    for (const more of [{ sparks: 0.5 }, { dried: 1e-5, load: 12 }, { charred: 1e-5, load: 12 }])
      assert.ok((await adds(more)) > 0.01, JSON.stringify(more));
  });

  test('is where its sparks are', async () => {
    const right = await soundOf(
      seriesOf(4, () => ({ sparks: 1, place: 0.8 })),
      { halfWidth: 1, ...CRACKLE },
    );
    assert.ok(levelOf(right.right) > 1.5 * levelOf(right.left), `${levelOf(right.left)}, ${levelOf(right.right)}`);
  });

  test('of a light sheet is higher than that of a log', async () => {
    const centre = async (load) => {
      const left = await leftOf(
        seriesOf(6, () => ({ charred: 2e-5, load })),
        CRACKLE,
      );
      const density = densityOf(left);
      const sum = density.reduce((all, x) => all + x, 0);
      return density.reduce((all, x, bin) => all + x * bin, 0) / sum;
    };
    const [sheet, log] = [await centre(0.5), await centre(12)];
    assert.ok(sheet > 1.2 * log, `${sheet}, ${log}`);
  });
});

describe('the room', () => {
  test('answers a crack for a third of a second before a wall, more quietly, and not at all in the open', async () => {
    const [open, before] = [
      await leftOf(seriesOf(2, popAt(0.5)), CRACKLE),
      await leftOf(seriesOf(2, popAt(0.5, { wall: 1 })), CRACKLE),
    ];
    const first = before.findIndex((x) => Math.abs(x) > 0.01) / RATE;
    const [direct, answer, later] = [
      [0, 0.01],
      [0.02, 0.1],
      [0.6, 0.7],
    ].map(([from, to]) => levelOf(between(before, first + from, first + to)));
    assert.ok(answer > SILENT && answer < 0.15 * direct && later < SILENT, `${direct}, ${answer}, ${later}`);
    assert.ok(peakOf(between(open, first + 0.3, first + 0.4)) < SILENT);
  });
});

describe('steam, jets and strikes', () => {
  /** The level of 3 to 8 kHz. */
  const hiss = async (more) => {
    const left = await leftOf(
      seriesOf(2, () => more),
      HISS,
    );
    const density = densityOf(between(left, 0.5, 2));
    const [from, to] = [3000, 8000].map((frequency) => Math.round((frequency * 2 * density.length) / RATE));
    return Math.sqrt(density.subarray(from, to).reduce((sum, x) => sum + x, 0));
  };

  test('steam hisses with the root of its mass, whose sound has random phases', async () => {
    const ratio = (await hiss({ steam: 4e-5 })) / (await hiss({ steam: 1e-5 }));
    assert.ok(Math.abs(ratio - 2) < 0.1, `${ratio}`);
  });

  test('a jet hisses with the fourth power of its speed', async () => {
    const ratio = (await hiss({ power: 20, jet: 0.8 })) / (await hiss({ power: 20, jet: 0.4 }));
    assert.ok(Math.abs(ratio - 16) < 1, `${ratio}`);
  });

  test('a narrow source that is lit strikes once', async () => {
    const lit = (time) => ({ power: time < 0.5 ? 0 : 5, jet: time < 0.5 ? 0 : 0.15 });
    const left = await leftOf(seriesOf(3, lit), HISS);
    const [strike, later] = [between(left, 0.5, 0.9), between(left, 2, 3)].map(levelOf);
    assert.ok(strike > 0.01 && strike > 100 * later, `${strike}, ${later}`);
  });
});

describe('silence and fades', () => {
  const burns = seriesOf(2, (time, random) => ({ ...flame(300)(time, random), sparks: 0.2 }));

  test('a fire that is out is silent', async () => {
    const flicker = flame(300);
    const goes = seriesOf(5, (time, random) => (time < 2 ? flicker(time, random) : {}));
    const left = await leftOf(goes);
    assert.ok(levelOf(between(left, 1, 2)) > 0.003);
    assert.ok(peakOf(between(left, 4, 4.9)) < SILENT);
  });

  test('a fire that gives no more steps fades within 80 ms and stays silent', async () => {
    const left = await leftOf(burns, {}, { rest: 1 });
    const end = left.length / RATE - 1;
    assert.ok(peakOf(between(left, end - 0.1, end)) > 0.01);
    assert.equal(peakOf(between(left, end + 0.081, end + 1)), 0);
  });

  const clicks = {
    'a pause': { rest: 0.5 },
    mute: { act: (sound, time) => time > 1 && sound.mix({ volume: 0 }) },
    'another volume': { act: (sound, time) => sound.mix({ volume: time > 1 ? 0.2 : 1 }) },
  };
  for (const [name, how] of Object.entries(clicks)) {
    test(`${name} makes no click`, async () => {
      const flicker = flame(300);
      const series = seriesOf(2, flicker);
      const usual = jumpOf(between(await leftOf(series, ROAR), 0.5, 2));
      const left = await leftOf(series, ROAR, how);
      assert.ok(jumpOf(left.subarray(RATE / 2)) <= 1.1 * usual);
    });
  }

  test('another preset makes no click', async () => {
    const [strong, weak] = [flame(300), flame(20)];
    const series = seriesOf(4, (time, random) => (time < 1 || time > 3 ? strong : weak)(time, random));
    const usual = jumpOf(between(await leftOf(seriesOf(4, strong), ROAR), 0.5, 4));
    const left = await leftOf(series, ROAR);
    assert.ok(jumpOf(left) <= 2 * usual, `${jumpOf(left)} of ${usual}`);
  });

  test('no sample exceeds full scale, whatever the series', async () => {
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
          pops: Math.floor(9 * random()),
          wall: 1,
          flutter: 99 * random(),
          steam: random(),
          jet: 3 * random(),
          births: 1e4 * random(),
        }),
        seed,
      );
    for (const seed of [1, 2, 3, 4]) {
      const loudest = { seed, roar: 2, crackle: 2, hiss: 2 };
      const peak = peakOf(await leftOf(wild(seed), loudest));
      assert.ok(peak > 0.7 && peak <= 1, `${peak}`);
    }
  });

  test('the largest numbers keep the samples finite', async () => {
    const left = await leftOf(seriesOf(1, (time) => ({ power: time > 0.5 ? 1e6 : 0, steam: 1e6, place: -1e6 })));
    assert.ok(left.every(Number.isFinite));
  });
});

describe('the buffer', () => {
  test('the same series and seed give the same samples, another seed others', async () => {
    const series = seriesOf(1, flame(100));
    assert.deepEqual(await soundOf(series, { seed: 4 }), await soundOf(series, { seed: 4 }));
    assert.notDeepEqual(await soundOf(series, { seed: 5 }), await soundOf(series, { seed: 4 }));
  });

  test('a fire at half of the speed of the clock has twice the samples', async () => {
    const series = seriesOf(1, flame(100));
    const seconds = [];
    for (const speed of [1, 0.5]) {
      const sound = await createSynthesis({ rate: RATE });
      sound.push(series, speed);
      seconds.push(sound.ahead);
    }
    assert.ok(Math.abs(seconds[1] - 2 * seconds[0]) < 1e-6, `${seconds}`);
  });

  test('what is older than the limit is dropped', async () => {
    const sound = await createSynthesis({ rate: RATE });
    sound.push(seriesOf(1, flame(100)));
    sound.trim(0.12);
    assert.ok(sound.ahead <= 0.12 && sound.ahead > 0.11, `${sound.ahead} s`);
    sound.push(new Float32Array(STEP_NUMBERS));
    assert.ok(sound.ahead <= 0.12, 'a step without a length adds none');
  });
});
