import { ArcRotateCamera } from '@babylonjs/core/Cameras/arcRotateCamera.js';
import { Engine } from '@babylonjs/core/Engines/engine.js';
import { HemisphericLight } from '@babylonjs/core/Lights/hemisphericLight.js';
import { ShadowGenerator } from '@babylonjs/core/Lights/Shadows/shadowGenerator.js';
import { StandardMaterial } from '@babylonjs/core/Materials/standardMaterial.js';
import { Color3, Color4 } from '@babylonjs/core/Maths/math.color.js';
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { CreateCylinder } from '@babylonjs/core/Meshes/Builders/cylinderBuilder.js';
import { CreateDisc } from '@babylonjs/core/Meshes/Builders/discBuilder.js';
import { Scene } from '@babylonjs/core/scene.js';
import { Fire } from './babylon-fire.js';

const canvas = document.querySelector('main').appendChild(document.createElement('canvas'));
canvas.style.cssText = 'width: 100vw; height: 100vh; touch-action: none';
const engine = new Engine(canvas, true, {}, true);
const scene = new Scene(engine);
scene.clearColor = Color4.FromHexString('#0a0d18ff');
const sky = new HemisphericLight('sky', new Vector3(0, 1, 0), scene);
sky.diffuse = Color3.FromHexString('#4a5c84');
sky.groundColor = Color3.FromHexString('#1a1510');
sky.intensity = 0.8;

const stone = new StandardMaterial('stone', scene);
stone.diffuseColor = Color3.FromHexString('#9a9184');
stone.specularColor = Color3.Black();
stone.maxSimultaneousLights = 2;
const put = (mesh, x, y, z) => {
  mesh.position.set(x, y, z);
  mesh.material = stone;
  mesh.receiveShadows = true;
  return mesh;
};
put(CreateDisc('ground', { radius: 12, tessellation: 64 }, scene), 0, 0, 0).rotation.x = Math.PI / 2;

// A ring of pillars around a bowl on a foot.
const pillars = [];
for (let i = 0; i < 7; i += 1) {
  const turn = (i / 7) * 2 * Math.PI;
  const [x, z] = [2.1 * Math.sin(turn), 2.1 * Math.cos(turn)];
  // Some are broken.
  const tall = [2.6, 2.6, 1.1, 2.6, 0.5, 2.6, 1.7][i];
  pillars.push(put(CreateCylinder('pillar', { diameter: 0.42, height: tall, tessellation: 24 }, scene), x, tall / 2, z));
  put(CreateCylinder('base', { diameter: 0.62, height: 0.14, tessellation: 24 }, scene), x, 0.07, z);
}
put(CreateCylinder('foot', { diameterTop: 0.2, diameterBottom: 0.34, height: 0.6 }, scene), 0, 0.3, 0);
put(CreateCylinder('bowl', { diameterTop: 0.66, diameterBottom: 0.2, height: 0.2 }, scene), 0, 0.7, 0);

const fire = new Fire({ warm: 2, values: { source_width: 0.34, fuel_power: 240 } }, scene);
fire.target.y = 0.8;
fire.intensity = 9;
fire.light.range = 12;
// Pillars cast shadows; the bowl would shade all of its light.
const shadows = new ShadowGenerator(512, fire.light);
shadows.usePoissonSampling = true;
for (const pillar of pillars) shadows.addShadowCaster(pillar);

// Drag to look around.
const camera = new ArcRotateCamera('camera', -1.7, 1.36, 5.6, new Vector3(0, 1, 0), scene);
camera.attachControl(canvas, true);
Object.assign(camera, { lowerRadiusLimit: 2, upperRadiusLimit: 9, upperBetaLimit: 1.5, minZ: 0.1 });
const fit = () => {
  engine.resize();
  // A narrow window sees the whole ring, too.
  camera.fov = innerWidth < innerHeight ? 1.2 : 0.7;
};
addEventListener('resize', fit);
fit();
engine.runRenderLoop(() => scene.render());
// For the tests.
Object.assign(globalThis, { game: { fire, scene, camera } });
