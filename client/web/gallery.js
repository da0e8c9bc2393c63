// The gallery: pictures of the stills that have names, made by this program; where a stream can show the place, a way there.
import { list_stills } from './api.js';

// `title` and `description` come from documents: they are text, never markup.
function element(tag, properties, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

export class Gallery {
  // `on_fly(view)`: the view as a link's fragment, without '#'; `on_error(sentence)`.
  constructor({ dialog, opener, token, on_fly, on_error }) {
    Object.assign(this, { dialog, token, on_fly, on_error, pictures: dialog.querySelector('#pictures') });
    opener.addEventListener('click', () => this.open());
    dialog.querySelector('button').addEventListener('click', () => dialog.close());
    dialog.addEventListener('click', event => { if (event.target === dialog) dialog.close(); });
  }

  async open() {
    this.dialog.showModal();
    if (this.pictures.childElementCount) return;
    try {
      const stills = await list_stills(this.token());
      this.pictures.replaceChildren(...stills.map(still => this.#card(still)));
    } catch (error) {
      this.dialog.close();
      this.on_error(error.message);
    }
  }

  #card({ name, title, description, view }) {
    const url = new URL(`pictures/${name}.jpg`, document.baseURI).href;
    const link = element('a', { href: url, target: '_blank', rel: 'noopener', title: 'The whole picture' },
      element('img', { src: url, alt: title, loading: 'lazy' }));
    const caption = element('figcaption', {}, element('b', { textContent: title }), element('p', { textContent: description }));
    if (view) {
      const fly = element('button', { type: 'button', textContent: 'Fly there' });
      fly.addEventListener('click', () => {
        this.dialog.close();
        this.on_fly(view);
      });
      caption.append(fly);
    }
    return element('figure', {}, link, caption);
  }
}
