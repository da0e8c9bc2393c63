// Touch: one finger looks, two fingers pinch to fly ahead and drag to slide; a stick on the screen flies with a thumb.

const pinch_gain = 6, slide_gain = 3;  // tuned: half a screen of movement is full speed
const fade_s = 0.1;                    // tuned: the flight ends softly when the fingers rest

export class TouchInput {
  #fingers = new Map();
  #flight = { right: 0, forward: 0, up: 0 };

  constructor({ surface, on_look, on_active }) {
    Object.assign(this, { surface, on_look, on_active });
    surface.addEventListener('pointerdown', event => this.#track(event));
    surface.addEventListener('pointermove', event => this.#move(event));
    for (const end of ['pointerup', 'pointercancel']) {
      surface.addEventListener(end, event => this.#fingers.delete(event.pointerId));
    }
  }

  intent(dt_s) {
    const intent = { ...this.#flight };
    for (const axis of Object.keys(this.#flight)) {
      const value = this.#flight[axis] * Math.exp(-dt_s / fade_s);
      this.#flight[axis] = Math.abs(value) < 0.02 ? 0 : value;
    }
    return intent;
  }

  #track(event) {
    if (event.pointerType === 'mouse') return;
    this.surface.setPointerCapture(event.pointerId);
    this.#fingers.set(event.pointerId, [event.clientX, event.clientY]);
  }

  #move(event) {
    const before = this.#fingers.get(event.pointerId);
    if (!before) return;
    const now = [event.clientX, event.clientY];
    const [right, down] = [now[0] - before[0], now[1] - before[1]];
    if (this.#fingers.size === 1) this.on_look(right, -down, false);
    else if (this.#fingers.size === 2) this.#fly(event.pointerId, before, now);
    this.#fingers.set(event.pointerId, now);
    this.on_active();
  }

  #fly(moved, before, now) {
    const [, other] = [...this.#fingers].find(([id]) => id !== moved);
    const span = point => Math.hypot(point[0] - other[0], point[1] - other[1]);
    const screen = Math.min(this.surface.clientWidth, this.surface.clientHeight);
    const push = (axis, px, gain) => {
      this.#flight[axis] = Math.max(-1, Math.min(1, this.#flight[axis] + gain * px / screen));
    };
    push('forward', span(now) - span(before), pinch_gain);
    // The scene follows the fingers: the camera slides the other way.
    push('right', before[0] - now[0], slide_gain);
    push('up', now[1] - before[1], slide_gain);
  }
}

// The stick: the way of the thumb from its middle is the wish to fly.
export class TouchStick {
  #intent = {};

  constructor({ stick, knob, on_active }) {
    let finger = null;
    const set = (x, y) => {
      knob.style.transform = `translate(${x * 50}%, ${y * 50}%)`;
      this.#intent = { right: x, forward: -y };
    };
    const follow = event => {
      const box = stick.getBoundingClientRect();
      const x = (event.clientX - box.left) / box.width * 2 - 1;
      const y = (event.clientY - box.top) / box.height * 2 - 1;
      const reach = Math.max(1, Math.hypot(x, y));
      set(x / reach, y / reach);
      on_active();
    };
    stick.addEventListener('pointerdown', event => {
      finger = event.pointerId;
      stick.setPointerCapture(finger);
      follow(event);
    });
    stick.addEventListener('pointermove', event => event.pointerId === finger && follow(event));
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture']) {
      stick.addEventListener(end, () => {
        finger = null;
        set(0, 0);
      });
    }
  }

  intent() {
    return this.#intent;
  }
}
