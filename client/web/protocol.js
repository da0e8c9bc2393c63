// The stream protocol cloudscape.v1 as the page speaks it: text messages as objects, binary frames as header and image.

export const subprotocol = 'cloudscape.v1';
export const frame_header_bytes = 92;
export const final_stage = 255;

// The token travels as a second subprotocol: a browser cannot set headers on a WebSocket.
export function subprotocols(token) {
  return token ? [subprotocol, `bearer.${token}`] : [subprotocol];
}

const image_types = ['image/jpeg', 'image/png'];
const lens_kinds = ['perspective', 'orthographic', 'panorama', 'fisheye'];

// Splits one binary message; the image is a view into it, not a copy. Throws an Error in one sentence.
export function read_frame(buffer) {
  if (buffer.byteLength < frame_header_bytes) {
    throw new Error(`A frame of ${buffer.byteLength} bytes is shorter than its header of ${frame_header_bytes}.`);
  }
  const data = new DataView(buffer);
  let at = 0;
  const u8 = () => data.getUint8(at++);
  const u16 = () => data.getUint16((at += 2) - 2, true);
  const u32 = () => data.getUint32((at += 4) - 4, true);
  const u64 = () => Number(data.getBigUint64((at += 8) - 8, true));
  const f32 = () => data.getFloat32((at += 4) - 4, true);
  const f64 = () => data.getFloat64((at += 8) - 8, true);

  const version = u8();
  if (version !== 1) throw new Error(`The server sends frames of version ${version}; this page reads version 1.`);
  const header = {
    quality_stage: u8(), image_type: image_types[u8()], lens_kind: lens_kinds[u8()], frame_id: u32(),
    pose_sequence: u64(), width_px: u16(), height_px: u16(), vertical_fov_deg: f32(),
    pose: { position_m: [f64(), f64(), f64()], azimuth_deg: f64(), elevation_deg: f64(), roll_deg: f64() },
    time_s: f64(), render_ms: f32(), encode_ms: f32(),
  };
  const image_bytes = u32();
  if (frame_header_bytes + image_bytes !== buffer.byteLength) {
    const carried_bytes = buffer.byteLength - frame_header_bytes;
    throw new Error(`A frame announces ${image_bytes} bytes of image and carries ${carried_bytes}.`);
  }
  if (!header.image_type) throw new Error('A frame carries an image format that browsers do not show.');
  return { header, image: new Uint8Array(buffer, frame_header_bytes, image_bytes) };
}

// What the person has chosen, in the protocol's members. What is absent stays the document's own.
export function view_members(chosen) {
  const members = {};
  if (chosen.pose) members.pose = chosen.pose;
  if (chosen.vertical_fov_deg !== undefined) {
    members.lens = { kind: 'perspective', vertical_fov_deg: chosen.vertical_fov_deg };
  }
  if (chosen.exposure_ev !== undefined || chosen.tone_curve !== undefined) {
    members.display = { dither: true };
    if (chosen.exposure_ev !== undefined) members.display.exposure_ev = chosen.exposure_ev;
    if (chosen.tone_curve !== undefined) members.display.tone_curve = chosen.tone_curve;
  }
  for (const name of ['quality', 'sun_azimuth_deg', 'sun_elevation_deg', 'sun_time_rate', 'time_s']) {
    if (chosen[name] !== undefined) members[name] = chosen[name];
  }
  return members;
}

export function hello_message(chosen, size_px) {
  return { type: 'hello', version: 1, cloudscape: chosen.cloudscape, size_px, ...view_members(chosen) };
}

export function camera_message(pose_sequence, pose, time_s) {
  return { type: 'camera', pose_sequence, pose, time_s };
}

// Turns the document's clock, for all who look at it; without members it is only followed again.
export function clock_message({ time_s, rate, paused }) {
  return { type: 'clock', time_s, rate, paused };
}

export function ack_message(frame_id, decode_ms) {
  return { type: 'ack', frame_id, decode_ms: Math.round(decode_ms * 100) / 100 };
}
