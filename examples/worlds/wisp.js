import * as pc from 'playcanvas';
import { Fire } from './playcanvas-fire.js';

const canvas = document.querySelector('main').appendChild(document.createElement('canvas'));
const app = new pc.AppBase(canvas);
app.init({
  graphicsDevice: new pc.WebglGraphicsDevice(canvas, { antialias: true }),
  componentSystems: [pc.RenderComponentSystem, pc.CameraComponentSystem, pc.LightComponentSystem],
  resourceHandlers: [],
});
app.setCanvasFillMode(pc.FILLMODE_FILL_WINDOW);
app.setCanvasResolution(pc.RESOLUTION_AUTO);
app.scene.ambientLight = new pc.Color(0.16, 0.19, 0.3);

const bark = new pc.StandardMaterial();
bark.diffuse = new pc.Color(0.36, 0.3, 0.25);
const moss = new pc.StandardMaterial();
moss.diffuse = new pc.Color(0.22, 0.26, 0.18);
for (const material of [bark, moss]) {
  material.gloss = 0.1;
  material.update();
}
const put = (type, material, x, y, z, size) => {
  const entity = new pc.Entity();
  entity.addComponent('render', { type, material });
  entity.setPosition(x, y, z);
  entity.setLocalScale(...size);
  app.root.addChild(entity);
  return entity;
};

// A clearing with trunks, among which a wisp flies.
put('plane', moss, 0, 0, 0, [40, 1, 40]);
for (let i = 0; i < 30; i += 1) {
  const turn = 2.4 * i;
  const away = i < 3 ? 0.5 : 3.9 + 0.25 * i;
  const thick = 0.22 + 0.12 * Math.sin(5 * i) ** 2;
  const trunk = put('cylinder', bark, away * Math.sin(turn), 2.5, away * Math.cos(turn), [thick, 5, thick]);
  trunk.rotate(2 * Math.sin(3 * i), 0, 2 * Math.cos(7 * i));
}

const camera = new pc.Entity('camera');
camera.addComponent('camera', { clearColor: new pc.Color(0.02, 0.03, 0.06), nearClip: 0.1, farClip: 60 });
app.root.addChild(camera);

const values = { source_width: 0.16, fuel_power: 150, emission_speed: 1, palette: 'ghost' };
const fire = new Fire({ warm: 1, values }, app, camera);
fire.intensity = 110;

// Drag to look around.
let angle = 0.3;
canvas.style.touchAction = 'none';
canvas.addEventListener('pointermove', (event) => event.buttons > 0 && (angle -= event.movementX / 200));
let age = 0;
app.on('update', (passed) => {
  age += passed;
  // It circles before and behind the trunks.
  fire.target.set(1.15 * Math.sin(0.3 * age), 0.7 + 0.15 * Math.sin(1.3 * age), 1.15 * Math.cos(0.3 * age));
  camera.setPosition(3.6 * Math.sin(angle), 1.4, 3.6 * Math.cos(angle));
  camera.lookAt(0, 0.9, 0);
  // A narrow window sees the whole clearing, too.
  camera.camera.fov = innerWidth < innerHeight ? 65 : 45;
});
app.start();
// For the tests.
Object.assign(globalThis, { game: { fire, app, look: (a) => (angle = a) } });
