// Turns the last picture to the newest orientation until the next one comes, as head-mounted displays do: clouds are
// far away, so a rotation alone is nearly exact, and the sky follows the hand at the display's rate.

import { view_axes } from './camera.js';

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const widest_turn_cosine = Math.cos(Math.PI / 4);  // beyond it hardly anything of the picture is left to see
const unmoved = 1e-7, unmoved_px = 1e-4;

// Where a point of a perspective picture taken from `from` lies in one taken from `to`: a 3x3 matrix, by rows,
// on points (x right, y down, 1) from the middle, `focal_px` being the distance of the image plane. Null: they share too little.
export function homography(from, to, focal_px) {
  const [a, b] = [view_axes(from), view_axes(to)];
  if (dot(a.forward, b.forward) < widest_turn_cosine) return null;
  const axes = ['right', 'up', 'forward'];
  const into = [focal_px, -focal_px, 1];  // the picture's y points down, the view's up
  return axes.map((row, i) => axes.map((column, j) => into[i] * dot(b[row], a[column]) / into[j]));
}

// As a CSS transform about the element's middle; 'none' where nothing turned.
export function css_transform(matrix) {
  if (!matrix) return 'none';
  const rests = (value, i, j) => Math.abs(value - (i === j)) < (j === 2 && i < 2 ? unmoved_px : unmoved);
  const identity = matrix.every((row, i) => row.every((value, j) => rests(value, i, j)));
  if (identity) return 'none';
  const [[a, b, c], [d, e, f], [g, h, i]] = matrix;
  return `matrix3d(${[a, d, 0, g, b, e, 0, h, 0, 0, 1, 0, c, f, 0, i].map(value => value.toPrecision(9)).join(',')})`;
}
