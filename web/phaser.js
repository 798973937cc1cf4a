/**
 * A fire for Phaser: an image whose texture burns, and which follows a target.
 *
 *     const fire = new FireImage(scene, { values: { source_width: 0.17 } });
 *     scene.add.existing(fire);
 *     fire.target = player;
 */

import { GameObjects } from 'phaser';
import { FlatFire } from './flat.js';

/** Number of the last texture, whose names differ. */
let last = 0;

/** A fire. */
export class FireImage extends GameObjects.Image {
  /** What carries the fire, at the place of its source: an object or a place in the world. */
  target = { x: 0, y: 0 };
  #canvas;
  #flat;

  /** @param {any} scene @param {import('./phaser.js').FireOptions} [options] */
  constructor(scene, options = {}) {
    last += 1;
    const key = `hearth-fire-${last}`;
    const canvas = scene.textures.createCanvas(key, options.width ?? 512, options.height ?? 512);
    super(scene, 0, 0, key);
    this.#canvas = canvas;
    this.setOrigin(0, 0);
    this.#flat = new FlatFire(options, {
      picture: (picture) => this.#show(picture),
      error: (error) => this.emit('error', error),
    });
    this.fire = this.#flat.fire;
    this.light = this.#flat.light;
    scene.events.on('prerender', this.#follow, this);
    this.once('destroy', this.#free, this);
  }

  /** @param {ImageBitmap} picture */
  #show(picture) {
    const { context, width, height } = this.#canvas;
    context.clearRect(0, 0, width, height);
    context.drawImage(picture, 0, 0, width, height);
    picture.close();
    this.#canvas.refresh();
  }

  #follow() {
    const { x, y } = this.#flat.follow(this.target, this.displayHeight);
    this.setPosition(x, y);
  }

  #free() {
    this.scene?.events.off('prerender', this.#follow, this);
    this.#flat.dispose();
    this.#canvas.destroy();
  }
}
