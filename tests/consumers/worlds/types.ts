/** Programs as users write them, which a strict compiler accepts. */
import { FlatFire } from 'hearth-fire/flat';
import { FireObject } from 'hearth-fire/three';
import { FireSprite } from 'hearth-fire/pixi';
import { FireImage } from 'hearth-fire/phaser';
import { Container } from 'pixi.js';
import * as Phaser from 'phaser';
import { DepthTexture, Scene } from 'three';

const fire = new FireObject({ preset: 'campfire', shadow: true, values: { wind: 0.5 }, depthTexture: new DepthTexture(8, 8) });
new Scene().add(fire);
fire.wind.set(1, 0, 0);
fire.source.position.x = 0.1;
fire.light.shadow.bias = -0.004;
fire.addEventListener('error', ({ error }) => console.log(error.message));
await fire.fire.set({ fuel_power: 200 });
const power: number = fire.fire.values.fuel_power;
// @ts-expect-error There is no such scene.
new FireObject({ preset: 'campfir' });

const sprite = new FireSprite({ width: 256, height: 256 });
sprite.target = new Container();
new Container().addChild(sprite);

class Cave extends Phaser.Scene {
  create() {
    const image = new FireImage(this, { quality: 'low' });
    this.add.existing(image);
    image.target = this.add.container(1, 2);
    const { x, color } = image.light;
    console.log(x + color + power);
  }
}
console.log(Cave);

const flat = new FlatFire({ preset: 'candle' }, { picture: (picture) => picture.close() });
const { x: left, y: top } = flat.follow({ x: 1, y: 2 }, 3, 1);
console.log(left + top + flat.light.intensity);
// @ts-expect-error The picture has a listener.
new FlatFire({}, {});

