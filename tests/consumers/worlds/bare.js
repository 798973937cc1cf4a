/**
 * What the tests of `hearth-fire/three` do in a page: a scene with one fire, which stands still. The import map of the page
 * says which three.js and which `FireObject` they are.
 */
import { FireObject } from 'hearth-fire/three';
import * as THREE from 'three';
import { SIDE, difference, elementAt, read } from './beside.js';

const START = { width: SIDE, height: SIDE, quality: 'low', paused: true };
const SECONDS = 1.5;

const isNodes = 'WebGPURenderer' in THREE;
const renderer = isNodes
  ? new THREE.WebGPURenderer({ alpha: true, forceWebGL: true })
  : new THREE.WebGLRenderer({ alpha: true });
await renderer.init?.();
renderer.setSize(SIDE, SIDE);
document.body.append(renderer.domElement);

/** A fire whose picture of that moment is uploaded. */
async function burning(values, seconds = SECONDS, options = {}) {
  const fire = new FireObject({ ...START, ...options, values: { ember_rate: 0, seed: 7, ...values } });
  await fire.fire.ready;
  const scene = new THREE.Scene();
  scene.add(fire);
  const height = fire.fire.values.domain_height;
  const camera = new THREE.OrthographicCamera(-height / 2, height / 2, height, 0, 0.1, 20);
  camera.position.z = 5;
  await fire.fire.call('advance', seconds);
  // Its answer follows the picture, whose texture is new then.
  await new Promise(requestAnimationFrame);
  return { fire, scene, camera };
}

/** The pixels of a scene over a colour. */
function pixels({ scene, camera }, background) {
  renderer.setClearColor(background, 1);
  renderer.render(scene, camera);
  return read(renderer.domElement, background);
}

/** Sums of red and green of all pixels. */
const sums = (data) =>
  [0, 1].map((channel) => data.reduce((sum, value, i) => sum + (i % 4 === channel ? value : 0), 0));

/** Frees a fire and the things in its scene. */
function free({ fire, scene }) {
  fire.dispose();
  scene.traverse(({ geometry }) => geometry?.dispose());
}

/** A green plate at a distance before the middle of the fire. */
function plate(z) {
  const mesh = new THREE.Mesh(new THREE.PlaneGeometry(9, 9), new THREE.MeshBasicMaterial({ color: 0x00ff00 }));
  mesh.position.z = z;
  return mesh;
}

Object.assign(globalThis, {
  worlds: {
    /** Red and green light with a green plate behind, amid and before the sheets. */
    async plates() {
      const made = await burning();
      const seen = {};
      for (const [place, z] of Object.entries({ behind: -2, amid: 0.09, before: 2 })) {
        const mesh = plate(z);
        made.scene.add(mesh);
        seen[place] = sums(pixels(made, '#000000'));
        made.scene.remove(mesh);
        mesh.geometry.dispose();
      }
      made.fire.dispose();
      return seen;
    },
    /** The red light before a plate close behind the first sheet, with edges of a millimetre and with those of a fire. */
    async soft() {
      const target = new THREE.WebGLRenderTarget(SIDE, SIDE, { depthTexture: new THREE.DepthTexture(SIDE, SIDE) });
      const seen = [];
      for (const soft of [0.001, 0]) {
        const made = await burning({}, SECONDS, { soft });
        made.scene.add(plate(0.08));
        if (!isNodes) {
          made.fire.visible = false;
          renderer.setRenderTarget(target);
          renderer.render(made.scene, made.camera);
          renderer.setRenderTarget(null);
          made.fire.visible = true;
          made.fire.depthTexture = target.depthTexture;
        }
        seen.push(sums(pixels(made, '#000000'))[0]);
        free(made);
      }
      target.dispose();
      target.depthTexture.dispose();
      return seen;
    },
    /** The red light of embers alone, with a plate behind, amid and before them. */
    async embers() {
      const made = await burning({ ember_rate: 400 }, 3);
      pixels(made, '#000000');
      const embers = made.fire.children.find(({ geometry }) => geometry?.isInstancedBufferGeometry);
      for (const child of made.fire.children) if (child.isMesh) child.visible = child === embers;
      const seen = [-2, 0, 2].map((z) => {
        const mesh = plate(z);
        made.scene.add(mesh);
        const [red] = sums(pixels(made, '#000000'));
        made.scene.remove(mesh);
        mesh.geometry.dispose();
        return red;
      });
      made.fire.dispose();
      return seen;
    },
    /** The red light of a fire before a camera at those places. */
    async passing(places) {
      const made = await burning();
      const seen = places.map((z) => {
        made.camera.position.z = z;
        return sums(pixels(made, '#000000'))[0];
      });
      made.fire.dispose();
      return seen;
    },
    /** The wind in the gas, for a wind in the world to the right, towards the camera, and to the left of a camera at its side [m/s]. */
    async winds() {
      const made = await burning();
      const felt = [];
      const feel = async () => {
        pixels(made, '#000000');
        await made.fire.fire.call('advance', 0.05);
        await made.fire.fire.call('advance', 0.05);
        felt.push(made.fire.fire.values.wind);
      };
      made.fire.wind.set(0.8, 0, 0);
      await feel();
      made.fire.wind.set(0, 0, 0.8);
      await feel();
      made.camera.position.set(5, 0, 0);
      made.camera.lookAt(0, 0, 0);
      made.scene.updateMatrixWorld();
      await feel();
      made.fire.dispose();
      return felt;
    },
    /** Three fires at once. */
    async several() {
      const all = await Promise.all([1, 2, 3].map(() => burning({}, 0.1)));
      this.burning = all;
    },
    freeSeveral() {
      this.burning.forEach(free);
    },
    /** The brightest light of a fire in a target of half floats. */
    async light() {
      const made = await burning();
      const target = new THREE.WebGLRenderTarget(SIDE, SIDE, { type: THREE.HalfFloatType });
      renderer.setClearColor('#000000', 1);
      renderer.setRenderTarget(target);
      renderer.render(made.scene, made.camera);
      const last = isNodes ? 0 : new Uint16Array(4 * SIDE * SIDE);
      const halves = await renderer.readRenderTargetPixelsAsync(target, 0, 0, SIDE, SIDE, last);
      renderer.setRenderTarget(null);
      target.dispose();
      made.fire.dispose();
      return Math.max(...halves.map((half) => 1000 * THREE.DataUtils.fromHalfFloat(half))) / 1000;
    },
    /** Differences from the element over black and white. */
    async differences() {
      const { element, picture } = await elementAt(SECONDS);
      const made = await burning();
      const of = (background, value) => difference(pixels(made, background), read(picture, background), value);
      const all = {
        black: of('#000000', 0),
        white: of('#ffffff', 255),
        times: [element.stats.time, made.fire.fire.stats.time],
      };
      made.fire.dispose();
      element.remove();
      return all;
    },
    /** Intensity of the light at two powers. */
    async lights() {
      const seen = [];
      for (const power of [60, 300]) {
        const { fire, scene, camera } = await burning({ fuel_power: power });
        pixels({ scene, camera }, '#000000');
        for (let i = 0; i < 8; i += 1) await fire.fire.call('advance', 0.05);
        seen.push(fire.light.intensity);
        fire.dispose();
      }
      return seen;
    },
    /** Where the source is in its fire after a motion along the sheets, in depth and of the camera [m]. */
    async motions() {
      const made = await burning();
      const places = [];
      const step = async () => {
        pixels(made, '#000000');
        await made.fire.fire.call('advance', 0.05);
        pixels(made, '#000000');
        await made.fire.fire.call('advance', 0.05);
        places.push(made.fire.fire.values.source_x);
      };
      await step();
      made.fire.source.position.x = 0.2;
      await step();
      made.fire.source.position.z = 0.5;
      await step();
      made.camera.position.set(5, 0, 0);
      made.camera.lookAt(0, 0, 0);
      made.scene.updateMatrixWorld();
      await step();
      made.fire.dispose();
      return places;
    },
    /** Mounts and unmounts fires; returns what the renderer has after the first and after the last. */
    async mounts(count) {
      const had = [];
      for (let i = 0; i < count; i += 1) {
        const made = await burning({}, 0.1);
        pixels(made, '#000000');
        made.fire.dispose();
        const { textures, geometries } = renderer.info.memory;
        had.push({ textures, geometries });
      }
      return [had[0], had.at(-1)];
    },
    /** What a wrong option, preset and value give. */
    async refusals() {
      const told = [];
      for (const options of [{ presett: 'campfire' }, { width: 8 }, { warm: 'long' }, { soft: -1 }]) {
        try {
          new FireObject(options);
        } catch (error) {
          told.push(error.message);
        }
      }
      const made = await burning({}, 0.1);
      made.fire.addEventListener('error', ({ error }) => told.push(error.message));
      await made.fire.fire.set({ fuel_power: -1 }).catch(() => {});
      made.fire.dispose();
      return told;
    },
  },
});
