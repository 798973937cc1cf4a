/** What the tools draw, and what handles do, in metres and without a browser. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  aligned,
  boundsOf,
  boxBetween,
  circleAround,
  handlesOf,
  lineBetween,
  moved,
  outlineOf,
  polygonOf,
  scaled,
  simplified,
  sized,
  snapped,
  snapTo,
  sourceBetween,
  strokeAlong,
  turned,
} from '../../web/tools/geometry.js';

const near = (a, b) => Math.hypot(a.x - b.x, a.y - b.y) < 2e-3;

test('a box lies between its corners, whichever comes first, and has an area', () => {
  const corners = [
    { x: -0.2, y: 0.5 },
    { x: 0.1, y: 0.1 },
  ];
  const box = boxBetween(...corners);
  assert.deepEqual(box, { kind: 'solid', shape: 'box', x: -0.05, y: 0.3, width: 0.3, height: 0.4 });
  assert.deepEqual(boxBetween(...corners.reverse()), box);
  const point = boxBetween(corners[0], corners[0]);
  assert.ok(point.width > 0 && point.height > 0);
});

test('a circle goes through the second point, a line and a source from one to the other', () => {
  const [a, b] = [
    { x: 0.1, y: 0.2 },
    { x: 0.4, y: 0.6 },
  ];
  assert.equal(circleAround(a, b).width, 1);
  const line = lineBetween(a, b, 0.05);
  assert.deepEqual([line.width, line.height, line.angle], [0.5, 0.05, 53.1]);
  const source = sourceBetween(b, a);
  assert.deepEqual([source.x, source.y, source.width, source.angle], [0.25, 0.4, 0.5, 53.1]);
  assert.ok(outlineOf(source).points.every((end) => near(end, a) || near(end, b)));
});

test('a line that snaps has an angle of a multiple of 15° and the same length', () => {
  const end = snapped({ x: 0, y: 0 }, { x: 1, y: 0.98 });
  assert.ok(Math.abs(Math.atan2(end.y, end.x) - Math.PI / 4) < 1e-9);
  assert.ok(Math.abs(Math.hypot(end.x, end.y) - Math.hypot(1, 0.98)) < 1e-9);
});

test('a stroke follows its path with few points, however many there were', () => {
  const circle = Array.from({ length: 3000 }, (_, at) => ({
    x: 0.5 * Math.cos(at / 300),
    y: 1 + 0.5 * Math.sin(at / 300),
  }));
  const stroke = strokeAlong(circle, 0.04);
  const points = stroke.points.split(' ');
  assert.ok(points.length < 60, `${points.length} points`);
  for (const point of outlineOf(stroke).points) assert.ok(Math.abs(Math.hypot(point.x, point.y - 1) - 0.5) < 2e-3);
  const zigzag = Array.from({ length: 5000 }, (_, at) => ({ x: at / 2000, y: (at % 2) * 0.9 }));
  assert.ok(strokeAlong(zigzag, 0.02).points.split(' ').length <= 256);
  assert.deepEqual(
    strokeAlong(
      [
        { x: 0.1, y: 0.2 },
        { x: 0.1, y: 0.2 },
      ],
      0.04,
    ),
    { kind: 'solid', shape: 'circle', x: 0.1, y: 0.2, width: 0.04 },
  );
});

test('a simplified path is nowhere farther from the path than the error, and keeps its ends', () => {
  const path = Array.from({ length: 200 }, (_, at) => ({ x: at / 20, y: Math.sin(at / 20) }));
  const few = simplified(path, 0.01);
  assert.deepEqual([few[0], few.at(-1)], [path[0], path.at(-1)]);
  for (const point of path) {
    const at = few.findIndex(({ x }) => x >= point.x);
    const [a, b] = [few[Math.max(0, at - 1)], few[at]];
    const share = b.x === a.x ? 0 : (point.x - a.x) / (b.x - a.x);
    assert.ok(Math.abs(a.y + share * (b.y - a.y) - point.y) < 0.02);
  }
});

test('a polygon needs three corners', () => {
  const [a, b, c] = [
    { x: 0, y: 0 },
    { x: 1, y: 0 },
    { x: 0, y: 1 },
  ];
  assert.equal(polygonOf([a, b]), undefined);
  assert.equal(polygonOf([a, a, b, b]), undefined);
  assert.deepEqual(polygonOf([a, b, b, c]), {
    kind: 'solid',
    shape: 'polygon',
    x: 0.5,
    y: 0.5,
    points: '-0.5,-0.5 0.5,-0.5 -0.5,0.5',
  });
});

const OBJECTS = [
  { kind: 'source', x: 0.1, y: 0.2, angle: 30, width: 0.4 },
  { kind: 'solid', shape: 'circle', x: 0.1, y: 0.2, angle: 0, width: 0.4, height: 0.1 },
  { kind: 'solid', shape: 'box', x: -0.3, y: 0.5, angle: -40, width: 0.4, height: 0.2 },
  { kind: 'solid', shape: 'mask', x: -0.3, y: 0.5, angle: 100, width: 0.4, height: 0.2 },
  { kind: 'solid', shape: 'line', x: 0.1, y: 0.5, angle: 70, width: 0.4, height: 0.1 },
  { kind: 'solid', shape: 'polygon', x: 0.1, y: 0.5, angle: 20, points: '-0.2,-0.1 0.2,-0.1 0,0.1' },
  {
    kind: 'solid',
    shape: 'stroke',
    x: 0.1,
    y: 0.5,
    angle: 20,
    height: 0.04,
    points: '-0.2,-0.1 0.2,-0.1 0.2,0.1 -0.2,0.1',
  },
];

for (const object of OBJECTS) {
  const name = object.shape ?? object.kind;

  test(`a handle that is dragged is where the pointer is: ${name}`, () => {
    const handles = handlesOf(object, 0.001);
    for (const [at, handle] of handles.entries()) {
      // Away from the middle, along the diagonal of the box.
      const to = { x: object.x + 1.25 * (handle.at.x - object.x), y: object.y + 1.25 * (handle.at.y - object.y) };
      const change = handle.does === 'turn' ? turned(object, to, false) : sized(object, handle.at, to);
      const after = handlesOf({ ...object, ...change }, 0.001)[at].at;
      if (handle.does === 'size')
        assert.ok(
          Math.hypot(after.x - to.x, after.y - to.y) < 0.02,
          `${JSON.stringify(after)} for ${JSON.stringify(to)}`,
        );
      else assert.ok(near(after, handle.at));
    }
  });

  test(`turning points the handle at the pointer, moving keeps the outline's form: ${name}`, () => {
    const turning = handlesOf(object, 0.001).find(({ does }) => does === 'turn');
    assert.equal(turning !== undefined, object.shape !== 'circle');
    if (turning) {
      assert.deepEqual(turned(object, { x: object.x - 1, y: object.y }, false), { angle: 90 });
      assert.deepEqual(turned(object, { x: object.x + 0.1, y: object.y + 1 }, true), { angle: 0 });
    }
    const after = { ...object, ...moved(object, { x: 0, y: 0 }, { x: 0.3, y: -0.1 }) };
    const [before, now] = [object, after].map((fields) => outlineOf(fields).points);
    for (const [at, point] of now.entries()) assert.ok(near(point, { x: before[at].x + 0.3, y: before[at].y - 0.1 }));
  });

  test(`scaling scales the outline: ${name}`, () => {
    const [before, now] = [object, { ...object, ...scaled(object, 1.5) }].map((fields) => outlineOf(fields).points);
    for (const [at, point] of now.entries()) {
      assert.ok(
        near(point, { x: object.x + 1.5 * (before[at].x - object.x), y: object.y + 1.5 * (before[at].y - object.y) }),
      );
    }
  });
}

test('aligned objects have the edge or the middle of the box around them in common, and keep the other direction', () => {
  const around = boundsOf(OBJECTS);
  for (const [to, axis, line] of [
    ['left', 'x', ({ left }) => left],
    ['centre', 'x', ({ left, right }) => (left + right) / 2],
    ['right', 'x', ({ right }) => right],
    ['bottom', 'y', ({ bottom }) => bottom],
    ['middle', 'y', ({ bottom, top }) => (bottom + top) / 2],
    ['top', 'y', ({ top }) => top],
  ]) {
    const by = aligned(OBJECTS, to);
    for (const [at, object] of OBJECTS.entries()) {
      assert.equal(by[at][axis === 'x' ? 'y' : 'x'], 0);
      const after = boundsOf([{ ...object, x: object.x + by[at].x, y: object.y + by[at].y }]);
      assert.ok(Math.abs(line(after) - line(around)) < 1e-9, `${to} of ${object.shape ?? object.kind}`);
    }
  }
});

test('a box snaps to the nearest edge or middle of others, in each direction by itself, and to none that is far', () => {
  const others = [
    { left: 0, right: 1, bottom: 0, top: 1 },
    { left: 3, right: 4, bottom: 5, top: 7 },
  ];
  const near = snapTo({ left: 1.02, right: 1.32, bottom: 3, top: 3.2 }, others, 0.05);
  assert.ok(Math.abs(near.by.x + 0.02) < 1e-9 && near.by.y === 0);
  // A line along the common edge, over both.
  assert.deepEqual(near.guides, [
    [
      { x: 1, y: 0 },
      { x: 1, y: 3.2 },
    ],
  ]);
  const middle = snapTo({ left: 3.21, right: 3.81, bottom: 5.5, top: 6.51 }, others, 0.05);
  assert.ok(Math.abs(middle.by.x + 0.01) < 1e-9 && Math.abs(middle.by.y + 0.005) < 1e-9);
  assert.deepEqual(snapTo({ left: 1.06, right: 1.3, bottom: 3, top: 3.2 }, others, 0.05), {
    by: { x: 0, y: 0 },
    guides: [],
  });
  assert.deepEqual(snapTo({ left: 1.06, right: 1.3, bottom: 3, top: 3.2 }, [], 0.05), {
    by: { x: 0, y: 0 },
    guides: [],
  });
});
