/**
 * `record` of the element: films of its fire, picture by picture, by the clock of the simulation. This code is loaded by the
 * first film. Its worker encodes.
 *
 * @typedef {import('./element/session/session.js').FireSession} FireSession
 * @typedef {import('./record/bytes.js').Piece} Piece
 * @typedef {import('./record/options.js').Film} Film
 */

import { Copy } from './record/copy.js';
import { loopOf, shareOfEarlier } from './record/loop.js';
import { FORMATS, MAX_BYTES, checkMemory, filmOf, megabytes } from './record/options.js';
import { RATE, Samples } from './record/wav.js';

export { FORMATS, LOOP_SECONDS, MAX_SIDE, MIN_SIDE, RATES, estimate } from './record/options.js';

/** Pixels of a picture in which the beginning of a loop is looked for. */
const SEARCH_PIXELS = 64 * 64;

/** Seconds of fire between two readings of its sound, if it has no pictures. */
const READ_SECONDS = 0.1;

/** The fires that are filmed. @type {WeakSet<FireSession>} */
const filmed = new WeakSet();

/**
 * Records a film of the fire, which waits meanwhile.
 * @param {FireSession} session
 * @param {import('./element/types.js').HearthFilm} [options]
 * @returns {Promise<Blob | undefined>} its file, unless it is written into a stream
 */
export async function record(session, options = {}) {
  if (filmed.has(session))
    throw new Error('this fire is being recorded: wait for that film, or cancel it by its signal');
  const { stream, signal, onprogress = () => {} } = /** @type {any} */ (options);
  const { fire, view } = session;
  const { width = 512, height = 512 } = view.canvas ?? {};
  const film = filmOf(options, { width, height, params: fire.params });
  checkMemory(film, Boolean(stream));
  if (!session.drawable) throw new Error('the graphics context is lost; it is restored with the event `restored`');
  signal?.throwIfAborted();
  filmed.add(session);
  const recording = new Recording(session, film, new Sink(stream), onprogress);
  try {
    return await recording.run(signal);
  } catch (error) {
    await recording.sink.abort();
    throw error;
  } finally {
    recording.close();
    filmed.delete(session);
  }
}

/** The film of a fire. */
class Recording {
  #session;
  #film;
  #onprogress;
  #worker;
  /** The answers of the worker that are awaited. @type {((answer: any) => void)[]} */
  #awaited = [];
  /** @type {Copy[]} */
  #copies = [];
  #samples = new Samples();
  /** Pictures so far, and all of them. */
  #done = 0;
  #all;
  /** Rejects when the film is cancelled or cannot go on. */
  #fail = (/** @type {unknown} */ _error) => {};
  /** @type {Promise<never>} */
  #failed = new Promise((_, reject) => (this.#fail = reject));

  /**
   * @param {FireSession} session
   * @param {Film} film
   * @param {Sink} sink
   * @param {(progress: import('./element/types.js').HearthFilmProgress) => void} onprogress
   */
  constructor(session, film, sink, onprogress) {
    this.#session = session;
    this.#film = film;
    this.#worker = session.trustedWorker(worker);
    this.sink = sink;
    this.#onprogress = onprogress;
    this.#all = film.count + (film.loop ? loopOf(film.count, film.fps).fade + this.#lived : 0);
    this.#failed.catch(() => {});
    this.#worker.onmessage = ({ data }) => this.#awaited.shift()?.(data);
    this.#worker.onerror = (event) => {
      event.preventDefault();
      this.#fail(new Error(`the code for films has failed: ${event.message ?? 'it could not be loaded'}`));
    };
  }

  /** @param {AbortSignal} [signal] @returns {Promise<Blob | undefined>} */
  async run(signal) {
    const cancel = () => this.#fail(signal?.reason);
    signal?.addEventListener('abort', cancel);
    try {
      return await Promise.race([this.#record(), this.#failed]);
    } finally {
      signal?.removeEventListener('abort', cancel);
    }
  }

  /** Ends the worker and the copies; the fire goes on. */
  close() {
    this.#fail(new Error('the film has ended'));
    this.#worker.terminate();
    for (const copy of this.#copies.reverse()) copy.close();
  }

  async #record() {
    const film = this.#film;
    const copy = this.#session.connection?.copy((port, fire, resolve) => new Copy(port, fire, resolve));
    if (!copy) throw new Error('there is no fire to record');
    this.#copies.push(copy);
    await copy.added;
    if (film.describe) film.text = JSON.stringify(await copy.call('export'));
    const { format } = await this.#ask({ open: film });
    film.format = format;
    const speed = Number(this.#session.fire.params.time_scale);
    if (film.from > 0) await copy.call('advance', film.from * speed);
    if (format === 'wav') await this.#listen(copy, speed);
    else await this.#draw(copy, speed);
    const samples = film.sound ? this.#samples.channels(Math.round((film.count * RATE) / film.fps)) : undefined;
    await this.#write(await this.#ask({ end: true, samples }));
    return this.sink.end(FORMATS[/** @type {import('./record/options.js').Format} */ (format)].type);
  }

  /** Collects the sound of the copy. @type {(copy: Copy, speed: number) => Promise<void>} */
  async #listen(copy, speed) {
    const { count, fps } = this.#film;
    await this.#hear(copy);
    while (this.#samples.count < (count * RATE) / fps) {
      await this.#check();
      await copy.call('advance', READ_SECONDS * speed);
      this.#done = Math.min(count, Math.floor((this.#samples.count * fps) / RATE));
      this.#progress();
    }
  }

  /** Asks for the sound of a copy. @param {Copy} copy */
  async #hear(copy) {
    const { roar, crackle, hiss } = this.#session.fire;
    copy.onSamples = (samples) => this.#samples.add(samples);
    await copy.call('sound', RATE, roar, crackle, hiss);
  }

  /** Draws the pictures of the film. @type {(original: Copy, speed: number) => Promise<void>} */
  async #draw(original, speed) {
    const film = this.#film;
    const { count, fps, loop } = film;
    const fade = loop ? loopOf(count, fps).fade : 0;
    const start = loop ? await this.#search(original, speed) : 0;
    const copy = loop ? original.copy({ start, count }) : original;
    if (loop) this.#copies.push(copy);
    if (film.sound) await this.#hear(copy);
    await copy.show(film);
    // The steps are those of the search. What is seen follows from earlier pictures: the first one is not shown.
    for (let number = 1; number < start - fade; number += 1) copy.call('advance', speed / fps).catch(this.#fail);
    (await copy.picture(start > fade ? speed / fps : 0, film)).close();
    let encoded = Promise.resolve();
    for (let number = -fade; number < count; number += 1) {
      await this.#check();
      const picture = await copy.picture(speed / fps, film);
      // One picture is encoded while the next one is drawn.
      await encoded;
      const share = shareOfEarlier(number, count, fade);
      const asked = number < 0 ? { keep: picture } : { picture, number, ...(loop && share > 0 && { share }) };
      encoded = this.#ask(asked, [picture]).then((answer) => this.#write(answer));
      encoded.catch(this.#fail);
    }
    await encoded;
    // The sound comes some samples late.
    if (film.sound) await copy.call('advance', READ_SECONDS * speed);
  }

  /** Pictures from the search of a loop until its last spark has gone out. */
  get #lived() {
    const { count, fps } = this.#film;
    const { ember_life_max: life, time_scale: speed } = this.#session.fire.params;
    return loopOf(count, fps).searched + Math.ceil((Number(life) / Number(speed)) * fps);
  }

  /**
   * The number of the picture with which a loop begins. Another copy of the copy can show the loop's sparks then.
   * @type {(copy: Copy, speed: number) => Promise<number>}
   */
  async #search(copy, speed) {
    const { count, fps } = this.#film;
    const small = copy.copy();
    this.#copies.push(small);
    await small.show(this.#film, SEARCH_PIXELS);
    const { searched } = loopOf(count, fps);
    for (let number = 0; number < this.#lived; number += 1) {
      await this.#check();
      const picture = await small.picture(speed / fps);
      if (number < searched) await this.#write(await this.#ask({ search: picture }, [picture]));
      else {
        picture.close();
        await this.#write({});
      }
    }
    const { start } = await this.#ask({ found: true });
    this.#copies.pop();
    small.close();
    return start;
  }

  /** Asks the worker. @type {(asked: import('./record/worker.js').Asked, transfer?: Transferable[]) => Promise<any>} */
  async #ask(asked, transfer = []) {
    const answer = await new Promise((resolve) => {
      this.#awaited.push(resolve);
      this.#worker.postMessage(asked, transfer);
    });
    if (answer.why !== undefined) throw new Error(answer.why);
    return answer;
  }

  /** Writes what the worker has made of a picture. @param {{pieces?: Piece[]}} answer */
  async #write({ pieces = [] }) {
    for (const piece of pieces) await this.sink.write(piece);
    this.#done += 1;
    this.#progress();
  }

  #progress() {
    const [frame, frames] = [Math.min(this.#done, this.#all), this.#all];
    this.#onprogress({ frame, frames, bytes: this.sink.bytes });
  }

  /**
   * Waits until the page is shown.
   * @throws {Error} the fire is another one, or there is none
   */
  async #check() {
    while (document.hidden)
      await new Promise((resolve) => document.addEventListener('visibilitychange', resolve, { once: true }));
    if (this.#session.connection?.number !== this.#copies[0].original)
      throw new Error('the fire was removed during the film');
  }
}

/** Where the file goes: memory, or a stream of the page. */
class Sink {
  /** Parts of the file; the first one, whose bytes may be replaced, stays as it is. @type {BlobPart[]} */
  #parts = [];
  #stream;
  bytes = 0;

  /** @param {any} stream */
  constructor(stream) {
    if (stream !== undefined && typeof stream?.write !== 'function')
      throw new TypeError('stream must be a FileSystemWritableFileStream');
    this.#stream = stream;
  }

  /** @param {Piece} piece */
  async write({ bytes, at }) {
    if (at === undefined) this.bytes += bytes.length;
    if (this.#stream) {
      await this.#stream.write(at === undefined ? bytes : { type: 'write', position: at, data: bytes });
      return;
    }
    if (this.bytes > MAX_BYTES)
      throw new Error(
        `the film exceeds ${megabytes(MAX_BYTES)} of memory: make it smaller or shorter, or give a \`stream\``,
      );
    if (at !== undefined) /** @type {Uint8Array} */ (this.#parts[0]).set(bytes, at);
    else this.#parts.push(this.#parts.length > 0 ? new Blob([bytes]) : bytes);
  }

  /** @param {string} type @returns {Promise<Blob | undefined>} */
  async end(type) {
    if (!this.#stream) return new Blob(this.#parts, { type });
    await this.#stream.close();
    return undefined;
  }

  /** Leaves nothing behind. */
  async abort() {
    this.#parts = [];
    await this.#stream?.abort?.().catch(() => {});
  }
}

/** Starts the worker that encodes. */
function worker() {
  try {
    return new Worker(new URL('./record/worker.js', import.meta.url), { type: 'module', name: 'hearth-film' });
  } catch {
    // A page may not start a worker from another origin, but a worker that imports it.
    const text = `import ${JSON.stringify(new URL('./record/worker.js', import.meta.url).href)};`;
    const url = URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
    setTimeout(() => URL.revokeObjectURL(url), 60_000);
    return new Worker(url, { type: 'module', name: 'hearth-film' });
  }
}
