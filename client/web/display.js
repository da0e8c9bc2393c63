// The canvas that fills the window: shows decoded images and lets go of them.

export class Display {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext('2d', { alpha: false });
  }

  // Takes the image over. The canvas has the image's pixels; the style sheet stretches it over the window.
  show(image, { width_px, height_px }) {
    if (this.canvas.width !== width_px || this.canvas.height !== height_px) {
      this.canvas.width = width_px;
      this.canvas.height = height_px;
    }
    this.context.drawImage(image, 0, 0, width_px, height_px);
    image.close();
    this.canvas.classList.add('shown');
  }
}
