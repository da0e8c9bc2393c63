// The canvas that fills the window: shows decoded images, turned to the newest orientation, and lets go of them.

import { css_transform, homography } from './reproject.js';

export class Display {
  #header = null;
  #pose = null;

  // `edge` lies behind the sky: the same picture in a few pixels, for the rim that a turned picture leaves open.
  constructor({ sky, edge }) {
    Object.assign(this, { sky, edge });
    [this.context, this.edge_context] = [sky, edge].map(canvas => canvas.getContext('2d', { alpha: false }));
  }

  // Takes the image over. The canvas has the image's pixels; the style sheet stretches it over the window.
  show(image, header) {
    const { width_px, height_px } = header;
    if (this.sky.width !== width_px || this.sky.height !== height_px) {
      this.sky.width = width_px;
      this.sky.height = height_px;
    }
    this.context.drawImage(image, 0, 0, width_px, height_px);
    this.edge_context.drawImage(image, 0, 0, this.edge.width, this.edge.height);
    image.close();
    this.#header = header;
    this.#turn();
    this.sky.classList.add('shown');
  }

  // The orientation that the person has now.
  aim(pose) {
    this.#pose = pose;
    this.#turn();
  }

  #turn() {
    const header = this.#header;
    if (!header || !this.#pose || header.lens_kind !== 'perspective') {
      this.sky.style.transform = 'none';
      return;
    }
    // The picture covers the window (object-fit), so its height may reach beyond.
    const height_css = Math.max(this.sky.clientHeight, this.sky.clientWidth * header.height_px / header.width_px);
    const focal_px = height_css / 2 / Math.tan(header.vertical_fov_deg * Math.PI / 360);
    this.sky.style.transform = css_transform(homography(header.pose, this.#pose, focal_px));
  }
}
