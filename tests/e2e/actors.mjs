/**
 * All that changes a fire: the page, the panel, the tools, steps, scenes, the history, children, and an engine that
 * stops. A seed decides what they do.
 */

/** A fire with a panel, tools and a strip of scenes, and another fire, which shows what an engine makes of settings. */
export const STAGE = `<style>
    .place { position: absolute; top: 0; width: 300px; height: 400px }
    #host { position: absolute; top: 0; left: 320px; width: 340px; height: 780px }
    #other { position: absolute; top: 500px; width: 60px; height: 80px }
  </style>
  <hearth-fire class="place" paused quality="low" max-pixels="2000"></hearth-fire>
  <div class="place" id="tools"></div><div id="host"></div><div id="strip"></div>
  <hearth-fire id="other" paused quality="low" max-pixels="2000"></hearth-fire>`;

/** Runs in the worker of the engine: a call of `sparks` stops it. */
export function stopAtSparks() {
  addEventListener('message', (event) => {
    if (event.data[2] !== 'sparks') return;
    event.stopImmediatePropagation();
    postMessage({ type: 'stopped', why: 'a test stops it' });
    globalThis.close();
  });
}

/** Runs in the page, whose clock is simulated: mounts panel and tools. `window.actors` has the actions. */
export async function installActors() {
  const scope = /** @type {any} */ (window);
  const load = (/** @type {string} */ name) => import(`/web/${name}.js`);
  const [wasm, { mountPanel }, { mountTools }, { editingOf }, { showStrip }] = await Promise.all(
    ['wasm/hearth-panel', 'panel', 'tools', 'editing/editing', 'pages/scenes'].map(load),
  );
  const find = (/** @type {string} */ selector) => /** @type {any} */ (document.querySelector(selector));
  const all = (/** @type {string} */ selector) => /** @type {any[]} */ ([...document.querySelectorAll(selector)]);
  const [fire, other] = all('hearth-fire');
  await Promise.all([fire.ready, other.ready]);
  /** @type {any} */
  let egui;
  const { start } = wasm.Panel;
  wasm.Panel.start = async (/** @type {any[]} */ ...given) => {
    egui = await start.apply(wasm.Panel, given);
    return egui;
  };
  await mountPanel({ host: find('#host'), fire });
  await mountTools({ host: find('#tools'), fire });
  showStrip(find('#strip'), fire, 'default', (/** @type {string} */ message) => log.push(`  strip: ${message}`));
  const editing = editingOf(fire);
  const canvas = find('#host canvas');
  /** What was done. @type {string[]} */
  const log = [];

  const numbers = (/** @type {number} */ seed) => {
    let state = seed * 7919 + 17;
    return () => {
      state = (state * 16807) % 2147483647;
      return state / 2147483647;
    };
  };
  let next = numbers(1);
  const random = (/** @type {number} */ below) => Math.floor(next() * below);
  /** The actions of a sequence follow from its seed, as do the values of the panel's randomise. @param {number} seed */
  const sow = (seed) => {
    next = numbers(seed);
    Math.random = numbers(seed);
  };
  const pick = (/** @type {any} */ list) => [...list][random(list.length)];
  const between = (/** @type {number} */ from, /** @type {number} */ to) =>
    Number((from + ((to - from) * random(1000)) / 1000).toPrecision(3));
  const frames = async (count = 1) => {
    for (; count > 0; count -= 1) {
      const next = new Promise(requestAnimationFrame);
      scope.clock.next();
      await next;
    }
  };

  const point = (/** @type {any} */ target, /** @type {string} */ what, /** @type {number[]} */ [x, y]) => {
    const at = { clientX: x, clientY: y, button: 0, bubbles: true, pointerId: 7 };
    target.dispatchEvent(what === 'mousemove' ? new MouseEvent(what, at) : new PointerEvent(what, at));
  };
  /** The points along a control of egui, once it no longer moves. @param {string} id */
  const place = async (id) => {
    egui.reveal(id);
    for (let [last, tries] = ['', 0]; tries < 60; tries += 1) {
      await frames();
      const now = JSON.stringify(egui.rectangles()[id] ?? tries);
      if (now === last) break;
      last = now;
    }
    const { x: left, y: top } = canvas.getBoundingClientRect();
    const [x, y, width, height] = egui.rectangles()[id] ?? [0, 0, 0, 0];
    return (/** @type {number} */ share) => [left + x + width * share, top + y + height / 2];
  };
  /** The text that egui shows in the row of a control. @type {(id: string, label: string) => Promise<string>} */
  const shown = async (id, label) => {
    for (let tries = 0; tries < 9; tries += 1) {
      point(canvas, 'mousemove', (await place(id))(0.5));
      await frames(2);
      const [text, name] = egui.hovered() ?? [];
      if (name === label) return text;
    }
    return 'no row';
  };
  /** The ids of the objects that egui lists, two in a line. @returns {Promise<number[]>} */
  const listed = async () => {
    egui.reveal('Objects');
    await frames(3);
    const found = Object.entries(egui.rectangles()).filter(([name]) => name.startsWith('object:'));
    found.sort(([, [x, y]], [, [u, v]]) => y - v || x - u);
    return found.map(([name]) => Number(name.slice(7)));
  };

  /** What the page alone states: no control of a visitor sets it by itself. */
  const OWN = ['bloom', 'exposure'];
  /** The page alone states the resolution, too, which decides how long a fire takes to begin. */
  const OF_PAGE = [...OWN, 'model', 'spacing', 'particles', 'max_particles', 'domain_width', 'domain_height'];
  /** Scenes whose objects the panel lists in one view. */
  const SCENES = ['default', 'campfire', 'candle', 'match', 'seed', 'fireplace', 'smoke-stack'];
  const [ACTION, TOOL] = ['#host [data-action', '#tools [data-tool'];

  /** The accessible controls that are shown. @param {'parameter' | 'property'} of */
  const controls = (of) => all(`#host [data-${of}]`).filter((control) => !control.closest('.row').hidden);
  const input = (/** @type {any} */ control, /** @type {any} */ value) => {
    control[control.type === 'checkbox' ? 'checked' : 'value'] = value;
    for (const type of ['input', 'change']) control.dispatchEvent(new Event(type, { bubbles: true }));
  };
  /** Gives a control a random value. @param {any} control */
  const turn = (control) => {
    const { type, min, max, step, checked, options, dataset, value: text } = control;
    const number = () => (step === '1' ? Math.round : Number)(between(Number(min), Number(max)));
    const colour = () => (text[0] === '#' ? `#${100000 + random(800000)}` : text);
    /** @type {any} */
    const values = { checkbox: () => !checked, range: number, number: () => random(1000), text: colour };
    const value = options ? pick(options).value : values[type]();
    log.push(`panel: ${dataset.parameter ?? `${dataset.property} of ${editing.id}`} = ${value}`);
    input(control, value);
  };
  /** Begins a gesture. */
  const press = () => point(find('#host'), 'pointerdown', [0, 0]);
  const click = (/** @type {string} */ selector) => {
    log.push(`clicks ${selector}`);
    press();
    find(selector)?.click();
  };
  const clicks = (/** @type {string} */ of, /** @type {string[]} */ names) =>
    names.map((name) => () => click(`${of}="${name}"]`));
  const atObject = (/** @type {() => unknown} */ act) => () => {
    const { id = '' } = pick(fire.objects) ?? {};
    log.push(`panel: selects ${id}`);
    input(find(`${ACTION}="select-object"]`), id);
    return act();
  };
  const key = (/** @type {string} */ name) => {
    click(`${TOOL}="select"]`);
    log.push(`tools: key ${name}`);
    find('.hearth-toolbar').dispatchEvent(new KeyboardEvent('keydown', { key: name, bubbles: true }));
  };
  /** A drag of a slider of egui. @type {(id: string, from: number, to: number) => Promise<void>} */
  const slide = async (id, from, to) => {
    const at = await place(id);
    log.push(`egui: ${id} from ${from} to ${to}`);
    const moves = { mousemove: from, pointerdown: from, pointermove: to, pointerup: to };
    for (const [what, share] of Object.entries(moves)) {
      point(canvas, what === 'pointermove' ? 'mousemove' : what, at(share));
      await frames();
    }
  };
  const draw = (/** @type {string} */ tool, x = 60 + random(180), y = 60 + random(280)) => {
    click(`${TOOL}="${tool}"]`);
    const [u, v] = [x + 20 + random(60), y + 20 + random(60)];
    log.push(`tools: ${tool} from ${x}, ${y} to ${u}, ${v}`);
    const overlay = find('.hearth-overlay');
    point(overlay, 'pointerdown', [x, y]);
    for (const at of [
      [(x + u) / 2, v],
      [u, v],
    ])
      point(overlay, 'pointermove', at);
    point(overlay, 'pointerup', [u, v]);
  };
  /** Calls a method of the fire, of its history or of a child. @type {(of: any, ...call: any[]) => any} */
  const call = (of, method, ...given) => {
    const words = given.map((value) => (value instanceof Element ? value.outerHTML : JSON.stringify(value)));
    const name = of === fire ? 'fire' : of === fire.history ? 'history' : of.outerHTML;
    log.push(`page: ${name}.${method}(${words.join()})`);
    return of[method](...given);
  };
  const newChild = (name = pick(['hearth-source', 'hearth-solid'])) => {
    const made = document.createElement(name);
    made.setAttribute('x', String(between(-0.4, 0.4)));
    if (name === 'hearth-solid') made.setAttribute('y', String(between(0.4, 0.9)));
    return made;
  };
  const child = () => pick(fire.children) ?? fire.appendChild(newChild());
  /**
   * The engine stops, and another one goes on. Three stops within a minute would end the fire. On the page's thread none
   * can stop.
   */
  const restart = async () => {
    if (scope.driver.workers() === 0) return reinsert();
    log.push('the engine stops');
    scope.clock.cost = 61_000;
    performance.now();
    scope.clock.cost = 0;
    let isRestored = false;
    fire.addEventListener('restored', () => (isRestored = true), { once: true });
    fire.sparks(0, 1).catch(() => {});
    while (!isRestored) await frames();
  };

  /** A framework moves the fire in several tasks. */
  const reinsert = async () => {
    log.push('the page removes the fire and inserts it again');
    const next = fire.nextSibling;
    fire.remove();
    await frames();
    next.before(fire);
    await fire.ready;
  };

  /** The ids of the objects that the page has added. @type {number[]} */
  const added = [];
  const add = () => call(fire, 'addObject', { kind: pick(['solid', 'source']), x: between(-0.4, 0.4) });
  const calls = [
    ...[
      () => ({ fuel_power: 50 + random(500) }),
      () => ({ turbulence: random(9), source_x: between(-0.4, 0.4) }),
      () => ({ spacing: between(0.03, 0.05) }),
      () => ({ particles: 300 + random(1500) }),
      () => ({ fuel_power: null, spacing: null }),
      () => ({ model: pick(['classic', 'combustion']) }),
      () => ({ [pick(OWN)]: random(7) / 10 }),
      () => ({ [pick(OWN)]: random(7) / 10 }),
      () => ({ objects: [...fire.objects].reverse() }),
    ].map((values) => () => call(fire, 'set', values())),
    () => call(fire, 'changeObject', pick(fire.objects)?.id ?? 1, { y: between(0, 0.9) }),
    () => call(fire, 'removeObject', pick(fire.objects)?.id ?? 1),
  ];
  /** A scene is a step by itself, and in a step a part of that. */
  const scenes = [
    () => click(`#strip [data-starts="${pick(SCENES)}"]`),
    () => call(fire, 'setAttribute', 'preset', pick(SCENES)),
    () => call(fire, 'importConfig', { preset: 'candle', values: { wind: 0.2 } }),
    () => call(fire, 'restore'),
  ];
  /** The actions of each actor. @type {{[actor: string]: (() => unknown)[]}} */
  const actions = {
    page: [
      ...calls,
      async () => added.push(await add()),
      () => call(fire, 'setAttribute', 'wind', String(between(-1, 1))),
      () => call(fire, 'removeAttribute', 'wind'),
    ],
    children: [
      () => call(fire, 'append', newChild()),
      () => call(child(), 'setAttribute', 'x', String(between(-0.4, 0.4))),
      () => call(child(), 'setAttribute', pick(['y', 'width']), String(between(0.1, 0.5))),
      () => call(child(), 'removeAttribute', pick(['x', 'y', 'width'])),
      () => call(child(), 'remove'),
      () => call(fire, 'append', child()),
    ],
    // Some are not answered when the next one begins.
    steps: [1, 2, 3].map((count) => () => {
      const acts = Array.from({ length: count }, () => pick([...calls, ...scenes, add]));
      return Promise.all(acts.map((act) => fire.history.step(act)));
    }),
    panel: [
      ...Array(4).fill(() => turn(pick(controls('parameter').filter((of) => !OF_PAGE.includes(of.dataset.parameter))))),
      ...Array(2).fill(atObject(() => controls('property').length > 0 && turn(pick(controls('property'))))),
      () => slide(pick(['wind', 'source_width', 'source_x']), random(10) / 10, random(10) / 10),
      () => {
        const names = all(`${ACTION}^="restore:"]`).flatMap(({ hidden, dataset }) => (hidden ? [] : dataset.action));
        click(`${ACTION}="${pick(names.filter((name) => !OF_PAGE.includes(name.slice(8))))}"]`);
      },
      () => {
        click(`${ACTION}="scenes"]`);
        click(`[data-scene="${pick(SCENES)}"]`);
        click('[data-card="close"]');
      },
      ...Array(3).fill(() => click(`${ACTION}="compare:${editing.letter === 'A' ? 'B' : 'A'}"]`)),
      ...clicks(ACTION, ['add:solid', 'add:source', 'randomise:bold', 'reset-all', 'reset-all', 'reset-all']),
      ...clicks(ACTION, ['duplicate', 'delete', 'to:front', 'to:back']).map(atObject),
    ],
    tools: [
      ...['box', 'circle', 'line', 'brush', 'source', 'select', 'erase'].map((tool) => () => draw(tool)),
      ...clicks(TOOL, ['duplicate', 'remove', 'back', 'front']).map(atObject),
      ...['ArrowLeft', 'ArrowUp', '[', '+', 'Delete'].map((name) => atObject(() => key(name))),
    ],
    history: ['undo', 'undo', 'redo'].flatMap((name) => [
      ...clicks(ACTION, [name]),
      ...clicks(TOOL, [name]),
      () => call(fire.history, name),
    ]),
    scenes,
    restart: [restart, restart, reinsert],
  };

  // From here on a frame, and with it a picture of the panel, waits until an actor or a check needs it.
  scope.clock.runs = false;
  // The first child and the first undo load code.
  const first = /** @type {any} */ (fire.appendChild(newChild('hearth-solid')));
  while (!first.objectId) await frames();
  first.remove();
  await fire.history.step(() => fire.set('wind', 0.1));
  await fire.history.undo();
  scope.actors = { actions, added, controls, editing, fire, frames, listed, log, newChild, other, pick, press };
  Object.assign(scope.actors, { OWN, random, restart, shown, sow });
}
