/**
 * The sound of fires of the library: wood has the balance and the crackle of recorded fires, each kind sounds by itself,
 * the level follows the power of a fire, and the example writes the same file twice.
 */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { ROOT, WEB, createSimulation, load } from './library.mjs';
import { measured, soundOfScene } from './sound-signal.mjs';

const { STEP_NUMBERS, createSynthesis } = await load('sound.js');

const RATE = 48_000;
/** Length of a window in which level and power are compared [s]. */
const WINDOW = 0.2;

test('the series has the two parts of each step since the last call', async () => {
  const sim = await createSimulation({ seed: 2 });
  assert.equal(sim.series().length, 0);
  sim.step(30);
  const series = sim.series();
  assert.ok(series instanceof Float32Array);
  assert.equal(series.length, 60 * STEP_NUMBERS);
  const lengths = series.filter((_, at) => at % STEP_NUMBERS === 0);
  assert.ok(Math.abs(lengths.reduce((sum, length) => sum + length, 0) - sim.time) < 1e-6);
  const power = (series.at(1 - STEP_NUMBERS) + series.at(1 - 2 * STEP_NUMBERS)) / 2;
  assert.ok(Math.abs(power - sim.power) < 1e-4 * sim.power);
  assert.equal(sim.series().length, 0);
});

/** Measures of the sound of a scene, without its first second. */
async function measuresOf(preset, seconds = 13) {
  const sim = await createSimulation({ preset, seed: 1 });
  const samples = await soundOfScene(sim, seconds, { seed: 1 });
  sim.free();
  return measured(samples.subarray(RATE));
}

/** Crackles in a second of recorded fires, and how far chance leads from that in twelve seconds: two standard deviations. */
const CRACKLES = [2, 11];
const CHANCE = CRACKLES.map((rate) => 2 * Math.sqrt(rate / 12));

for (const preset of ['campfire', 'fireside', 'burning-logs']) {
  test(`${preset} has the balance and the crackle of recorded fires`, async () => {
    const { octaves, crackles, kurtosis, crest } = await measuresOf(preset);
    const [lowest, low, middle, , , , ...bright] = octaves;
    const all = `${octaves.map(Math.round)}, ${crackles}, ${kurtosis}, ${crest}`;
    assert.ok(lowest <= low && low <= middle + 3, all);
    assert.ok(Math.min(...bright.slice(0, 3)) >= -10, all);
    assert.ok(crackles >= CRACKLES[0] - CHANCE[0] && crackles <= CRACKLES[1] + CHANCE[1], all);
    assert.ok(kurtosis >= 400 && crest >= 28, all);
  });
}

test('each kind of fire sounds by itself', async () => {
  const [campfire, candle, burner, wall] = [
    await measuresOf('campfire', 5),
    await measuresOf('candle', 5),
    await measuresOf('gas-burner', 5),
    await measuresOf('wall-of-fire', 5),
  ];
  assert.ok(candle.level < campfire.level - 20, `a candle is almost silent: ${candle.level} dB`);
  assert.ok(burner.crackles < 1 && burner.kurtosis < 4, `a burner hisses: ${burner.crackles}, ${burner.kurtosis}`);
  assert.ok(Math.max(...burner.octaves.slice(6, 9)) === 0, `a burner hisses: ${burner.octaves}`);
  assert.ok(Math.max(...wall.octaves.slice(5)) < -8, `a wall of fire roars: ${wall.octaves}`);
});

test('the level follows the power of a fire that is lit, grows, is sprayed and goes out', async () => {
  const sim = await createSimulation({
    preset: 'campfire',
    seed: 1,
    params: { spacing: 0.05, fuel_power: 60 },
  });
  const sound = await createSynthesis({ rate: RATE, crackle: 0, hiss: 0 });
  sim.series();
  const windows = [];
  for (let end = WINDOW; end < 5; end += WINDOW) {
    if (end > 1.5 && end < 1.5 + WINDOW) sim.set('fuel_power', 350);
    if (end > 3) for (let x = -0.3; x <= 0.3; x += 0.1) sim.spray(x, 0.9, 0, -4, 15);
    while (sim.time < end) sim.step();
    const series = sim.series();
    let energy = 0;
    for (let at = 0; at < series.length; at += STEP_NUMBERS) energy += series[at] * series[at + 1];
    sound.push(series);
    const [left, right] = [0, 1].map(() => new Float32Array(Math.floor(sound.ahead * RATE)));
    sound.render(left, right);
    const level = Math.sqrt(left.reduce((sum, x) => sum + x * x, 0) / left.length);
    windows.push({ power: energy / WINDOW, level });
  }
  const powers = windows.map(({ power }) => power);
  assert.ok(Math.max(...powers) > 200 && powers.at(-1) < 20, powers.map(Math.round).join());
  // A quick change of the power is louder than either, as when water puts the fire out.
  const levelFrom = (/** @type {number} */ start, /** @type {number} */ end) => {
    const levels = windows.slice(Math.round(start / WINDOW), Math.round(end / WINDOW)).map(({ level }) => level);
    return levels.reduce((sum, level) => sum + level, 0) / levels.length;
  };
  const [weak, strong, out] = [levelFrom(0.6, 1.4), levelFrom(2, 3), levelFrom(4.4, 4.8)];
  assert.ok(strong > 4 * weak && out < 0.1 * weak, `${weak} ${strong} ${out}`);
});

test('the example writes the same samples twice, and other scenes others', () => {
  const folder = mkdtempSync(path.join(tmpdir(), 'hearth-sound-'));
  try {
    const [first, again, other] = ['candle', 'candle', 'classic'].map((scene, at) => {
      const file = path.join(folder, `${at}.wav`);
      const program = path.join(ROOT, 'examples/sound/wav.mjs');
      execFileSync(process.execPath, [program, file, scene, '1'], { env: { ...process.env, HEARTH_WEB: WEB } });
      return readFileSync(file);
    });
    assert.deepEqual(first, again);
    assert.notDeepEqual(first, other);
    assert.equal(first.toString('latin1', 0, 4) + first.toString('latin1', 8, 12), 'RIFFWAVE');
    assert.equal(first.length, 44 + 4 * RATE);
    const samples = new Int16Array(first.buffer.slice(first.byteOffset + 44, first.byteOffset + first.length));
    assert.ok(samples.some((sample) => Math.abs(sample) > 100));
  } finally {
    rmSync(folder, { recursive: true });
  }
});
