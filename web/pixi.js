/**
 * A fire for PixiJS: a sprite whose texture burns, and which follows a target.
 *
 *     const fire = new FireSprite({ values: { source_width: 0.17 } });
 *     app.stage.addChild(fire);
 *     fire.target = player;
 *
 * Its colours are premultiplied: emission in the colours, which a tint changes, and coverage in alpha.
 */

import { ImageSource, Sprite, Texture } from 'pixi.js';
import { FlatFire } from './flat.js';

/** A fire. */
export class FireSprite extends Sprite {
  /** What carries the fire, at the place of its source: an object or a place in the parent's coordinates. */
  target = { x: 0, y: 0 };
  #image;
  #flat;

  /** @param {import('./pixi.js').FireOptions} [options] */
  constructor(options = {}) {
    const { width = 512, height = 512 } = options;
    const empty = new OffscreenCanvas(width, height);
    // A canvas without a context has no pixels to upload.
    empty.getContext('2d');
    const image = new ImageSource({
      resource: empty,
      alphaMode: 'premultiplied-alpha',
      scaleMode: 'linear',
    });
    super(new Texture({ source: image }));
    this.#image = image;
    this.#flat = new FlatFire(options, {
      picture: (picture) => this.#show(picture),
      error: (error) => this.emit('error', error),
    });
    this.fire = this.#flat.fire;
    this.light = this.#flat.light;
    this.onRender = () => {
      const { x, y } = this.#flat.follow(this.target, this.height);
      this.position.set(x, y);
    };
  }

  /** @param {ImageBitmap} picture */
  #show(picture) {
    const old = this.#image.resource;
    this.#image.resource = picture;
    if (old.width !== picture.width || old.height !== picture.height)
      this.#image.resize(picture.width, picture.height, 1);
    this.#image.update();
    old.close?.();
  }

  /** Frees the fire and its texture. @param {any} [options] */
  destroy(options) {
    this.onRender = /** @type {any} */ (null);
    this.#flat.dispose();
    super.destroy(options);
    const { resource } = this.#image;
    this.#image.destroy();
    resource?.close?.();
  }
}
