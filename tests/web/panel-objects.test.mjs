/** The objects in the panel, without a browser: the scene's values, names and places of new objects. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  boxOf,
  copyOf,
  entriesOf,
  idDomain,
  isFull,
  nameOf,
  newObject,
  sliderDomain,
} from '../../web/editing/objects.js';
import { hasSceneObjects, sceneObjects, sceneOf, sceneProperty } from '../../web/editing/scene.js';
import { PARAMETERS, PRESETS } from '../../web/parameters.js';

/** A fire of a preset, as the element shows it. */
function fireOf({ name, values }) {
  const model = values.model ?? 'combustion';
  const params = Object.fromEntries(PARAMETERS.map(({ id, domains }) => [id, values[id] ?? domains[model]?.default]));
  const fire = { preset: name, params: { ...params, model } };
  const objects = sceneObjects(fire).map((object) => {
    const used = entriesOf(object.kind).filter((entry) => entry.domain(model));
    return {
      ...object,
      ...Object.fromEntries(used.map((entry) => [entry.name, sceneProperty(fire, object, entry.name)])),
    };
  });
  return { ...fire, objects };
}

const radius = ({ shape, width, height }) => (shape === 'circle' || !shape ? width : Math.hypot(width, height)) / 2;

/** Points of an object, from its middle to its edge. */
function pointsOf({ kind, shape, x, y, angle = 0, ...rest }) {
  const { width, height } = kind === 'source' ? rest : boxOf({ shape, ...rest });
  const steps = Array.from({ length: 21 }, (_, at) => at / 10 - 1);
  const [sine, cosine] = [Math.sin, Math.cos].map((of) => of((angle * Math.PI) / 180));
  return steps.flatMap((across) =>
    steps.flatMap((along) => {
      const outside = kind === 'solid' && shape === 'circle' && Math.hypot(across, along) > 1;
      const [u, v] = [
        (along * width) / 2,
        (across * (kind === 'source' ? 0 : shape === 'circle' ? width : height)) / 2,
      ];
      return outside ? [] : [[x + cosine * u - sine * v, y + sine * u + cosine * v]];
    }),
  );
}

test('every scene is unchanged until a value of an object is another', () => {
  for (const preset of PRESETS) {
    const fire = fireOf(preset);
    assert.equal(sceneOf(fire), preset.label);
    for (const [at, object] of fire.objects.entries()) {
      if (at === 0) continue;
      const objects = fire.objects.with(at, { ...object, x: object.x + 0.01 });
      assert.equal(hasSceneObjects({ ...fire, objects }), false, preset.name);
      // As the fire stores it.
      assert.ok(hasSceneObjects({ ...fire, objects: fire.objects.with(at, { ...object, x: Math.fround(object.x) }) }));
      assert.equal(hasSceneObjects({ ...fire, objects: fire.objects.toSpliced(at, 1) }), false);
    }
  }
});

test('new objects of every scene stand in the frame, clear of the others', () => {
  for (const preset of PRESETS) {
    const fire = fireOf(preset);
    const { domain_width: width, domain_height: height } = fire.params;
    for (const kind of ['solid', 'solid', 'source', 'solid']) {
      const object = {
        id: fire.objects.length + 1,
        shape: kind === 'solid' ? 'circle' : undefined,
        ...newObject(fire, kind),
      };
      const what = `${preset.name}: ${JSON.stringify(object)}`;
      for (const entry of entriesOf(kind)) {
        const { min = -Infinity, max = Infinity } = entry.domain(fire.params.model) ?? {};
        const value = object[entry.name];
        assert.ok(typeof value !== 'number' || (value >= min && value <= max), `${what}: ${entry.name}`);
      }
      // Three digits.
      const slack = 0.002 * width;
      assert.ok(Math.abs(object.x) + radius(object) <= width / 2 + slack, what);
      assert.ok(object.y <= height, what);
      for (const other of fire.objects) {
        const apart = Math.min(...pointsOf(other).map(([x, y]) => Math.hypot(object.x - x, object.y - y)));
        assert.ok(apart >= radius(object) - slack, `${what} stands on ${JSON.stringify(other)}`);
      }
      fire.objects.push(object);
    }
  }
});

test('a new object stands in sight', () => {
  const fire = { ...fireOf(PRESETS[0]), clientWidth: 100, clientHeight: 100 };
  // The left half of the lower metre.
  const toMetres = (x, y) => ({ x: ((x - 100) / 100) * 0.6, y: 1 - y / 100 });
  const { x, y, width } = newObject({ ...fire, toMetres }, 'solid');
  assert.ok(x + width / 2 <= 0 && x - width / 2 >= -0.6 && y + width / 2 <= 1, `${x}, ${y}`);
  assert.ok(newObject({ ...fire, toMetres: () => null }, 'solid').x > 0);
});

test('a copy has the values of the object in another place', () => {
  const fire = fireOf(PRESETS.find(({ name }) => name === 'campfire'));
  const { id, ...log } = fire.objects[1];
  const { x, y, ...copy } = copyOf(fire, fire.objects[1]);
  assert.deepEqual({ ...copy, x: log.x, y: log.y }, log);
  assert.ok(Math.hypot(x - log.x, y - log.y) > radius(log));
});

test('a slider of a coordinate spans the frame, and a name lists what is visible', () => {
  const fire = fireOf(PRESETS[0]);
  const x = entriesOf('solid').find(({ name }) => name === 'x');
  const domain = (value) => {
    const { min, max } = sliderDomain(fire, x, value);
    return [min, max];
  };
  assert.deepEqual(domain(0.2), [-1.8, 1.8]);
  assert.deepEqual(domain(-5), [-5, 1.8]);
  assert.equal(nameOf({ id: 1, kind: 'source' }), 'Source 1');
  assert.equal(nameOf({ id: 2, kind: 'solid', shape: 'line', material: 'wood' }), 'Solid 2 · wood line');
  assert.equal(nameOf({ id: 3, kind: 'solid', shape: 'box', material: 'none' }), 'Solid 3 · invisible box');
  for (const name of ['עץ', 'خشب', 'ދަރު', 'ܩܝܣܐ', '薪', 'Bûche'])
    assert.equal(nameOf({ id: 4, kind: 'solid', name }), `\u2068${name}\u2069 · Solid 4`);
  assert.equal(nameOf({ id: 4, kind: 'solid', name: 'Log' }), 'Log · Solid 4');
  assert.equal(isFull({ objects: Array(64).fill({ kind: 'solid' }) }, 'solid'), true);
  assert.equal(isFull({ objects: Array(64).fill({ kind: 'solid' }) }, 'source'), false);
});

test('a source on a solid has the name of a source, ids of solids to choose from, and a line beside it', () => {
  const fire = fireOf(PRESETS[0]);
  const source = { ...fire.objects[0], shape: 'solid', solid: 12 };
  const burning = {
    ...fire,
    objects: [source, { id: 12, kind: 'solid', shape: 'box', x: 0, y: 0.3, width: 0.2, height: 0.1, angle: 0 }],
  };
  assert.equal(nameOf(source), 'Source 1');
  const domain = { default: 0, min: 0, max: 1e6 };
  assert.equal(idDomain(burning, 'source_solid', 0, domain).max, 12);
  assert.equal(idDomain(burning, 'source_solid', 300, domain).max, 300);
  assert.equal(idDomain({ objects: [] }, 'source_solid', 0, domain).max, 1);
  assert.equal(idDomain(burning, 'hangs_from', 0, domain).max, 12);
  assert.equal(idDomain(burning, 'source_x', 0, domain), domain);
  const { shape, solid } = newObject(burning, 'source');
  assert.deepEqual([shape, solid], [undefined, undefined]);
});
