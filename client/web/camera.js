// The flight model: a pose that is turned by angles and moved by wishes, smoothly and independent of the frame rate.

const degree = Math.PI / 180;
const planet_radius_m = 6360e3;  // the server's ground sphere
const clearance_m = 2;           // eye height of a person who stands
const smoothing_s = 0.18;        // tuned: longer glides more, shorter answers sooner
const boost = 5;                 // tuned: crosses a cloud field in seconds, still steerable
const steepest_gain = 4;         // near the zenith a dragged point would turn the camera without end
export const speed_limits_m_per_s = [1, 10000];

// What all inputs together ask for: axes in -1..1 (turns in -1..1 of the turning rate).
export function sum_intents(intents) {
  const sum = { right: 0, forward: 0, up: 0, turn_right: 0, turn_up: 0, fast: false };
  for (const intent of intents) {
    for (const axis of ['right', 'forward', 'up', 'turn_right', 'turn_up']) sum[axis] += intent[axis] ?? 0;
    sum.fast ||= Boolean(intent.fast);
  }
  return sum;
}

export function is_idle(intent) {
  return !intent.right && !intent.forward && !intent.up && !intent.turn_right && !intent.turn_up;
}

// Unit vectors of the view in the world (east, north, up). Positive roll turns the camera clockwise.
export function view_axes({ azimuth_deg, elevation_deg, roll_deg }) {
  const [sa, ca] = [Math.sin(azimuth_deg * degree), Math.cos(azimuth_deg * degree)];
  const [se, ce] = [Math.sin(elevation_deg * degree), Math.cos(elevation_deg * degree)];
  const [sr, cr] = [Math.sin(roll_deg * degree), Math.cos(roll_deg * degree)];
  const level_right = [ca, -sa, 0];
  const level_up = [-sa * se, -ca * se, ce];
  const mix = (a, x, b, y) => a.map((value, i) => value * x + b[i] * y);
  return {
    forward: [sa * ce, ca * ce, se],
    right: mix(level_right, cr, level_up, -sr),
    up: mix(level_up, cr, level_right, sr),
  };
}

export function altitude_m([east, north, up]) {
  return Math.hypot(east, north, up + planet_radius_m) - planet_radius_m;
}

// The same place, raised along the vertical to an altitude where it is lower.
function above(position_m, lowest_m) {
  const [east, north, up] = position_m;
  const from_centre_m = Math.hypot(east, north, up + planet_radius_m);
  const scale = Math.max(1, (lowest_m + planet_radius_m) / from_centre_m);
  return [east * scale, north * scale, (up + planet_radius_m) * scale - planet_radius_m];
}

export class FlightCamera {
  speed_m_per_s = 120;  // tuned: a fair-weather cumulus is passed in about ten seconds
  turn_rate_deg_per_s = 60;
  smoothing_s = smoothing_s;
  #velocity_m_per_s = [0, 0, 0];
  #turn_deg_per_s = [0, 0];
  #lowest_m = clearance_m;

  constructor(pose) {
    this.place(pose);
  }

  // Jumps there and stands still.
  place(pose) {
    this.pose = { ...pose, position_m: [...pose.position_m] };
    // The ground stops a descent; a view that starts lower (a document without ground) may stay as low.
    this.#lowest_m = Math.min(clearance_m, altitude_m(pose.position_m));
    this.#stop();
  }

  look(right_deg, up_deg) {
    const azimuth = (this.pose.azimuth_deg + right_deg) % 360;
    this.pose.azimuth_deg = azimuth < 0 ? azimuth + 360 : azimuth;
    this.pose.elevation_deg = Math.max(-90, Math.min(90, this.pose.elevation_deg + up_deg));
  }

  // A drag holds the sky: the view turns against the hand, by the angle that it passed over.
  drag(right_px, up_px, deg_per_px) {
    const lean = Math.min(steepest_gain, 1 / Math.max(1e-3, Math.cos(this.pose.elevation_deg * degree)));
    this.look(-right_px * deg_per_px * lean, -up_px * deg_per_px);
  }

  change_speed(factor) {
    const [least, most] = speed_limits_m_per_s;
    this.speed_m_per_s = Math.max(least, Math.min(most, this.speed_m_per_s * factor));
  }

  // One step of time. Velocity approaches the wish exponentially and is integrated in closed form, so that two steps of
  // 8 ms end where one of 16 ms does. Returns whether the camera still moves.
  step(dt_s, intent) {
    const settled = is_idle(intent);
    this.#turn(dt_s, intent);
    this.#move(dt_s, this.#wished_velocity(intent));
    const moves = Math.hypot(...this.#velocity_m_per_s) > this.speed_m_per_s * 1e-3 ||
      Math.hypot(...this.#turn_deg_per_s) > 1e-2;
    if (settled && !moves) this.#stop();
    return moves || !settled;
  }

  #stop() {
    this.#velocity_m_per_s = [0, 0, 0];
    this.#turn_deg_per_s = [0, 0];
  }

  #wished_velocity({ right, forward, up, fast }) {
    const axes = view_axes(this.pose);
    const speed = this.speed_m_per_s * (fast ? boost : 1) / Math.max(1, Math.hypot(right, forward, up));
    return [0, 1, 2].map(i => speed * (axes.right[i] * right + axes.forward[i] * forward + axes.up[i] * up));
  }

  #approach(now, wish, dt_s) {
    const left = this.smoothing_s > 0 ? Math.exp(-dt_s / this.smoothing_s) : 0;
    return { next: wish + (now - wish) * left, way: wish * dt_s + (now - wish) * this.smoothing_s * (1 - left) };
  }

  #turn(dt_s, intent) {
    const wishes = [intent.turn_right * this.turn_rate_deg_per_s, intent.turn_up * this.turn_rate_deg_per_s];
    const steps = wishes.map((wish, i) => this.#approach(this.#turn_deg_per_s[i], wish, dt_s));
    this.#turn_deg_per_s = steps.map(step => step.next);
    if (steps.some(step => step.way)) this.look(steps[0].way, steps[1].way);
  }

  #move(dt_s, wish) {
    const steps = wish.map((value, i) => this.#approach(this.#velocity_m_per_s[i], value, dt_s));
    this.pose.position_m = above(this.pose.position_m.map((value, i) => value + steps[i].way), this.#lowest_m);
    this.#velocity_m_per_s = steps.map(step => step.next);
  }
}
