// Gamepad of the standard mapping: left stick flies, right stick looks, triggers sink and rise, bumpers set the speed.

const dead_zone = 0.12;  // tuned: worn sticks rest up to a tenth off their middle
const button = { boost: 0, slower: 4, faster: 5, sink: 6, rise: 7 };
const speed_rate_per_s = 2;  // the speed doubles in a second of holding

// Zero within the dead zone, then rising steadily; squared, so that small turns are fine.
export function stick_value(raw) {
  const beyond = Math.max(0, Math.abs(raw) - dead_zone) / (1 - dead_zone);
  return Math.sign(raw) * beyond * beyond;
}

export class GamepadInput {
  constructor({ window, on_active, on_speed }) {
    Object.assign(this, { on_speed, navigator: window.navigator });
    window.addEventListener('gamepadconnected', on_active);
  }

  #pad() {
    return this.navigator.getGamepads?.().find(pad => pad?.connected && pad.axes.length >= 4) ?? null;
  }

  // Gamepads send no events: while one is connected it has to be read in every frame.
  get connected() {
    return this.#pad() !== null;
  }

  intent(dt_s) {
    const pad = this.#pad();
    if (!pad) return {};
    const [x, y, turn_x, turn_y] = pad.axes.map(stick_value);
    const pressed = which => pad.buttons[which]?.value ?? 0;
    const faster = pressed(button.faster) - pressed(button.slower);
    if (faster) this.on_speed(speed_rate_per_s ** (faster * dt_s));
    return {
      right: x, forward: -y, up: pressed(button.rise) - pressed(button.sink), turn_right: turn_x, turn_up: -turn_y,
      fast: pressed(button.boost) > 0.5,
    };
  }
}
