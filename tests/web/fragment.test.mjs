/** The fragment of a page's address, without a browser: what it sets, what the tab keeps, and what is refused. */
import assert from 'node:assert/strict';
import { beforeEach, test } from 'node:test';
import { pageLink } from '../../web/share.js';

const PAGE = 'https://fire.example/index.html';
const CONFIG = {
  hearth: 3,
  preset: 'campfire',
  values: {},
  objects: [{ kind: 'solid', points: '0,0 1,1 '.repeat(400) }],
};

/** A page of a browser, as far as the code sees it: its address, its history and its storage. */
class Tab extends EventTarget {
  location = new URL(PAGE);
  /** @type {Map<string, string>} */
  stored = new Map();
  /** The most characters that the state of the history and the storage take. */
  limits = [Infinity, Infinity];
  /** @type {any} */
  state = null;

  history = {
    tab: this,
    get state() {
      return this.tab.state;
    },
    /** @type {(state: any, title: string, url: URL) => void} */
    replaceState(state, _title, url) {
      if (JSON.stringify(state).length > this.tab.limits[0]) throw new Error('DataCloneError');
      this.tab.state = structuredClone(state);
      this.tab.location.href = url.href;
    },
  };

  sessionStorage = {
    getItem: (/** @type {string} */ key) => this.stored.get(key) ?? null,
    setItem: (/** @type {string} */ key, /** @type {string} */ text) => {
      if (text.length > this.limits[1]) throw new Error('QuotaExceededError');
      this.stored.set(key, text);
    },
    removeItem: (/** @type {string} */ key) => this.stored.delete(key),
  };
}

/** @type {Tab} */
let tab;
beforeEach(() => {
  tab = new Tab();
  const { location, history, sessionStorage } = tab;
  const addEventListener = tab.addEventListener.bind(tab);
  for (const [name, value] of Object.entries({ location, history, sessionStorage, addEventListener })) {
    Object.defineProperty(globalThis, name, { value, configurable: true });
  }
});
const { KEPT, applyFragment, hasFragment, keep, keepLast } = await import('../../web/pages/fragment.js');

/** What a page with that address shows; `act` is called when it does, and has one outcome more. @param {() => void} [act] */
async function open(/** @type {string} */ href, act) {
  tab.location.href = href;
  /** @type {{shown: any[], refused: string[]}} */
  const seen = { shown: [], refused: [] };
  const importConfig = async (/** @type {any} */ config) => seen.shown.push(config);
  applyFragment(/** @type {any} */ ({ importConfig, set: importConfig }), (message) => seen.refused.push(message));
  /** An address with a fire has an outcome; others have none but what microtasks lead to. @param {number} before */
  const settled = async (before) => {
    do await new Promise(setImmediate);
    while (hasFragment() && seen.shown.length + seen.refused.length === before);
  };
  await settled(0);
  if (act) {
    act();
    await settled(1);
  }
  return seen;
}

test('a page with a long address shows its fire, also when the address changes', async () => {
  const [first, second] = await Promise.all(
    [CONFIG, { ...CONFIG, preset: 'candle' }].map((config) => pageLink(config, PAGE)),
  );
  const seen = await open(first, () => {
    tab.location.href = second;
    tab.dispatchEvent(new Event('hashchange'));
  });
  assert.deepEqual(
    seen.shown.map(({ preset }) => preset),
    ['campfire', 'candle'],
  );
  assert.deepEqual(seen.shown[0], CONFIG);
  assert.deepEqual(seen.refused, []);
});

test('addresses of others change nothing', async () => {
  for (const hash of ['', '#about', '#Fire=x', '#fireplace', '#fires=1']) {
    assert.deepEqual(await open(`${PAGE}${hash}`), { shown: [], refused: [] });
    assert.equal(hasFragment(), false);
  }
});

test('a damaged address shows the reason', async () => {
  const { shown, refused } = await open((await pageLink(CONFIG, PAGE)).slice(0, -20));
  assert.deepEqual(shown, []);
  assert.match(refused.join(), /damaged/);
});

for (const [about, limits, lose] of /** @type {[string, number[], () => void][]} */ ([
  ['reload', [Infinity, Infinity], () => {}],
  ['reload where the history takes little', [1000, Infinity], () => {}],
  ['reload where nothing is stored', [Infinity, 0], () => {}],
  ['return by a typed address', [Infinity, Infinity], () => (tab.state = null)],
  ['return when a script has emptied the storage', [Infinity, Infinity], () => tab.stored.clear()],
])) {
  test(`a fire that is too long for its address survives: ${about}`, async () => {
    tab.limits = limits;
    tab.state = { page: 7 };
    keep(new URL(KEPT, PAGE), /** @type {any} */ (CONFIG));
    assert.equal(tab.state.page, 7);
    lose();
    assert.deepEqual(await open(tab.location.href), { shown: [CONFIG], refused: [] });
  });
}

test('another tab says where such a fire is, and a shorter fire is kept no longer', async () => {
  keep(new URL(KEPT, PAGE), /** @type {any} */ (CONFIG));
  keep(new URL('?scene=candle', PAGE));
  const { shown, refused } = await open(`${PAGE}${KEPT}).`);
  assert.deepEqual(shown, []);
  assert.match(refused.join(), /only the tab/);
  tab.stored.set('hearth-fire', '{"hearth":');
  assert.match((await open(`${PAGE}${KEPT}`)).refused.join(), /only the tab/);
});

test('the last changes of a fire survive one reload at the same address', async () => {
  const changes = { wind: 0.5, objects: [{ kind: 'source', id: 1 }] };
  keepLast(changes);
  assert.deepEqual(await open(PAGE), { shown: [changes], refused: [] });
  assert.deepEqual(await open(PAGE), { shown: [], refused: [] });
  keepLast(changes);
  assert.deepEqual(await open(`${PAGE}?scene=forge`), { shown: [], refused: [] });
});

test('a page that the browser has kept goes on, and leaves no changes to a later visit', async () => {
  await open(PAGE);
  keepLast({ wind: 0.5 });
  tab.dispatchEvent(Object.assign(new Event('pageshow'), { persisted: true }));
  assert.deepEqual(await open(PAGE), { shown: [], refused: [] });
});
