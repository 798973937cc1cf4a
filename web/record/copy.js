/**
 * A copy of a fire in the engine, which burns by the clock of the simulation, as far as it is asked to. The fire that it
 * copies waits until the copy is closed.
 *
 * @typedef {import('../engine/engine.js').Call} Call
 * @typedef {import('../engine/engine.js').Message} Message
 */

/** A copy of a fire. */
export class Copy {
  #port;
  #fire;
  #host;
  #requests = 0;
  /** @type {Map<number, {resolve: (value: any) => void, reject: (error: Error) => void}>} */
  #open = new Map();
  /** The last picture, which nobody has taken. @type {ImageBitmap | Promise<ImageBitmap> | undefined} */
  #picture;
  /** Why there are no more pictures. @type {Error | undefined} */
  #ended;
  /** @type {(samples: Float32Array) => void} */
  onSamples = () => {};

  /**
   * @param {import('../engine/engine.js').Port} port
   * @param {number} original the number of the fire
   * @param {(call: Call) => Call} host resolves values of a call
   * @param {{start: number, count: number}} [loop] the pictures whose sparks it shows
   */
  constructor(port, original, host, loop) {
    this.#port = port;
    this.#host = host;
    this.original = original;
    this.#fire = port.open({
      onMessage: (message) => this.#receive(message),
      onPicture: (picture) => {
        this.drop();
        // A canvas of the engine shows another picture later.
        this.#picture = 'close' in picture ? picture : createImageBitmap(picture);
        port.shown(this.#fire);
      },
    });
    this.added = this.call('add', { films: original, paused: true, values: loop });
    this.added.catch(() => {});
  }

  /**
   * A copy of this one, for which it waits. It records its sparks or shows those of a loop that another copy has recorded.
   * @param {{start: number, count: number}} [loop]
   */
  copy(loop) {
    return new Copy(this.#port, this.#fire, this.#host, loop);
  }

  /** @type {(...call: Call) => Promise<any>} */
  call(...call) {
    if (this.#ended) return Promise.reject(this.#ended);
    const request = ++this.#requests;
    this.#port.send([this.#fire, request, ...this.#host(call)]);
    return new Promise((resolve, reject) => this.#open.set(request, { resolve, reject }));
  }

  /**
   * Sets how pictures are drawn, in that many pixels at most.
   * @type {(size: {width: number, height: number, background?: string}, pixels?: number) => Promise<void>}
   */
  async show({ width, height, background }, pixels = Math.max(width * height, 1024)) {
    await this.added;
    if (background !== undefined) await this.call('set', { backdrop: 'none', ground: 'none', background }, 'film');
    await this.call('max_pixels', pixels);
    await this.call('resize', width, height, 0);
    await this.call('visible', true);
  }

  /**
   * Burns on for so long and draws: a picture of that size, or of any.
   * @type {(seconds: number, size?: {width: number, height: number}) => Promise<ImageBitmap>}
   */
  async picture(seconds, size) {
    // Without time that passes, the picture may be there already.
    await this.call('advance', seconds);
    const picture = await this.#picture;
    this.#picture = undefined;
    if (!picture) throw new Error('the fire was not drawn');
    if (!size || (picture.width === size.width && picture.height === size.height)) return picture;
    picture.close();
    throw new Error(
      `the graphics card has no memory for ${size.width} × ${size.height} pixels: it draws ${picture.width} × ${picture.height}`,
    );
  }

  /** Frees a picture that nobody has taken. */
  drop() {
    const picture = this.#picture;
    this.#picture = undefined;
    Promise.resolve(picture).then(
      (bitmap) => bitmap?.close(),
      () => {},
    );
  }

  /** @param {Message} message */
  #receive({ type, request, value, errors, kind, message, samples }) {
    const open = this.#open.get(request ?? -1);
    if (type === 'samples') this.onSamples(samples);
    else if (type === 'error') {
      this.#end(new Error(kind === 'context-lost' ? 'the graphics context was lost during the film' : message));
    } else if (type === 'done' || type === 'refused') {
      this.#open.delete(request ?? -1);
      if (type === 'done') open?.resolve(value);
      else open?.reject(new RangeError(errors[0]?.message));
    }
  }

  /** Rejects what is open. @param {Error} error */
  #end(error) {
    this.#ended ??= error;
    for (const { reject } of this.#open.values()) reject(this.#ended);
    this.#open.clear();
  }

  /** Frees the copy: the fire that it copies goes on. */
  close() {
    this.#port.send([this.#fire, 0, 'remove']);
    this.#port.close(this.#fire);
    this.drop();
    this.#end(new Error('the film has ended'));
  }
}
