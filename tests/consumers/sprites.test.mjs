/**
 * PixiJS and Phaser read the atlas of `hearth sprites`: the tiles in order, where they are, and what was cut off. That a
 * tile has its picture is a test of the command.
 */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { serve } from '../e2e/server.mjs';
import { project } from './package.mjs';
import { browser } from './pages.mjs';

const { open } = browser();
const COUNT = 5;
/** @type {import('../e2e/server.mjs').Server} */
let site;
/** @type {any} */
let atlas;

before(async () => {
  const folder = await project('sprites');
  const command = process.env.HEARTH_COMMAND;
  if (!command) throw new Error('HEARTH_COMMAND names no program: `cargo xtask test consumers` builds it');
  const options = `--count ${COUNT} --columns 3 --tile 64x64 --from 0.5 --quality low --trim --atlas json --force`;
  execFileSync(command, ['sprites', 'torch', ...options.split(' '), '--out', path.join(folder, 'flame.png')]);
  atlas = JSON.parse(await readFile(path.join(folder, 'flame.json'), 'utf8'));
  site = await serve(folder);
});
after(() => site?.close());

/** A tile as the atlas has it: its place, the size of the whole and what is cut off to the left and above. */
const tiles = () =>
  Object.values(atlas.frames).map(({ frame, sourceSize, spriteSourceSize }) => [
    ...[frame.x, frame.y, frame.w, frame.h],
    ...[sourceSize.w, sourceSize.h, spriteSourceSize.x, spriteSourceSize.y],
  ]);

test('PixiJS plays the animation that the atlas names', async () => {
  const tab = await open(`${site.origin}/`);
  const seen = await tab.page.evaluate(async () => {
    const { Assets, AnimatedSprite } = /** @type {any} */ (globalThis).PIXI;
    const sheet = await Assets.load('flame.json');
    const { textures } = new AnimatedSprite(sheet.animations.flame);
    return textures.map(({ frame, orig, trim }) => [
      ...[frame.x, frame.y, frame.width, frame.height],
      ...[orig.width, orig.height, trim?.x ?? 0, trim?.y ?? 0],
    ]);
  });
  assert.equal(seen.length, COUNT);
  assert.deepEqual(seen, tiles());
  assert.deepEqual(tab.problems, []);
});

test('Phaser makes an animation of the frames by their prefix', async () => {
  const tab = await open(`${site.origin}/`);
  const seen = await tab.page.evaluate(
    (end) =>
      new Promise((resolve) => {
        const { Phaser } = /** @type {any} */ (globalThis);
        const scene = {
          /** @this {any} */
          preload() {
            this.load.atlas('flame', 'flame.png', 'flame.json');
          },
          /** @this {any} */
          create() {
            const frames = this.anims.generateFrameNames('flame', { prefix: 'flame-', zeroPad: 4, end });
            const animation = this.anims.create({ key: 'burns', frames, frameRate: 30 });
            resolve(
              animation.frames.map(({ frame }) => [
                ...[frame.cutX, frame.cutY, frame.cutWidth, frame.cutHeight],
                ...[frame.realWidth, frame.realHeight, frame.x, frame.y],
              ]),
            );
          },
        };
        new Phaser.Game({ type: Phaser.CANVAS, width: 64, height: 64, audio: { noAudio: true }, banner: false, scene });
      }),
    COUNT - 1,
  );
  assert.equal(seen.length, COUNT);
  assert.deepEqual(seen, tiles());
  assert.deepEqual(tab.problems, []);
});
