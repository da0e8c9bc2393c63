// How many pixels to ask for: the window's device pixels, within a budget and what the server allows.

// Pixels of a picture, by the choice in the panel. `automatic` depends on what renders.
const budgets_px = { full: Infinity, 1080: 1920 * 1080, 720: 1280 * 720, 540: 960 * 540, 360: 640 * 360 };
const automatic_px = { software: 960 * 540, gpu: 2560 * 1440 };  // tuned: sharpness against frames a second
const least_side_px = 16;

export function budget_px(choice, software) {
  return budgets_px[choice] ?? (software ? automatic_px.software : automatic_px.gpu);
}

// Both sides even, because 4:2:0 halves them.
export function stream_size_px({ width_css, height_css, device_pixel_ratio, budget, max_size_px }) {
  const [width, height] = [Math.max(1, width_css) * device_pixel_ratio, Math.max(1, height_css) * device_pixel_ratio];
  const scale = Math.min(1, Math.sqrt(budget / (width * height)), max_size_px[0] / width, max_size_px[1] / height);
  return [width, height].map(side => Math.max(least_side_px, 2 * Math.floor((side * scale + 1e-6) / 2)));
}
