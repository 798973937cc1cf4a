/**
 * What the tests of engines that show one picture of a fire do in a page: a fire that stands still, alone in a world as
 * large as its picture.
 */
import { SIDE, difference, elementAt, read } from './beside.js';

const SECONDS = 1.5;
const OPTIONS = { width: SIDE, height: SIDE, quality: 'low', paused: true, values: { ember_rate: 0, seed: 7 } };
/** Height of the world, which the domain of the scene fills, and of its source [m]. */
let [tall, low] = [1, 0];

const canvas = document.body.appendChild(document.createElement('canvas'));
canvas.width = canvas.height = SIDE;

/**
 * A world of each engine: its fire, its pixels over a colour, what carries the source to a place [m], and its end.
 */
const ENGINES = {
  async pixi() {
    const { Application } = await import('pixi.js');
    const { FireSprite } = await import('hearth-fire/pixi');
    const app = new Application();
    await app.init({ canvas, width: SIDE, height: SIDE, autoStart: false, preference: 'webgl' });
    const sprite = app.stage.addChild(new FireSprite(OPTIONS));
    return {
      fire: sprite.fire,
      show(background) {
        app.renderer.background.color = background;
        sprite.width = sprite.height = SIDE;
        app.render();
        return read(canvas, background);
      },
      carry: (x) => (sprite.target = onScreen(x)),
      free: () => sprite.destroy(),
    };
  },
  async phaser() {
    const Phaser = await import('phaser');
    const { FireImage } = await import('hearth-fire/phaser');
    const scene = await new Promise((resolve) => {
      const size = { width: SIDE, height: SIDE, type: Phaser.WEBGL, banner: false, audio: { noAudio: true } };
      const first = class extends Phaser.Scene {
        create() {
          resolve(this);
        }
      };
      new Phaser.Game({ ...size, canvas, scene: first });
    });
    const image = scene.add.existing(new FireImage(scene, OPTIONS)).setDisplaySize(SIDE, SIDE);
    return {
      fire: image.fire,
      show(background) {
        scene.cameras.main.setBackgroundColor(background);
        // Its pixels last until the end of the frame.
        return new Promise((resolve) => scene.game.events.once('postrender', () => resolve(read(canvas, background))));
      },
      carry: (x) => (image.target = onScreen(x)),
      free: () => image.destroy(),
    };
  },
  async babylon() {
    const { Engine } = await import('@babylonjs/core/Engines/engine.js');
    const { Scene } = await import('@babylonjs/core/scene.js');
    const { FreeCamera } = await import('@babylonjs/core/Cameras/freeCamera.js');
    const { Color4 } = await import('@babylonjs/core/Maths/math.color.js');
    const { Vector3 } = await import('@babylonjs/core/Maths/math.vector.js');
    const { Fire } = await import('./babylon-fire.js');
    const scene = new Scene(new Engine(canvas));
    const camera = new FreeCamera('camera', new Vector3(0, 0, -100), scene);
    camera.mode = 1;
    const fire = new Fire(OPTIONS, scene);
    return {
      fire: fire.fire,
      async show(background) {
        scene.clearColor = Color4.FromHexString(background);
        Object.assign(camera, { orthoLeft: -tall / 2, orthoRight: tall / 2, orthoBottom: 0, orthoTop: tall });
        await scene.whenReadyAsync();
        scene.render();
        return read(canvas, background);
      },
      carry: (x) => fire.target.set(x, low, 0),
      free: () => fire.dispose(),
    };
  },
  async playcanvas() {
    const pc = await import('playcanvas');
    const { Fire } = await import('./playcanvas-fire.js');
    const app = new pc.Application(canvas, { graphicsDeviceOptions: { antialias: false } });
    const camera = new pc.Entity();
    camera.addComponent('camera', { projection: pc.PROJECTION_ORTHOGRAPHIC, nearClip: 1, farClip: 200 });
    app.root.addChild(camera);
    const fire = new Fire(OPTIONS, app, camera);
    return {
      fire: fire.fire,
      show(background) {
        camera.camera.clearColor = new pc.Color().fromString(background);
        camera.camera.orthoHeight = tall / 2;
        camera.setPosition(0, tall / 2, 100);
        app.render();
        return read(canvas, background);
      },
      carry: (x) => fire.target.set(x, low, 0),
      free: () => fire.destroy(),
    };
  },
};

/** A place of the world in pixels. */
const onScreen = (x) => ({ x: SIDE * (0.5 + x / tall), y: SIDE * (1 - low / tall) });

let world;

Object.assign(globalThis, {
  worlds: {
    /** Differences from the element over black and white, and the ages of both fires. */
    async differences(engine) {
      const { element, picture } = await elementAt(SECONDS);
      [tall, low] = [element.params.domain_height, element.params.source_height];
      world = await ENGINES[engine]();
      const { fire } = world;
      world.carry(0);
      await fire.call('advance', SECONDS);
      const of = async (background, value) =>
        difference(await world.show(background), read(picture, background), value);
      const seen = { black: await of('#000000', 0), white: await of('#ffffff', 255) };
      const times = [element.stats.time, fire.stats.time];
      element.remove();
      return { ...seen, times };
    },
    /** How far the source is carried through the gas [m], and how much that changes the picture. */
    async carried(x) {
      const before = await world.show('#000000');
      world.carry(x);
      const after = await world.show('#000000');
      await world.fire.call('advance', 0.05);
      return { source: world.fire.values.source_x, change: difference(after, before, 0).mean };
    },
    free() {
      world.free();
    },
  },
});
