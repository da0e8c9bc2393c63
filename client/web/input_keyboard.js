// Keys: WASD and QE fly, the arrows turn, shift is faster; single letters run the page's commands.

const axes = {
  KeyW: ['forward', 1], KeyS: ['forward', -1], KeyD: ['right', 1], KeyA: ['right', -1],
  KeyE: ['up', 1], KeyQ: ['up', -1],
  ArrowRight: ['turn_right', 1], ArrowLeft: ['turn_right', -1], ArrowUp: ['turn_up', 1], ArrowDown: ['turn_up', -1],
};

// Form controls keep the keys that they use themselves, an open dialog keeps all.
function is_taken(event) {
  const { target, code } = event;
  if (document.querySelector('dialog[open]')) return true;
  if (event.ctrlKey || event.metaKey || event.altKey) return true;
  if (target.matches?.('select, textarea, input[type=text], input[type=password]')) return true;
  if (code === 'Space') return Boolean(target.matches?.('button, input, summary'));
  return code.startsWith('Arrow') && Boolean(target.matches?.('input'));
}

export class KeyboardInput {
  #down = new Set();
  #shift = false;

  // `commands` maps a key's code to a function; `on_active` is called when flight keys change.
  constructor({ window, commands, on_active }) {
    window.addEventListener('keydown', event => {
      this.#shift = event.shiftKey;
      if (is_taken(event)) return;
      if (axes[event.code]) {
        this.#down.add(event.code);
        event.preventDefault();
        on_active();
      } else if (commands[event.code] && !event.repeat) {
        event.preventDefault();
        commands[event.code]();
      }
    });
    window.addEventListener('keyup', event => {
      this.#shift = event.shiftKey;
      this.#down.delete(event.code);
    });
    // A key that is released in another window is never reported.
    window.addEventListener('blur', () => this.#down.clear());
  }

  intent() {
    const intent = { fast: this.#shift };
    for (const code of this.#down) {
      const [axis, way] = axes[code];
      intent[axis] = (intent[axis] ?? 0) + way;
    }
    return intent;
  }
}
