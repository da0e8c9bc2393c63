// Mouse: a drag takes hold of the sky, pointer lock looks around freely, the wheel sets the speed.

const wheel_step = 1.2;  // tuned: about twelve notches for a tenfold speed
const notch_px = 100;    // of a usual wheel in Chromium; a touchpad sends fractions of it

export class MouseInput {
  #dragging = false;

  // `on_look(right_px, up_px, locked)`; `on_speed(factor)`; `on_lock(is_locked)`.
  constructor({ surface, on_look, on_speed, on_lock }) {
    this.surface = surface;
    this.on_lock = on_lock;
    surface.addEventListener('pointerdown', event => this.#press(event));
    surface.addEventListener('pointermove', event => {
      if (event.pointerType !== 'mouse') return;
      if (this.locked) on_look(event.movementX, -event.movementY, true);
      else if (this.#dragging) on_look(event.movementX, -event.movementY, false);
    });
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture']) {
      surface.addEventListener(end, () => this.#drag(false));
    }
    surface.addEventListener('dblclick', () => this.toggle_lock());
    surface.addEventListener('wheel', event => {
      event.preventDefault();
      const notches = event.deltaMode === 0 ? event.deltaY / notch_px : Math.sign(event.deltaY);
      on_speed(wheel_step ** -Math.max(-3, Math.min(3, notches)));
    }, { passive: false });
    document.addEventListener('pointerlockchange', () => on_lock(this.locked));
  }

  get locked() {
    return document.pointerLockElement === this.surface;
  }

  async toggle_lock() {
    if (this.locked) return document.exitPointerLock();
    // A refusal (too soon after Escape, no permission) leaves dragging as it was.
    await Promise.resolve(this.surface.requestPointerLock?.()).catch(() => {});
  }

  #press(event) {
    if (event.pointerType !== 'mouse' || event.button !== 0 || this.locked) return;
    this.surface.setPointerCapture(event.pointerId);
    this.#drag(true);
  }

  #drag(is_on) {
    this.#dragging = is_on;
    this.surface.classList.toggle('dragging', is_on);
  }
}
