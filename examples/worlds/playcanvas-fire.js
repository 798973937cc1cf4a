/**
 * A fire for PlayCanvas: a sheet that faces the camera about the vertical. Its source follows a target, and what has left
 * the source stays in the world.
 *
 *     const fire = new Fire({ values: { source_width: 0.3 } }, app, camera);
 *     fire.target.copy(torch.getPosition());
 */
import * as pc from 'playcanvas';
import { FlatFire } from 'hearth-fire/flat';

const SHADER = {
  uniqueName: 'hearth-fire',
  attributes: { vertex_position: pc.SEMANTIC_POSITION, vertex_texCoord0: pc.SEMANTIC_TEXCOORD0 },
  vertexGLSL: `
attribute vec3 vertex_position;
attribute vec2 vertex_texCoord0;
uniform mat4 matrix_model;
uniform mat4 matrix_viewProjection;
varying vec2 at;
void main() {
  at = vertex_texCoord0;
  gl_Position = matrix_viewProjection * matrix_model * vec4(vertex_position, 1.0);
}`,
  fragmentGLSL: `
varying vec2 at;
uniform sampler2D fire;
void main() {
  // A world has no edge where the picture ends, but a floor.
  vec2 rim = smoothstep(vec2(0.0), vec2(0.1), vec2(min(at.x, 1.0 - at.x), at.y));
  gl_FragColor = texture2D(fire, at) * rim.x * rim.y;
}`,
};

export class Fire {
  /** What carries the source. */
  target = new pc.Vec3();
  /** How bright the light is. */
  intensity = 1;
  #flat;
  #before;
  #along = 0;

  constructor(options, app, camera) {
    const clamped = { addressU: pc.ADDRESS_CLAMP_TO_EDGE, addressV: pc.ADDRESS_CLAMP_TO_EDGE, mipmaps: false };
    const texture = new pc.Texture(app.graphicsDevice, { ...clamped, minFilter: pc.FILTER_LINEAR });
    const material = new pc.ShaderMaterial(SHADER);
    material.setParameter('fire', texture);
    // Emission in the colours, and coverage in alpha.
    material.blendType = pc.BLEND_PREMULTIPLIED;
    material.depthWrite = false;
    material.cull = pc.CULLFACE_NONE;
    material.update();
    this.entity = new pc.Entity('fire');
    this.sheet = new pc.Entity('sheet');
    this.sheet.addComponent('render', { type: 'plane', material, castShadows: false });
    this.sheet.enabled = false;
    const lamp = new pc.Entity('light');
    this.light = lamp.addComponent('light', { type: 'omni', range: 12, intensity: 0 });
    this.entity.addChild(this.sheet);
    this.entity.addChild(lamp);
    app.root.addChild(this.entity);
    this.#flat = new FlatFire(options, {
      picture: (picture) => {
        texture.setSource(picture);
        texture.setReleaseSourceAfterUpload();
        this.sheet.enabled = true;
      },
    });
    this.fire = this.#flat.fire;
    const place = () => this.#place(camera.getPosition());
    app.on('prerender', place);
    this.entity.once('destroy', () => {
      app.off('prerender', place);
      this.#flat.dispose();
      material.destroy();
      texture.destroy();
    });
  }

  #place(camera) {
    const towards = camera.clone().sub(this.target);
    const angle = Math.atan2(towards.x, towards.z);
    const right = new pc.Vec3(Math.cos(angle), 0, -Math.sin(angle));
    // Motion in depth and turns of the camera are no motion through the gas.
    this.#along += this.target.clone().sub(this.#before ?? this.target).dot(right);
    this.#before = this.target.clone();
    const [left, lower, far, upper] = this.#flat.area;
    const [width, height] = [far - left, upper - lower];
    const corner = this.#flat.follow({ x: this.#along, y: this.target.y }, height, 1);
    const beside = (x, y) => {
      const { x: atX, z: atZ } = this.target;
      return new pc.Vec3(atX + right.x * (x - this.#along), y, atZ + right.z * (x - this.#along));
    };
    this.sheet.setPosition(beside(corner.x + width / 2, corner.y - height / 2));
    this.sheet.setEulerAngles(90, angle * pc.math.RAD_TO_DEG, 0);
    this.sheet.setLocalScale(width, 1, height);
    const { x, y, intensity, color } = this.#flat.light;
    this.light.entity.setPosition(beside(x, y));
    this.light.intensity = this.intensity * intensity;
    this.light.color = new pc.Color((color >> 16) / 255, ((color >> 8) & 255) / 255, (color & 255) / 255);
  }

  destroy() {
    this.entity.destroy();
  }
}
