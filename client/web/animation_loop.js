// Calls a step in every animation frame for as long as it asks to go on: a page at rest costs nothing.

const longest_step_s = 0.1;  // after a stall the camera does not leap

export class AnimationLoop {
  #request = null;
  #last_ms = 0;

  // `step(dt_s)` returns whether to go on.
  constructor(step) {
    this.step = step;
  }

  wake() {
    if (this.#request !== null) return;
    this.#last_ms = performance.now();
    this.#request = requestAnimationFrame(now_ms => this.#tick(now_ms));
  }

  #tick(now_ms) {
    // The frame's time may lie a little before the call that woke the loop.
    const dt_s = Math.max(0, Math.min(longest_step_s, (now_ms - this.#last_ms) / 1000));
    this.#last_ms = Math.max(this.#last_ms, now_ms);
    const goes_on = this.step(dt_s);
    this.#request = goes_on ? requestAnimationFrame(next_ms => this.#tick(next_ms)) : null;
  }
}
