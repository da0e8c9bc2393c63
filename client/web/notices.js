// What the page says in words: a passing toast, a pill while it reconnects, a card where the server refuses.

const toast_ms = 1800;  // tuned: long enough for a short sentence
const patience_ms = 900;  // tuned: shorter waits need no words
const headings = {
  token: 'Access token needed', forbidden: 'Not allowed', cloudscape: 'No such sky', protocol: 'The stream was refused',
};

export class Notices {
  #toast_timer = null;
  #patience_timer = null;

  // `on_again(kind)`: the button was pressed. `on_token(text)`: a token was given.
  constructor({ toast, notice, on_again, on_token }) {
    Object.assign(this, { toast_node: toast, notice });
    this.again = notice.querySelector('#again');
    this.token_form = notice.querySelector('form');
    this.again.addEventListener('click', () => on_again(this.kind));
    this.token_form.addEventListener('submit', event => {
      event.preventDefault();
      on_token(this.token_form.elements.token.value.trim());
    });
  }

  toast(text, lasting_ms = toast_ms) {
    clearTimeout(this.#toast_timer);
    this.toast_node.textContent = text;
    this.toast_node.classList.add('shown');
    this.#toast_timer = setTimeout(() => this.toast_node.classList.remove('shown'), lasting_ms);
  }

  waiting(reason) {
    this.#show({ kind: 'waiting', quiet: true, heading: '', text: `${reason} Reconnecting…`, again: 'Now' });
  }

  refused({ kind, message }, again = 'Try again') {
    this.#show({ kind, heading: headings[kind] ?? headings.protocol, text: message, again });
    if (kind === 'token') this.token_form.elements.token.focus();
  }

  // The first picture of a sky may have to wait until its noise is baked.
  preparing(title) {
    this.clear();
    const words = { kind: 'preparing', quiet: true, heading: '', text: `Preparing ${title}…`, again: '' };
    this.#patience_timer = setTimeout(() => this.#show(words), patience_ms);
  }

  // All, or only a notice of this kind.
  clear(kind) {
    clearTimeout(this.#patience_timer);
    if (!kind || kind === this.kind) this.notice.hidden = true;
  }

  #show({ kind, quiet = false, heading, text, again }) {
    clearTimeout(this.#patience_timer);
    const asks_token = kind === 'token';
    this.kind = kind;
    this.notice.classList.toggle('quiet', quiet);
    this.notice.dataset.kind = kind;
    this.notice.querySelector('h2').textContent = heading;
    this.notice.querySelector('p').textContent = text;
    this.again.textContent = again;
    this.again.hidden = asks_token || !again;
    this.token_form.hidden = !asks_token;
    this.notice.hidden = false;
  }
}
