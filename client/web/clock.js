// The document's clock, which all who look at it share: as the server last told it, and as it has run on since.

const longest_s = 1.6e7;  // the server's

export class Clock {
  paused = true;
  rate = 1;
  #time_s = 0;
  #told_ms = 0;

  constructor(now_ms = () => performance.now()) {
    this.now_ms = now_ms;
  }

  get time_s() {
    const passed_s = this.paused ? 0 : this.rate * (this.now_ms() - this.#told_ms) / 1000;
    return Math.max(-longest_s, Math.min(longest_s, this.#time_s + passed_s));
  }

  // As no one has touched it yet: of a server that has only just begun.
  get is_new() {
    return this.paused && this.time_s === 0;
  }

  // Takes what the server tells, or what this page is about to tell it; what is absent stays.
  tell({ time_s = this.time_s, rate = this.rate, paused = this.paused }) {
    this.#time_s = time_s;
    this.#told_ms = this.now_ms();
    Object.assign(this, { rate, paused });
  }
}

// What a clock on the wall shows at the place where the sky is seen, when `time_s` have passed since `time_utc`.
export function time_of_day(time_utc, rate, time_s) {
  return `${new Date(Date.parse(time_utc) + 1000 * rate * time_s).toISOString().slice(11, 16)} UTC`;
}
