// What the browser remembers: the token for this tab, a few habits for this device. Works without storage too.

const prefix = 'cloudscape.';

export class Store {
  #memory = new Map();

  get token() {
    return this.#read('sessionStorage', 'token');
  }

  set token(token) {
    this.#write('sessionStorage', 'token', token);
  }

  get(name) {
    return this.#read('localStorage', name);
  }

  set(name, value) {
    this.#write('localStorage', name, value);
  }

  // A browser that forbids storage throws on the very access.
  #read(kind, name) {
    try {
      return globalThis[kind].getItem(prefix + name) ?? undefined;
    } catch {
      return this.#memory.get(name);
    }
  }

  #write(kind, name, value) {
    this.#memory.set(name, value);
    try {
      globalThis[kind].setItem(prefix + name, value);
    } catch {
      // kept in memory for as long as the page lives
    }
  }
}
