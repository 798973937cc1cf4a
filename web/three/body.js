/**
 * The body of a fire in a scene of three.js: its sheets, its embers, its light, its motion. The materials are those of the
 * renderer: shaders in GLSL of `hearth-fire/three`, nodes of `hearth-fire/three/webgpu`.
 *
 * @typedef {{[name: string]: {value: any}}} Uniforms
 * @typedef {{uniforms: Uniforms, sheets: any, embers: any}} Materials
 */

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  CustomBlending,
  DoubleSide,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  LinearFilter,
  Mesh,
  NoToneMapping,
  Object3D,
  OneFactor,
  OneMinusSrcAlphaFactor,
  PointLight,
  Sphere,
  Texture,
  Vector2,
  Vector3,
  Vector4,
} from 'three';
import { Motion } from '../worlds/motion.js';
import { FireSource } from '../worlds/source.js';

/** How the premultiplied colours of a fire go into a picture. */
export const BLENDED = {
  transparent: true,
  depthWrite: false,
  side: DoubleSide,
  forceSinglePass: true,
  blending: CustomBlending,
  blendSrc: OneFactor,
  blendDst: OneMinusSrcAlphaFactor,
};

/** Sheets of a fire, and columns and rows of the atlas: `atlas_size` of the renderer. */
const SHEETS = 5;
const [COLUMNS, ROWS] = [5, 2];
/** Numbers of an ember in the engine's `lights`, and of what is before the embers. */
const PER_EMBER = 8;
const BEFORE_EMBERS = 11;
/** Most embers that are drawn. */
const MAX_EMBERS = 1024;
/** Intensity of the light of gas of 1500 K [cd/m²], and the time in which it follows the fire [pictures]. */
const INTENSITY = 90;
const LIGHT_PICTURES = 2;
/** Depth of a fire in widths of its source: it is about as deep as wide. */
const DEPTH = 0.8;
/** Distances over which it fades before things and the camera, in widths of its source. */
const SOFT = 0.35;
const CLOSE = 1;
/** Smallest change of the wind that the fire feels, and its strongest wind [m/s]. */
const BREEZE = 0.03;
const MAX_WIND = 3;

/** White in its colour, to which eyes by a fire have adapted. */
const PALER = 0.2;
const WHITE = new Color(0xffffff);

const WORLD_UP = new Vector3();
const POSITION = new Vector3();
const MOVED = new Vector3();

/** A fire, with materials of a renderer. */
export class FireBody extends Object3D {
  isFireObject = true;
  /** Its light, which flickers, sways and has its colour. */
  light = new PointLight(0xff9040, 0, 0, 2);
  /** Where it burns. Its motion along the sheets moves the source through the gas. */
  source = new Object3D();
  /** Wind in the world [m/s]. */
  wind = new Vector3();
  /** Depth of the scene without the fire, for soft edges at things. @type {any} */
  depthTexture;
  /** How bright the light is; 1: as the fire. */
  intensity;
  #texture = new Texture();
  #uniforms;
  #sheets;
  #embers;
  #motion;
  /** Where the source was in the world at the last picture. @type {Vector3 | undefined} */
  #before;
  #blown = 0;
  /** Distance over which it fades at things [m]; 0: that of its source. */
  #soft;

  /**
   * @param {import('../three.js').FireObjectOptions} options
   * @param {(uniforms: {[name: string]: any}) => Materials} materials
   */
  constructor(options, materials) {
    super();
    const { shadow = false, depthTexture, soft = 0, intensity = 1, ...rest } = options;
    if (!(soft >= 0 && intensity >= 0)) throw new RangeError('soft and intensity must be numbers from 0 on');
    this.depthTexture = depthTexture;
    this.intensity = intensity;
    this.#soft = soft;
    Object.assign(this.#texture, {
      flipY: false,
      premultiplyAlpha: true,
      generateMipmaps: false,
      minFilter: LinearFilter,
    });
    const { uniforms, sheets, embers } = materials({
      atlas: this.#texture,
      texels: new Vector2(1, 1),
      area: new Vector4(-1, 0, 1, 2),
      origin: new Vector3(),
      right: new Vector3(1, 0, 0),
      up: new Vector3(0, 1, 0),
      size: 1,
      depth: 0,
      pale: new Vector4(1, 1, 1, 1),
      lens: new Vector4(0.1, 100, 1, 1),
      soft: 0,
      close: 1,
      pixels: 1,
    });
    this.#uniforms = uniforms;
    this.#sheets = new Mesh(sheetGeometry(), sheets);
    this.#embers = new Mesh(emberGeometry(), embers);
    this.#sheets.visible = this.#embers.visible = false;
    // Sparks in front of the flame are drawn over it.
    this.#embers.renderOrder = 1;
    this.#embers.frustumCulled = false;
    this.#sheets.onBeforeRender = (/** @type {any} */ renderer, /** @type {any} */ _, /** @type {any} */ camera) =>
      this.#look(renderer, camera);
    this.light.castShadow = shadow;
    this.add(this.source, this.light, this.#sheets, this.#embers);
    /** The fire: its values, statistics and calls. */
    this.fire = new FireSource(
      rest,
      {
        picture: (picture) => this.#show(picture),
        lights: (numbers) => this.#shine(numbers),
        error: (error) => this.dispatchEvent({ type: 'error', error }),
      },
      true,
    );
    this.#motion = new Motion(this.fire);
  }

  /** Frees the fire, and all that it has on the graphics card. */
  dispose() {
    this.fire.dispose();
    this.removeFromParent();
    for (const { geometry, material } of [this.#sheets, this.#embers]) {
      geometry.dispose();
      for (const one of [material].flat()) one.dispose();
    }
    this.#texture.dispose();
    this.#texture.image?.close?.();
    this.light.dispose();
  }

  /** @param {ImageBitmap} picture */
  #show(picture) {
    const texture = this.#texture;
    const old = texture.image;
    // The storage of a texture has one size.
    if (old && (old.width !== picture.width || old.height !== picture.height)) texture.dispose();
    texture.image = picture;
    texture.needsUpdate = true;
    old?.close?.();
    this.#uniforms.texels.value.set(picture.width / COLUMNS, picture.height / ROWS);
    this.#sheets.visible = true;
    this.dispatchEvent({ type: 'picture' });
    // The engine draws no more pictures than the page shows.
    requestAnimationFrame(() => this.fire.shown());
  }

  /** @param {Float32Array} numbers */
  #shine(numbers) {
    const [left, lower, right, upper, light, x, y] = numbers;
    const { area, pale, depth, close, size } = this.#uniforms;
    const width = this.fire.values.source_width;
    area.value.set(left, lower, right, upper);
    pale.value.fromArray(numbers, 7);
    depth.value = DEPTH * width;
    close.value = CLOSE * width * size.value;
    this.#sheets.geometry.boundingSphere.set(
      POSITION.set(0, (lower + upper) / 2, 0),
      Math.hypot(upper - lower, right - left),
    );
    this.#kindle(light, x, y);
    this.#scatter(numbers.subarray(BEFORE_EMBERS));
    this.#move();
  }

  /** @param {number} light @param {number} x @param {number} y */
  #kindle(light, x, y) {
    const { origin, right, up, size } = this.#uniforms;
    const at = POSITION.copy(origin.value);
    at.addScaledVector(right.value, x * size.value).addScaledVector(up.value, y * size.value);
    if (light > 0) this.light.position.lerp(this.worldToLocal(at), 1 / LIGHT_PICTURES);
    const bright = INTENSITY * this.intensity * light * size.value ** 2;
    this.light.intensity += (bright - this.light.intensity) / LIGHT_PICTURES;
    if (this.fire.stats.glow) this.light.color.set(this.fire.stats.glow).lerp(WHITE, PALER);
  }

  /** @param {Float32Array} records */
  #scatter(records) {
    const { geometry } = this.#embers;
    const { ember, seed } = geometry.attributes;
    const count = Math.min(records.length / PER_EMBER, MAX_EMBERS);
    for (let i = 0; i < count; i += 1) {
      const [x, y, , , kelvin, diameter, , life] = records.subarray(PER_EMBER * i, PER_EMBER * (i + 1));
      ember.setXYZW(i, x, y, kelvin, life);
      seed.setX(i, diameter);
    }
    ember.needsUpdate = seed.needsUpdate = true;
    geometry.instanceCount = count;
    this.#embers.visible = count > 0;
  }

  /** Moves the source through the gas as it has moved along the sheets, and lets the wind blow. */
  #move() {
    const { right, up, size, area } = this.#uniforms;
    const now = this.source.getWorldPosition(new Vector3());
    MOVED.copy(now)
      .sub(this.#before ?? now)
      .divideScalar(size.value);
    this.#motion.move(MOVED.dot(right.value), MOVED.dot(up.value), area.value.toArray());
    this.#before = now;
    const wind = Math.min(Math.max(this.wind.dot(right.value), -MAX_WIND), MAX_WIND);
    if (Math.abs(wind - this.#blown) > BREEZE) {
      this.#blown = wind;
      this.fire.set({ wind });
    }
  }

  /**
   * Turns the sheets to the camera.
   * @param {any} renderer @param {any} camera
   */
  #look(renderer, camera) {
    const { origin, right, up, size, lens, pixels, sceneDepth, soft, mapped } = this.#uniforms;
    const { elements: m } = this.matrixWorld;
    size.value = Math.hypot(m[4], m[5], m[6]);
    WORLD_UP.set(m[4], m[5], m[6]).normalize();
    const at = this.source.getWorldPosition(POSITION);
    const { elements: c } = camera.matrixWorld;
    const towards = MOVED.set(c[12], c[13], c[14]).sub(at);
    if (camera.isOrthographicCamera) towards.set(c[8], c[9], c[10]);
    right.value.crossVectors(WORLD_UP, towards);
    // From straight above, the camera's right side.
    if (right.value.lengthSq() < 1e-6 * towards.lengthSq()) right.value.set(c[0], c[1], c[2]);
    right.value.normalize();
    up.value.copy(WORLD_UP);
    origin.value.copy(at).addScaledVector(right.value, size.value * (this.#motion.restX - this.#motion.x));
    origin.value.addScaledVector(WORLD_UP, size.value * (this.#motion.restY - this.#motion.y));
    const target = renderer.getRenderTarget();
    const { width, height } = target ?? renderer.getDrawingBufferSize(new Vector2());
    lens.value.set(camera.near, camera.far, 1 / width, 1 / height);
    pixels.value = 0.5 * height * camera.projectionMatrix.elements[5];
    // Nodes read the depth of the scene by themselves, and give light: the renderer maps it, or nobody does.
    if (sceneDepth) sceneDepth.value = this.depthTexture ?? null;
    if (mapped) mapped.value = Number(renderer.toneMapping === NoToneMapping && isForScreen(target));
    soft.value = mapped || this.depthTexture ? this.#soft || SOFT * (this.fire.values.source_width ?? 0) : 0;
  }
}

/** Whether a picture in that target is shown. @param {any} target */
const isForScreen = (target) => !target || target.isPostProcessingRenderTarget === true;

/** Squares, from the back, so that each is drawn over those behind it. */
function sheetGeometry() {
  const geometry = new BufferGeometry();
  const corners = [];
  const sheets = [];
  const index = [];
  for (let sheet = SHEETS - 1; sheet >= 0; sheet -= 1) {
    const first = sheets.length;
    corners.push(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0);
    sheets.push(sheet, sheet, sheet, sheet);
    // Each material of several draws a sheet before the one in front of it.
    for (const material of [0, 1]) geometry.addGroup(index.length, 6, material);
    index.push(...[0, 1, 2, 2, 1, 3].map((corner) => first + corner));
  }
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(corners), 3));
  geometry.setAttribute('sheet', new BufferAttribute(new Float32Array(sheets), 1));
  geometry.setIndex(index);
  geometry.boundingSphere = new Sphere(new Vector3(), 10);
  return geometry;
}

/** A square for each ember. */
function emberGeometry() {
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array([-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0]), 3));
  geometry.setAttribute('ember', new InstancedBufferAttribute(new Float32Array(4 * MAX_EMBERS), 4));
  geometry.setAttribute('seed', new InstancedBufferAttribute(new Float32Array(MAX_EMBERS), 1));
  geometry.setIndex([0, 1, 2, 2, 1, 3]);
  geometry.instanceCount = 0;
  return geometry;
}
