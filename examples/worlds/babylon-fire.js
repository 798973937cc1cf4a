/**
 * A fire for Babylon.js: a sheet that faces the camera about the vertical. Its source follows a target, and what has left
 * the source stays in the world.
 *
 *     const fire = new Fire({ values: { source_width: 0.3 } }, scene);
 *     fire.target = torch.position;
 */
import { ShaderMaterial } from '@babylonjs/core/Materials/shaderMaterial.js';
import { DynamicTexture } from '@babylonjs/core/Materials/Textures/dynamicTexture.js';
import { Constants } from '@babylonjs/core/Engines/constants.js';
import { PointLight } from '@babylonjs/core/Lights/pointLight.js';
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { CreatePlane } from '@babylonjs/core/Meshes/Builders/planeBuilder.js';
import { FlatFire } from 'hearth-fire/flat';

const vertexSource = `
attribute vec3 position;
attribute vec2 uv;
uniform mat4 worldViewProjection;
varying vec2 at;
void main() {
  at = vec2(uv.x, 1.0 - uv.y); // Pictures begin above.
  gl_Position = worldViewProjection * vec4(position, 1.0);
}`;
const fragmentSource = `
varying vec2 at;
uniform sampler2D fire;
void main() {
  // A world has no edge where the picture ends, but a floor.
  vec2 rim = smoothstep(vec2(0.0), vec2(0.1), vec2(min(at.x, 1.0 - at.x), at.y));
  gl_FragColor = texture2D(fire, at) * rim.x * rim.y;
}`;

export class Fire {
  /** What carries the source. */
  target = new Vector3();
  /** How bright the light is. */
  intensity = 1;
  #flat;
  #before;
  #along = 0;

  constructor(options, scene) {
    const engine = scene.getEngine();
    this.mesh = CreatePlane('fire', {}, scene);
    this.mesh.isVisible = false;
    this.light = new PointLight('fire', new Vector3(), scene);
    this.light.intensity = 0;
    const texture = new DynamicTexture('fire', { width: 1, height: 1 }, scene);
    const names = { attributes: ['position', 'uv'], uniforms: ['worldViewProjection'], samplers: ['fire'] };
    const sources = { vertexSource, fragmentSource };
    const material = new ShaderMaterial('fire', scene, sources, { ...names, needAlphaBlending: true });
    material.setTexture('fire', texture);
    material.backFaceCulling = false;
    // Emission in the colours, and coverage in alpha.
    material.alphaMode = Constants.ALPHA_PREMULTIPLIED_PORTERDUFF;
    this.mesh.material = material;
    this.#flat = new FlatFire(options, {
      picture: (picture) => {
        engine.updateDynamicTexture(texture.getInternalTexture(), picture, false);
        picture.close();
        this.mesh.isVisible = true;
      },
    });
    this.fire = this.#flat.fire;
    const observer = scene.onBeforeRenderObservable.add(() => this.#place(scene.activeCamera));
    this.mesh.onDisposeObservable.add(() => {
      observer.remove();
      this.#flat.dispose();
      this.light.dispose();
      material.dispose(false, true);
    });
  }

  #place(camera) {
    const towards = camera.globalPosition.subtract(this.target);
    const angle = Math.atan2(-towards.x, -towards.z);
    const right = new Vector3(Math.cos(angle), 0, -Math.sin(angle));
    // Motion in depth and turns of the camera are no motion through the gas.
    this.#along += Vector3.Dot(this.target.subtract(this.#before ?? this.target), right);
    this.#before = this.target.clone();
    const [left, lower, far, upper] = this.#flat.area;
    const [width, height] = [far - left, upper - lower];
    const corner = this.#flat.follow({ x: this.#along, y: this.target.y }, height, 1);
    const beside = (x, y) => this.target.add(right.scale(x - this.#along)).multiplyByFloats(1, 0, 1).add(new Vector3(0, y, 0));
    this.mesh.position = beside(corner.x + width / 2, corner.y - height / 2);
    this.mesh.rotation.y = angle;
    this.mesh.scaling.set(width, height, 1);
    const { x, y, intensity, color } = this.#flat.light;
    this.light.position = beside(x, y);
    this.light.intensity = this.intensity * intensity;
    this.light.diffuse.set((color >> 16) / 255, ((color >> 8) & 255) / 255, (color & 255) / 255);
  }

  dispose() {
    this.mesh.dispose();
  }
}
