/** What a user of the package writes, and what the compiler must not let through. */
import { HearthFire, type HearthConfig, type HearthStats } from 'hearth-fire';
import { HearthFire as Inlined } from 'hearth-fire/inline';
import { connectFire } from 'hearth-fire/embed-client';
import { PARAMETERS, PRESETS, type ParameterId } from 'hearth-fire/parameters';
import { mountPanel } from 'hearth-fire/panel';
import { createSimulation } from 'hearth-fire/sim';
import { elementCode, fromQuery, toQuery } from 'hearth-fire/share';

HearthFire.wasmUrl = new URL('https://fire.example/hearth-engine_bg.wasm');
HearthFire.engine = 'main';
// @ts-expect-error: there is no such place.
HearthFire.engine = 'nowhere';

const fire = document.createElement('hearth-fire');
fire.sourceWidth = 0.3;
fire.loading = 'lazy';
// @ts-expect-error: no parameter is called so.
fire.sourceWitdh = 0.3;
// @ts-expect-error: a width is a number.
fire.sourceWidth = true;

fire.addEventListener('stats', ({ detail }) => {
  const stats: HearthStats = detail;
  const place: 'worker' | 'main' = stats.engine;
  console.log(stats.fps, place);
});
fire.addEventListener('error', ({ detail }) => {
  // Only a refused value has a name.
  if (detail.kind === 'bad-parameter') console.log(detail.id, detail.message);
  // @ts-expect-error: other errors have none.
  else console.log(detail.id);
});
document.querySelector('hearth-fire')?.addEventListener('click', (event) => event.clientX);

const solid = document.createElement('hearth-solid');
const object: number | null | undefined = document.querySelector('hearth-source')?.objectId;
console.log(object);
// @ts-expect-error: the fire gives the id.
solid.objectId = 1;

export async function settings(): Promise<HearthConfig> {
  await fire.set({ viscosity: 0.02, model: 'classic' });
  await fire.set('viscosity', 0.02);
  // @ts-expect-error: a viscosity is a number.
  await fire.set('viscosity', 'thick');
  const config = await fire.exportConfig();
  await fire.importConfig(config);
  await fire.importConfig(JSON.stringify(config));
  const picture: Blob = await fire.toBlob('image/webp', 0.9);
  const stream: MediaStream = await fire.captureStream(30);
  console.log(picture.size, stream.id);
  await fire.destroy();
  return config;
}

const id: ParameterId = 'viscosity';
console.log(PARAMETERS.find((parameter) => parameter.id === id)?.max, PRESETS[0]?.name);
export const other: typeof HearthFire | typeof Inlined = Inlined;
export const panel: Promise<{ destroy(): void }> = mountPanel({ host: document.body, fire });
export const link: string = toQuery(fromQuery('?scene=seed').config);
export const code: string = elementCode({ values: {} }, 'https://fire.example/hearth-fire.js');

export async function particles(): Promise<Float32Array> {
  const simulation = await createSimulation({ model: 'classic', seed: 7, params: { viscosity: 0.02 } });
  simulation.step(10);
  // @ts-expect-error: no parameter is called so.
  simulation.set('sauce', 1);
  const positions = simulation.positions();
  simulation.free();
  return positions;
}

const frame = connectFire(document.createElement('iframe'));
frame.addEventListener('stats', ({ detail }) => console.log(detail.fps));
export const answers: [Promise<void>, Promise<HearthStats | null>, Promise<'classic' | 'combustion'>] = [
  frame.set('viscosity', 0.02),
  frame.stats(),
  frame.get('model'),
];
// @ts-expect-error: a page cannot destroy the fire in an iframe.
frame.destroy();
