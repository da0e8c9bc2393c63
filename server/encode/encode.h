// Frames to image bytes. Pure functions: any thread may call them.
#pragma once
#include "core/frame.h"

namespace cloudscape::encode {

// `front` bytes are left free before the image for the caller's headers. JPEG and PNG need Frame::display_rgba, EXR
// needs radiance_rgba and depth_m. JPEG through TurboJPEG; PNG 8 bit RGB with an sRGB chunk; EXR with channels R G B
// (radiance), A = 1 - cloud transmittance, Z (m), half or 32 bit floats, ZIP compression, and camera, lens, sun, time,
// document hash and program version as attributes (exr_attributes.h). Halves beyond +-65504 are clamped to
// it; Z is always 32 bit, infinite for sky. Throws Error if the frame holds not
// what the format needs, or the encoder fails.
EncodedFrame encode(const Frame& frame, const Encoding& encoding, std::size_t front = 0);

// "image/jpeg", "image/png", "image/x-exr"
const char* media_type(ImageFormat format);

}  // namespace cloudscape::encode
