// The still's small form in the panel: format, size, quality, progress, and the server's sentence where it refuses.

export class StillPanel {
  constructor({ root, stills, window_size_px }) {
    const find = id => root.querySelector(`#${id}`);
    Object.assign(this, {
      form: find('still'), opener: find('still_open'), save: find('still_save'), progress: find('still_progress'),
      message: find('still_message'), size: find('still_size'), samples: find('still_samples_row'), stills, window_size_px,
    });
    this.opener.addEventListener('click', () => this.toggle());
    this.form.addEventListener('change', () => this.refresh());
    this.form.addEventListener('submit', event => {
      event.preventDefault();
      if (stills.busy) stills.cancel();
      else this.#take();
    });
  }

  toggle() {
    this.form.hidden = !this.form.hidden;
    this.opener.setAttribute('aria-expanded', String(!this.form.hidden));
    this.refresh();
  }

  refresh() {
    const [width, height] = this.window_size_px().map(side => Math.round(side * this.#choice().scale));
    this.samples.hidden = this.#choice().quality !== 'reference';
    this.size.textContent = `${width} × ${height} pixels`;
  }

  #choice() {
    const { format, scale, quality, samples } = Object.fromEntries(new FormData(this.form));
    return { format, quality, scale: Number(scale), samples: Number(samples) };
  }

  #say(text, failed = false) {
    this.message.textContent = text;
    this.message.classList.toggle('failed', failed);
  }

  async #take() {
    const start_ms = performance.now();
    const elapsed = () => this.#say(`Rendering, ${Math.round((performance.now() - start_ms) / 1000)} s`);
    const timer = setInterval(elapsed, 1000);
    this.save.textContent = 'Stop';
    this.progress.hidden = false;
    this.#say('Rendering');
    try {
      const name = await this.stills.take({ ...this.#choice(), on_progress: share => this.#advance(share) });
      this.#say(name ? `Saved ${name}` : '');
    } catch (error) {
      this.#say(error.message, true);
    } finally {
      clearInterval(timer);
      this.save.textContent = 'Save';
      this.progress.hidden = true;
    }
  }

  #advance(share) {
    if (share === null) this.progress.removeAttribute('value');
    else this.progress.value = share;
  }
}
