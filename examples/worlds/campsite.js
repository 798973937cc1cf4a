import * as THREE from 'three';
import { FireObject } from 'hearth-fire/three';

const renderer = new THREE.WebGLRenderer({ antialias: true });
renderer.shadowMap.enabled = true;
document.querySelector('main').append(renderer.domElement);
const scene = new THREE.Scene();
scene.background = new THREE.Color(0x0a0d18);
scene.add(new THREE.HemisphereLight(0x4a5c84, 0x1a1510, 1.4));
const camera = new THREE.PerspectiveCamera(40, 1, 0.05, 40);

const put = (geometry, colour, roughness = 0.95) => {
  const mesh = new THREE.Mesh(geometry, new THREE.MeshStandardMaterial({ color: colour, roughness, side: THREE.DoubleSide }));
  mesh.castShadow = mesh.receiveShadow = true;
  scene.add(mesh);
  return mesh;
};

const ground = put(new THREE.CircleGeometry(12, 64), 0x4a4030);
ground.rotation.x = -Math.PI / 2;
ground.castShadow = false;

// Logs that lean together over the fire, and a ring of stones.
for (let i = 0; i < 6; i += 1) {
  const turn = (i / 6) * 2 * Math.PI;
  const log = put(new THREE.CylinderGeometry(0.035, 0.045, 0.62, 12), 0x4b2f1c);
  log.position.set(0.2 * Math.sin(turn), 0.12, 0.2 * Math.cos(turn));
  log.rotation.set(-1.05, turn, 0, 'YXZ');
  // Logs in the fire would shade all of its light.
  log.castShadow = false;
}
for (let i = 0; i < 11; i += 1) {
  const turn = (i / 11) * 2 * Math.PI;
  const stone = put(new THREE.IcosahedronGeometry(0.09 + 0.025 * Math.sin(7 * i), 1), 0x6b6660);
  stone.position.set(0.55 * Math.sin(turn), 0.04, 0.55 * Math.cos(turn));
  stone.rotation.set(i, 2 * i, 3 * i);
}

// A tent and two seats.
const canvas = new THREE.BufferGeometry();
const [w, h, d] = [0.9, 1.1, 1];
const corners = [[-w, 0, d], [0, h, d], [0, h, -d], [-w, 0, -d], [w, 0, d], [w, 0, -d]];
const faces = [0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2, 3, 2, 5];
canvas.setAttribute('position', new THREE.Float32BufferAttribute(faces.flatMap((corner) => corners[corner]), 3));
canvas.computeVertexNormals();
const tent = put(canvas, 0xb08a54);
tent.position.set(-1.5, 0, -1.5);
tent.rotation.y = 0.8;
for (const [x, z, turn] of [[1.3, -0.6, 0.5], [0.8, 1.2, -0.9]]) {
  const seat = put(new THREE.CylinderGeometry(0.14, 0.15, 1.1, 18), 0x3d2a1b);
  seat.position.set(x, 0.14, z);
  seat.rotation.set(Math.PI / 2, 0, turn, 'YXZ');
  seat.rotation.y = turn;
}

const fire = new FireObject({ preset: 'campfire', warm: 2, shadow: true });
fire.light.shadow.mapSize.set(1024, 1024);
fire.light.shadow.bias = -0.004;
scene.add(fire);

function fit() {
  renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
  renderer.setSize(innerWidth, innerHeight);
  camera.aspect = innerWidth / innerHeight;
  // A narrow window sees the whole camp, too.
  camera.fov = camera.aspect < 1 ? 60 : 40;
  camera.updateProjectionMatrix();
}
addEventListener('resize', fit);
fit();

// Drag to look around; the wind turns slowly.
let angle = 0.4;
let height = 1.3;
renderer.domElement.style.touchAction = 'none';
renderer.domElement.addEventListener('pointermove', (event) => {
  if (event.buttons === 0) return;
  angle -= event.movementX / 200;
  height = Math.min(Math.max(height + event.movementY / 200, 0.2), 4);
});
renderer.setAnimationLoop((now) => {
  fire.wind.set(0.5 * Math.sin(now / 5000), 0, 0.5 * Math.cos(now / 5000));
  camera.position.set(4.4 * Math.sin(angle), height, 4.4 * Math.cos(angle));
  camera.lookAt(0, 0.6, 0);
  renderer.render(scene, camera);
});
// For the tests.
Object.assign(globalThis, { camp: { fire, renderer, look: (a, h) => ([angle, height] = [a, h]) } });
