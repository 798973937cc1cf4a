/**
 * The sound of fires: it starts only in a gesture, all fires of a page share one
 * context, which is freed with the last, and a visitor's mute is kept.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Browser } from '../driver.mjs';

const STYLE = '<style>hearth-fire { display: block; width: 90px; height: 90px; float: left }</style>';
const FIRE = '<hearth-fire sound="0.5"></hearth-fire>';

/**
 * Counts the contexts of a page and records the states of the sound. Without a sound card no context of Firefox runs;
 * there it tells that it does.
 */
const counted = () => {
  const page = /** @type {any} */ (window);
  page.mixes = [];
  page.states = [];
  // What a driver evaluates counts as a gesture: here only trusted input does.
  const activation = { hasBeenActive: false };
  Object.defineProperty(navigator, 'userActivation', { value: activation });
  for (const name of ['pointerdown', 'keydown'])
    addEventListener(name, ({ isTrusted }) => (activation.hasBeenActive ||= isTrusted), true);
  const Native = page.AudioContext;
  page.AudioContext = class extends Native {
    constructor(...options) {
      super(...options);
      page.mixes.push(this);
    }
  };
  if (navigator.userAgent.includes('Firefox')) {
    const told = new WeakMap();
    const tells = (state) =>
      async function () {
        told.set(this, state);
        this.dispatchEvent(new Event('statechange'));
      };
    Object.defineProperties(page.AudioContext.prototype, {
      state: {
        get() {
          return told.get(this) ?? 'suspended';
        },
      },
      resume: { value: tells('running') },
      close: { value: tells('closed') },
    });
  }
  document.addEventListener('sound-change', ({ detail }) => page.states.push(detail.state), true);
  // The limiter and the gain before it.
  const connect = AudioNode.prototype.connect;
  AudioNode.prototype.connect = function (/** @type {any} */ to, ...others) {
    if (to instanceof WaveShaperNode && to.context instanceof AudioContext)
      page.limiter = { gain: /** @type {any} */ (this).gain.value, curve: to.curve };
    return connect.call(this, to, ...others);
  };
};

/** Opens a page with these fires, burning. */
async function opened(browser, body = FIRE, prepare = counted, remember = false) {
  const tab = await browser.open(`${STYLE}${body}<script type="module" src="/web/hearth-fire.js"></script>`, {
    before: prepare,
    remember,
  });
  await tab.ready();
  return tab;
}

const states = (tab) => tab.evaluate(() => /** @type {any} */ (window).states);
const contexts = (tab) => tab.evaluate(() => /** @type {any} */ (window).mixes.map(({ state }) => state));
const hasState = (tab, state) =>
  tab.until(`the sound is ${state}`, (wanted) => /** @type {any} */ (window).states.at(-1) === wanted, state);

/** Waits until the first fire gives samples, or none but zeros. No samples pass through a context of Firefox. */
const heard = (tab, what, holds) =>
  tab.until(
    what,
    (wanted) => {
      const page = /** @type {any} */ (window);
      const { audio } = /** @type {any} */ (document.querySelector('hearth-fire'));
      if (!audio) return false;
      if (navigator.userAgent.includes('Firefox')) return true;
      if (page.analysed !== audio) {
        page.analysed = audio;
        page.analyser = new AnalyserNode(audio.context, { fftSize: 2048 });
        audio.connect(page.analyser);
      }
      const samples = new Float32Array(2048);
      page.analyser.getFloatTimeDomainData(samples);
      const peak = Math.max(...samples.map(Math.abs));
      return wanted === 'sound' ? peak > 1e-4 && peak < 1 : peak === 0;
    },
    holds,
  );

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.start();
});
after(() => browser?.close());

test('sound starts in a gesture, ends with a pause and goes on', async () => {
  const tab = await opened(browser);
  await hasState(tab, 'waiting');
  await tab.plays(0.3);
  assert.deepEqual(await contexts(tab), []);
  assert.equal(await tab.fire((fire) => fire.audio), null);
  const name = await tab.fire((fire) => fire.shadowRoot.querySelector('[part=speaker]')?.getAttribute('aria-label'));
  assert.equal(name, 'Sound');
  await tab.click({ x: 300, y: 300 });
  await hasState(tab, 'playing');
  assert.deepEqual(await contexts(tab), ['running']);
  assert.equal(await tab.fire((fire) => fire.shadowRoot.querySelector('[part=speaker]')), null);
  await heard(tab, 'the fire is heard', 'sound');
  await tab.fire((fire) => fire.pause());
  await heard(tab, 'a paused fire is silent', 'silence');
  await tab.fire((fire) => fire.play());
  await heard(tab, 'the fire is heard again', 'sound');
  await tab.fire((fire) => fire.pause());
  await heard(tab, 'a paused fire is silent', 'silence');
  // Another preset is another fire, which is heard as well.
  await tab.fire(async (fire) => {
    fire.preset = 'candle';
    await fire.play();
  });
  await heard(tab, 'the fire of another preset is heard', 'sound');
  await tab.fire((fire) => {
    fire.sound = 0;
  });
  await hasState(tab, 'silent');
  await tab.until('the context is closed', () => /** @type {any} */ (window).mixes[0].state === 'closed');
  assert.deepEqual(await states(tab), ['waiting', 'playing', 'silent']);
  assert.deepEqual(await tab.problemsAfterFrame(), []);
});

test('ten fires share one context, which is freed with the last', async () => {
  const tab = await opened(browser, FIRE.repeat(10));
  await tab.click({ x: 300, y: 300 });
  await tab.until(
    'all ten play',
    () => /** @type {any} */ (window).states.filter((state) => state === 'playing').length === 10,
  );
  assert.deepEqual(await contexts(tab), ['running']);
  await tab.evaluate(() => {
    const [, ...others] = document.querySelectorAll('hearth-fire');
    for (const fire of others) fire.remove();
  });
  await heard(tab, 'the first fire is heard', 'sound');
  assert.deepEqual(await contexts(tab), ['running']);
  await tab.evaluate(() => document.querySelector('hearth-fire').remove());
  await tab.until('the context is closed', () => /** @type {any} */ (window).mixes[0].state === 'closed');
  // The page had its gesture.
  await tab.evaluate((html) => document.body.insertAdjacentHTML('beforeend', html), FIRE);
  await tab.ready();
  await tab.click({ x: 300, y: 300 });
  await tab.until('another context runs', () => /** @type {any} */ (window).mixes.at(-1).state === 'running');
  assert.deepEqual(await contexts(tab), ['closed', 'running']);
  await heard(tab, 'the new fire is heard', 'sound');
  assert.deepEqual(await tab.problemsAfterFrame(), []);
});

test('a mute is kept for the next visit, and a fire without sound loads none of its code', async () => {
  const tab = await opened(browser);
  await hasState(tab, 'waiting');
  await tab.fire((fire) => {
    fire.muted = true;
  });
  await hasState(tab, 'silent');
  const later = await opened(browser, FIRE, counted, true);
  await later.click({ x: 300, y: 300 });
  await later.plays(0.3);
  assert.equal(await later.fire((fire) => fire.muted), true);
  assert.deepEqual(await contexts(later), []);
  await later.fire((fire) => {
    fire.muted = false;
  });
  await later.click({ x: 300, y: 300 });
  await hasState(later, 'playing');
  const silent = await opened(browser, '<hearth-fire></hearth-fire>');
  await silent.click({ x: 300, y: 300 });
  await silent.plays(0.3);
  const loaded = await silent.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name));
  assert.deepEqual(
    loaded.filter((name) => name.includes('/sound/')),
    [],
  );
});

test('without Web Audio fires burn silently, with one warning', async () => {
  const tab = await opened(browser, FIRE.repeat(2), () => {
    delete (/** @type {any} */ (window).AudioContext);
  });
  await tab.click({ x: 300, y: 300 });
  await tab.plays(0.3);
  const problems = await tab.problemsAfterFrame();
  assert.equal(problems.length, 1);
  assert.match(problems[0], /no Web Audio/);
});

test('a fire whose synthesis does not arrive burns silently, with an error that says why', async () => {
  const tab = await browser.open(
    `${STYLE}${FIRE}<script type="module" src="/web/hearth-fire.js"></script>
    <script>addEventListener('error', ({ detail }) => { window.said = detail?.message; }, true);</script>`,
    { before: counted, files: { 'hearth-engine_sound.wasm': { status: 404, body: '' } } },
  );
  await tab.ready();
  await tab.click({ x: 300, y: 300 });
  await tab.until('the error is there', () => /** @type {any} */ (window).said);
  const said = await tab.evaluate(() => /** @type {any} */ (window).said);
  assert.match(said, /^The code for sound could not be loaded: .*hearth-engine_sound\.wasm gave 404$/);
  await tab.plays(0.3);
});

test('the limiter of the page keeps a crack at full volume whole, and two at the same time below full scale', async () => {
  const tab = await opened(browser);
  await tab.click({ x: 300, y: 300 });
  await hasState(tab, 'playing');
  const [alone, both] = await tab.evaluate(async () => {
    const { gain: before, curve } = /** @type {any} */ (window).limiter;
    const peakOf = async (gain) => {
      const context = new OfflineAudioContext(1, 48_000, 48_000);
      const buffer = new AudioBuffer({ length: 48_000, sampleRate: 48_000 });
      // A crack: it begins at once and decays in a millisecond.
      const samples = buffer.getChannelData(0);
      for (let at = 0; at < 480; at += 1) samples[36_000 + at] = gain * Math.exp(-at / 48) * Math.cos(at / 2);
      const source = new AudioBufferSourceNode(context, { buffer });
      const limiter = new WaveShaperNode(context, { curve });
      source
        .connect(new GainNode(context, { gain: before }))
        .connect(limiter)
        .connect(context.destination);
      source.start();
      const made = (await context.startRendering()).getChannelData(0);
      return Math.max(...made.map(Math.abs));
    };
    return [await peakOf(0.7), await peakOf(2)];
  });
  assert.ok(Math.abs(alone / 0.7 - 1) < 0.01 && both < 1, `${alone}, ${both}`);
});

test('the speaker button and the key M start and mute the sound; the slider sets the volume', async () => {
  const tab = await opened(
    browser,
    '<style>hearth-fire { width: 700px; height: 400px }</style><hearth-fire controls></hearth-fire>',
  );
  const button = '.hearth-speaker';
  await tab.until(
    'the button is there',
    (selector) => {
      const { shadowRoot } = document.querySelector('hearth-fire');
      return shadowRoot.querySelector(selector)?.getAttribute('aria-pressed') === 'false';
    },
    button,
  );
  const at = await tab.fire((fire, selector) => {
    const { left, top, width, height } = fire.shadowRoot.querySelector(selector).getBoundingClientRect();
    return { x: left + width / 2, y: top + height / 2 };
  }, button);
  const pressed = () =>
    tab.fire((fire, selector) => fire.shadowRoot.querySelector(selector).getAttribute('aria-pressed'), button);
  await tab.click(at);
  await hasState(tab, 'playing');
  assert.equal(await pressed(), 'true');
  await tab.fire((fire) => {
    const slider = fire.shadowRoot.querySelector('[data-sound=sound]');
    slider.value = '0.25';
    slider.dispatchEvent(new Event('input'));
  });
  assert.equal(await tab.fire((fire) => fire.sound), 0.25);
  await tab.page.keyboard.press('m');
  await hasState(tab, 'silent');
  assert.equal(await pressed(), 'false');
  await tab.page.keyboard.press('m');
  await hasState(tab, 'playing');
  assert.equal(await tab.fire((fire) => fire.sound), 0.25);
});

test('a stream of the fire carries its sound while it is on, by a track of its own from one node', async () => {
  const tab = await opened(browser);
  const tracks = () => tab.fire((fire) => fire.captureStream().then((stream) => stream.getAudioTracks().length));
  assert.equal(await tracks(), 0);
  await tab.click({ x: 300, y: 300 });
  await hasState(tab, 'playing');
  assert.equal(await tracks(), 1);
  const found = await tab.fire(async (fire) => {
    let nodes = 0;
    globalThis.MediaStreamAudioDestinationNode = new Proxy(globalThis.MediaStreamAudioDestinationNode, {
      construct(Node, given) {
        nodes += 1;
        return Reflect.construct(Node, given);
      },
    });
    const streams = [await fire.captureStream(), await fire.captureStream()];
    const [first, second] = streams.map((stream) => stream.getAudioTracks()[0]);
    first.stop();
    return { nodes, states: [first.readyState, second.readyState] };
  });
  assert.deepEqual(found, { nodes: 0, states: ['ended', 'live'] });
});
