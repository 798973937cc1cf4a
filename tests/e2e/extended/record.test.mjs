/**
 * Films of a fire: what `record` gives is decoded by the browser, the fire goes on where it was, and what fails leaves
 * nothing. `tests/web/record-*.test.mjs` have the formats and the options.
 */
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { BROWSER, Browser, TABS, except } from '../driver.mjs';

/** @type {Browser} */
let browser;
before(async () => {
  browser = await Browser.start();
});
after(() => browser?.close());

const SIZE = 'style="width: 96px; height: 120px"';
const FIRE = `<hearth-fire ${SIZE} quality="low" autoplay="false"></hearth-fire>`;

/** A page with a fire that has burnt for a second and is paused. */
async function paused(fires = FIRE) {
  const tab = await browser.show(fires);
  await tab.ready();
  await tab.fire((fire) => fire.advance(1));
  return tab;
}

test('two films have the same bytes, and no time of the clock is in them', async () => {
  const tab = await paused();
  const [first, second] = await tab.fire(async (fire) => {
    const film = { format: /** @type {const} */ ('zip'), width: 64, height: 80, fps: 50, seconds: 0.1 };
    const files = [await fire.record(film), await fire.record(film)];
    return Promise.all(files.map(async (file) => [...new Uint8Array(await /** @type {Blob} */ (file).arrayBuffer())]));
  });
  assert.deepEqual(second, first);
  const [, ...pictures] = Buffer.from(first).toString('latin1').split('PK\x03\x04');
  // What follows an entry's name is its picture.
  assert.equal(new Set(pictures.map((entry) => entry.slice(35))).size, 5, 'the fire moves');
  assert.deepEqual(tab.problems, []);
});

test('a film that is described has scene and seed as a settings file, and a sheet has a tile for each picture', async () => {
  const tab = await paused('<hearth-fire preset="candle" seed="7" style="width: 64px; height: 64px"></hearth-fire>');
  const texts = await tab.fire(async (fire) => {
    const film = { seconds: 0.1, width: 32, height: 40 };
    const texts = [];
    for (const format of /** @type {const} */ (['apng', 'sheet'])) {
      const file = /** @type {Blob} */ (await fire.record({ ...film, format, describe: true }));
      texts.push(await file.text());
    }
    return texts;
  });
  for (const text of texts) assert.match(text, /\{"hearth":3,[^}]*"seed":7/);
  assert.match(texts[0], /"preset":"candle"/);
  assert.match(texts[1], /"hearth-0002": \{/);
});

test('the fire goes on where it was, as one does that was never recorded', async () => {
  const tab = await paused(FIRE + FIRE);
  const [recorded, other] = await tab.evaluate(async () => {
    const fires = /** @type {any[]} */ ([...document.querySelectorAll('hearth-fire')]);
    await fires[1].advance(1);
    await fires[0].record({ format: 'png', width: 64, height: 64, from: 0.2 });
    const stopped = new AbortController();
    const cancelled = fires[0].record({
      seconds: 5,
      width: 64,
      height: 64,
      signal: stopped.signal,
      onprogress: () => stopped.abort(),
    });
    await cancelled.catch(() => {});
    return Promise.all(
      fires.map(async (fire) => {
        await fire.advance(0.5);
        const picture = new Uint8Array(await (await fire.toBlob()).arrayBuffer());
        return { time: fire.stats.time, measured: await fire.measure(0, 0.3), picture: [...picture] };
      }),
    );
  });
  assert.deepEqual(recorded, other);
  assert.ok(recorded.time >= 1.5 && recorded.picture.length > 500);
});

const WEBP = except({ webkit: 'WebKitGTK encodes no WebP, and has no `ImageDecoder`' });

test('each format of pictures has the size, the count and the rate that were asked for, and alpha', WEBP, async () => {
  const tab = await paused();
  for (const [format, fps, seconds] of /** @type {const} */ ([
    ['webp', 30, 0.5],
    ['apng', 24, 0.5],
    ['gif', 20, 0.5],
    ['png', 30, 0.5],
  ])) {
    const decoded = await tab.fire(
      async (fire, format, fps, seconds) => {
        const file = /** @type {Blob} */ (await fire.record({ format, fps, seconds, width: 70, height: 50 }));
        const type = file.type === 'image/apng' ? 'image/png' : file.type;
        const decoder = new ImageDecoder({ data: await file.arrayBuffer(), type });
        await decoder.tracks.ready;
        const count = decoder.tracks.selectedTrack?.frameCount ?? 0;
        let length = 0;
        const canvas = new OffscreenCanvas(70, 50);
        const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext('2d'));
        for (let frameIndex = 0; frameIndex < count; frameIndex += 1) {
          const { image } = await decoder.decode({ frameIndex });
          length += image.duration ?? 0;
          context.clearRect(0, 0, 70, 50);
          context.drawImage(image, 0, 0);
          if (image.codedWidth !== 70 || image.codedHeight !== 50) throw new Error(`${image.codedWidth}`);
          image.close();
        }
        const { data } = context.getImageData(0, 0, 70, 50);
        const alphas = [...data.filter((_, at) => at % 4 === 3)];
        return {
          type: file.type,
          count,
          length,
          clear: alphas.includes(0),
          solid: alphas.some((alpha) => alpha > 200),
        };
      },
      format,
      fps,
      seconds,
    );
    const still = format === 'png';
    const expected = {
      type: `image/${format}`,
      count: still ? 1 : fps * seconds,
      length: still ? 0 : seconds * 1e6,
      clear: true,
      solid: true,
    };
    assert.deepEqual(decoded, expected, format);
  }
});

const WEBM = except({ webkit: 'the process of a page ends when it encodes a WebM' });

/** How exact the alpha of a WebM is; Firefox encodes it more coarsely. */
const ALPHA = BROWSER === 'firefox' ? 16 : 3;

test(
  `films for players have the size and the length that were asked for, WebM alpha within ${ALPHA} of 255`,
  WEBM,
  async () => {
    const tab = await paused();
    const films = await tab.fire(async (fire) => {
      const common = { seconds: 1, fps: 24, width: 96, height: 128 };
      const context = () =>
        /** @type {OffscreenCanvasRenderingContext2D} */ (
          new OffscreenCanvas(96, 128).getContext('2d', { willReadFrequently: true })
        );
      const shown = async (/** @type {any} */ options) => {
        const file = /** @type {Blob} */ (await fire.record({ ...common, ...options }));
        const video = document.createElement('video');
        video.muted = true;
        video.src = URL.createObjectURL(file);
        await new Promise((resolve, reject) =>
          Object.assign(video, { oncanplaythrough: resolve, onerror: () => reject(video.error) }),
        );
        const seek = new Promise((resolve) => (video.onseeked = resolve));
        video.currentTime = 0.49;
        await seek;
        const canvas = context();
        canvas.drawImage(video, 0, 0);
        return { video, data: canvas.getImageData(0, 0, 96, 128).data };
      };
      const about = (/** @type {HTMLVideoElement} */ { videoWidth, videoHeight, duration }) => [
        videoWidth,
        videoHeight,
        Math.round(duration * 100),
      ];
      const webm = await shown({ format: 'webm' });
      const zip = /** @type {Blob} */ (await fire.record({ ...common, format: 'zip' }));
      // The picture of that moment in the archive.
      const bytes = new Uint8Array(await zip.arrayBuffer());
      const text = new TextDecoder('latin1').decode(bytes);
      const [start, end] = ['00011.png', '00012.png'].map((name) => text.indexOf(name));
      const exact = await createImageBitmap(new Blob([bytes.slice(start + 9, end - 30)]));
      const canvas = context();
      canvas.drawImage(exact, 0, 0);
      const { data } = canvas.getImageData(0, 0, 96, 128);
      const off = data.reduce(
        (most, value, at) => (at % 4 === 3 ? Math.max(most, Math.abs(value - webm.data[at])) : most),
        0,
      );
      const mp4 = await shown({ format: 'mp4', background: '#204060' }).catch((error) => error.message);
      return {
        webm: about(webm.video),
        off,
        mp4: mp4.video ? about(mp4.video) : mp4,
        sky: mp4.data && [...mp4.data.slice(0, 4)],
      };
    });
    assert.deepEqual(films.webm, [96, 128, 100]);
    assert.ok(films.off <= ALPHA, `alpha is off by ${films.off}`);
    // Some builds of Chromium encode no H.264.
    if (typeof films.mp4 === 'string') assert.match(films.mp4, /cannot encode H\.264/);
    else {
      assert.deepEqual(films.mp4, [96, 128, 100]);
      const far = [0x20, 0x40, 0x60, 255].map((value, at) => Math.abs(value - films.sky[at]));
      assert.ok(Math.max(...far) < 8, `${films.sky}`);
    }
  },
);

test('a film with sound and a WAV have the same length of sound, which is the same twice', WEBM, async () => {
  const tab = await paused();
  const { wavs, webm } = await tab.fire(async (fire) => {
    const wavs = [];
    for (let run = 0; run < 2; run += 1) {
      const file = /** @type {Blob} */ (await fire.record({ format: 'wav', seconds: 0.5 }));
      wavs.push([...new Uint8Array(await file.arrayBuffer())]);
    }
    const film = /** @type {Blob} */ (
      await fire.record({ format: 'webm', seconds: 0.5, sound: true, width: 32, height: 32 })
    );
    const sound = await new OfflineAudioContext(2, 100, 48_000).decodeAudioData(await film.arrayBuffer());
    return { wavs, webm: [sound.numberOfChannels, sound.length] };
  });
  assert.equal(wavs[0].length, 44 + 24_000 * 4);
  assert.deepEqual(wavs[1], wavs[0]);
  assert.ok(new Set(wavs[0].slice(44)).size > 20, 'it is not silent');
  assert.equal(webm[0], 2);
  assert.ok(Math.abs(webm[1] - 24_000) < 2000, `${webm[1]} samples`);
});

test(
  'a loop has the length that was asked for, its end is near to its beginning, and its sparks do not fade there',
  WEBP,
  async () => {
    const tab = await paused(FIRE.replace('quality', 'fuel-power="20" ember-rate="400" ember-size="0.02" quality'));
    const { count, seam, neighbours, unrelated, contrasts } = await tab.fire(async (fire) => {
      const file = /** @type {Blob} */ (
        await fire.record({ format: 'apng', loop: true, seconds: 1, fps: 24, width: 48, height: 60 })
      );
      const decoder = new ImageDecoder({ data: await file.arrayBuffer(), type: 'image/png' });
      await decoder.tracks.ready;
      const count = decoder.tracks.selectedTrack?.frameCount ?? 0;
      const context = /** @type {OffscreenCanvasRenderingContext2D} */ (
        new OffscreenCanvas(48, 60).getContext('2d', { willReadFrequently: true })
      );
      /** @type {Uint8ClampedArray[]} */
      const pictures = [];
      for (let frameIndex = 0; frameIndex < count; frameIndex += 1) {
        const { image } = await decoder.decode({ frameIndex });
        context.fillRect(0, 0, 48, 60);
        context.drawImage(image, 0, 0);
        image.close();
        pictures.push(context.getImageData(0, 0, 48, 60).data);
      }
      const far = (/** @type {number} */ a, /** @type {number} */ b) =>
        pictures[a].reduce((sum, value, at) => sum + Math.abs(value - pictures[b][at]), 0);
      const neighbours = pictures.slice(1).map((_, at) => far(at, at + 1));
      const unrelated = pictures.slice(12).map((_, at) => far(at, at + 12));
      const contrasts = pictures.map((picture) => {
        const mean = picture.reduce((sum, value) => sum + value, 0) / picture.length;
        return Math.sqrt(picture.reduce((sum, value) => sum + (value - mean) ** 2, 0) / picture.length);
      });
      return { count, seam: far(count - 1, 0), neighbours, unrelated, contrasts };
    });
    assert.equal(count, 24);
    // The last six pictures are mixed with earlier ones.
    const mean = (/** @type {number[]} */ values) => values.reduce((sum, value) => sum + value, 0) / values.length;
    const kept = mean(contrasts.slice(-6)) / mean(contrasts.slice(0, -6));
    assert.ok(kept >= 0.9, `${kept} of the contrast: ${contrasts}`);
    // One step of 24 is the greatest as likely as any other; without a loop, the seam is as far as half a second is.
    const farthest = (mean(neighbours) + mean(unrelated)) / 2;
    assert.ok(seam <= farthest, `${seam} of ${farthest}: ${neighbours}; ${unrelated}`);
  },
);

test('a hidden tab pauses a film, which goes on when it is shown', TABS, async () => {
  const tab = await paused();
  await tab.fire((fire) => {
    const page = /** @type {any} */ (window);
    const onprogress = (/** @type {{frame: number}} */ { frame }) => (page.frame = frame);
    page.film = fire.record({ format: 'zip', seconds: 8, width: 32, height: 40, onprogress });
  });
  await tab.until('a picture', () => /** @type {any} */ (window).frame > 0);
  const other = await browser.browser.newPage();
  await other.bringToFront();
  const rest = await tab.evaluate(async () => {
    const page = /** @type {any} */ (window);
    for (let before = -1; before !== page.frame; ) {
      before = page.frame;
      await new Promise((resolve) => setTimeout(resolve, 1500));
    }
    return { frame: page.frame, hidden: document.hidden };
  });
  assert.ok(rest.hidden && rest.frame < 240, JSON.stringify(rest));
  await other.close();
  await tab.page.bringToFront();
  const frames = await tab.evaluate(async () => {
    await /** @type {any} */ (window).film;
    return /** @type {any} */ (window).frame;
  });
  assert.equal(frames, 240);
});

test('one picture of 4096 × 4096 is whole, and a film that exceeds the memory says what it would take', async () => {
  const tab = await paused();
  const outcome = await tab.fire(async (fire) => {
    const film = { width: 4096, height: 4096, seconds: 10 };
    const refusal = await fire.record(film).then(String, (error) => error.message);
    const file = /** @type {Blob} */ (await fire.record({ ...film, format: 'png' }));
    const { width, height } = await createImageBitmap(file);
    return { refusal, size: [width, height], bytes: file.size };
  });
  assert.match(outcome.refusal, /about \d+ MB of memory, and 872 MB to draw; at most 500 MB/);
  assert.deepEqual(outcome.size, [4096, 4096]);
  assert.ok(outcome.bytes > 100_000, `${outcome.bytes}`);
});

test('a cancelled film leaves no worker, no object of the graphics card and no byte in its stream', WEBM, async () => {
  const tab = await paused();
  await tab.fire((fire) => fire.record({ format: 'png', width: 64, height: 64 }).then(() => undefined));
  const alive = await tab.living();
  const outcome = await tab.fire(async (fire) => {
    const folder = await navigator.storage.getDirectory();
    const handle = await folder.getFileHandle('film', { create: true });
    const stopped = new AbortController();
    const film = { width: 64, height: 64, signal: stopped.signal };
    const errors = [];
    const why = async (/** @type {Promise<unknown>} */ promise) =>
      errors.push(
        await promise.then(
          () => 'none',
          (error) => `${error.name}: ${error.message}`.slice(0, 60),
        ),
      );
    let frames = 0;
    const onprogress = () => {
      frames += 1;
      if (frames === 1) why(fire.record({ ...film, format: 'png' }));
      if (frames === 3) stopped.abort();
    };
    await why(fire.record({ ...film, onprogress, stream: await handle.createWritable() }));
    await why(fire.record(film));
    const cancelled = (await handle.getFile()).size;
    // A film that ends is whole in its stream.
    const whole = { ...film, signal: undefined, format: /** @type {const} */ ('webm'), seconds: 0.2 };
    const result = await fire.record({ ...whole, stream: await handle.createWritable() });
    const [streamed, kept] = [await handle.getFile(), /** @type {Blob} */ (await fire.record(whole))];
    const texts = await Promise.all(
      [streamed, kept].map(async (file) => new Uint8Array(await file.arrayBuffer()).join()),
    );
    return { errors, cancelled, result, same: texts[0] === texts[1], size: kept.size };
  });
  assert.match(outcome.errors[0], /this fire is being recorded/);
  assert.match(outcome.errors[1], /^AbortError/);
  assert.match(outcome.errors[2], /^AbortError/);
  assert.deepEqual([outcome.cancelled, outcome.result, outcome.same], [0, undefined, true]);
  assert.ok(outcome.size > 500);
  const { memory: _, ...left } = await tab.living();
  const { memory: __, ...expected } = alive;
  assert.deepEqual(left, expected);
});

test('a lost context and a removed fire end a film with a clear error, and the fire burns again', async () => {
  const tab = await paused();
  const film = tab.fire((fire) =>
    fire.record({ seconds: 60, width: 64, height: 64 }).then(String, (error) => error.message),
  );
  await tab.until('a worker', () =>
    performance.getEntriesByType('resource').some(({ name }) => name.includes('record.js')),
  );
  await tab.loseContext(300);
  assert.match(await film, /graphics context was lost/);
  await tab.until('it is back', () =>
    /** @type {any} */ (document.querySelector('hearth-fire')).record({ format: 'png', width: 32, height: 32 }).then(
      () => true,
      () => false,
    ),
  );
  const removed = await tab.fire(async (fire) => {
    const onprogress = () => fire.remove();
    return fire.record({ seconds: 60, width: 64, height: 64, onprogress }).then(String, (error) => error.message);
  });
  assert.match(removed, /removed/);
});

test('the dialog of the page shows a sample, and size and time, before it records; Escape cancels and the fire goes on', async () => {
  const keepSaved = () => {
    HTMLAnchorElement.prototype.click = function () {
      if (this.download) /** @type {any} */ (window).saved = this.download;
    };
  };
  for (const options of [
    { width: 900, height: 700 },
    { width: 390, height: 844, touch: true },
  ]) {
    const tab = await browser.open('index.html?scene=candle', { ...options, before: keepSaved });
    await tab.ready();
    await tab.page.click('[data-opens="save"]');
    const inside = '.hearth-recorder >>> ';
    await tab.page.waitForSelector(`${inside}dialog`);
    await tab.page.click(`${inside}[value="film"]`);
    await tab.page.select(`${inside}[name="size"]`, '256 × 256');
    const lasts = (/** @type {string} */ seconds) =>
      tab.page.$eval(
        `${inside}[name="seconds"]`,
        (field, seconds) => {
          /** @type {HTMLInputElement} */ (field).value = seconds;
          field.dispatchEvent(new Event('input', { bubbles: true }));
        },
        seconds,
      );
    await lasts('0.5');
    const says = (/** @type {RegExp} */ words) =>
      tab.page.waitForFunction(
        (source) =>
          RegExp(source).test(
            document.querySelector('.hearth-recorder')?.shadowRoot?.querySelector('.about')?.textContent ?? '',
          ),
        {},
        words.source,
      );
    await says(/^15 pictures of 256 × 256, about \d+ MB, about \d+ s to record\.$/);
    assert.ok(await tab.page.$(`${inside}.preview img`), 'a sample');
    const named = await tab.page.$$eval(`${inside}:is(select, input, button, progress)`, (fields) =>
      fields.map((field) => [
        /** @type {HTMLInputElement} */ (field).name,
        field.ariaLabel ?? field.textContent ?? '',
        /** @type {HTMLInputElement} */ (field).labels?.length,
      ]),
    );
    for (const [name, text, labels] of named) assert.ok(labels || text, `${name} has a name`);
    const fits = await tab.page.$eval(
      `${inside}dialog`,
      (dialog) => dialog.scrollWidth <= dialog.clientWidth && dialog.getBoundingClientRect().bottom <= innerHeight,
    );
    assert.ok(fits, 'it fits the page');
    await tab.page.click(`${inside}[name="save"]`);
    await says(/^Saved hearth\.\w+, 256 × 256 pixels/);
    // Without an encoder of WebP, the dialog offers APNG first.
    const name = BROWSER === 'webkit' ? 'hearth.png' : 'hearth.webp';
    assert.equal(await tab.evaluate(() => /** @type {any} */ (window).saved), name);
    await tab.page.$eval(`${inside}.about`, (about) => {
      const cancel = /** @type {ShadowRoot} */ (about.getRootNode()).querySelector('[name="cancel"]');
      const watch = new MutationObserver(() => {
        if (!/^Picture /.test(about.textContent)) return;
        watch.disconnect();
        /** @type {HTMLElement} */ (cancel).click();
      });
      watch.observe(about, { childList: true });
    });
    await tab.page.click(`${inside}[name="save"]`);
    await says(/^Cancelled\. Nothing is saved\.$/);
    await tab.page.click(`${inside}[value="sheet"]`);
    await lasts('1');
    await says(/^30 pictures of 256 × 256/);
    await tab.key('Escape');
    await tab.until('no dialog', () => !document.querySelector('.hearth-recorder'));
    const age = await tab.fire((fire) => fire.stats?.time ?? 0);
    await tab.plays(age + 0.1);
    assert.deepEqual(tab.problems, []);
  }
});
