// Decodes frames off the main thread, one at a time; of those that wait meanwhile only the newest is decoded.

// The policy alone. `decode(frame)` promises an image; `show(image, frame, decode_ms)` takes it over; `skip(frame)` is
// told of each frame that a newer one replaced or that could not be decoded, so that it is acknowledged all the same.
export class LatestFrame {
  #running = false;
  #waiting = null;
  #generation = 0;

  constructor({ decode, show, skip, now = () => performance.now() }) {
    Object.assign(this, { decode, show, skip, now });
  }

  submit(frame) {
    if (this.#waiting) this.skip(this.#waiting);
    this.#waiting = frame;
    if (!this.#running) this.#run();
  }

  // Forgets what waits and what is being decoded: the stream that they belong to is gone.
  reset() {
    this.#generation++;
    this.#waiting = null;
  }

  async #run() {
    this.#running = true;
    while (this.#waiting) {
      const [frame, generation, start] = [this.#waiting, this.#generation, this.now()];
      this.#waiting = null;
      const image = await this.decode(frame).catch(() => null);
      if (generation !== this.#generation) image?.close();
      else if (image) this.show(image, frame, this.now() - start);
      else this.skip(frame);
    }
    this.#running = false;
  }
}

// decode(frame) by a module worker; by createImageBitmap here where workers cannot start.
export function make_decode() {
  const here = frame => createImageBitmap(new Blob([frame.image], { type: frame.header.image_type }));
  let settle = null;
  let worker = new Worker(new URL('decode_worker.js', import.meta.url), { type: 'module' });
  worker.onmessage = ({ data }) => (data.image ? settle?.resolve(data.image) : settle?.reject(new Error(data.reason)));
  worker.onerror = () => {
    worker = null;
    settle?.reject(new Error('The decode worker failed.'));
  };
  return frame => {
    if (!worker) return here(frame);
    return new Promise((resolve, reject) => {
      settle = { resolve, reject };
      // The whole message goes: its buffer is moved, not copied.
      worker.postMessage({ type: frame.header.image_type, image: frame.image }, [frame.image.buffer]);
    });
  };
}
