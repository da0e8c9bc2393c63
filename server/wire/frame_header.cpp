// The binary header in front of each frame, byte for byte.
#include <bit>
#include <cmath>
#include <concepts>
#include <cstring>

#include "core/error.h"
#include "wire/messages.h"

namespace cloudscape::wire {
namespace {

template <std::size_t bytes>
using Bits = std::conditional_t<
    bytes == 1, std::uint8_t,
    std::conditional_t<bytes == 2, std::uint16_t, std::conditional_t<bytes == 4, std::uint32_t, std::uint64_t>>>;

// Visits the fields in the order of the bytes.
void each_field(auto& header, auto&& visit) {
  visit(header.version), visit(header.quality_stage), visit(header.image_format), visit(header.lens_kind);
  visit(header.frame_id), visit(header.pose_sequence);
  visit(header.width_px), visit(header.height_px), visit(header.vertical_fov_deg);
  for (auto& component : header.position_m) visit(component);
  visit(header.azimuth_deg), visit(header.elevation_deg), visit(header.roll_deg), visit(header.time_s);
  visit(header.render_ms), visit(header.encode_ms), visit(header.image_bytes);
}

template <class T>
void put(T value, std::uint8_t*& at) {
  const auto bits = std::bit_cast<Bits<sizeof(T)>>(value);
  for (std::size_t i = 0; i < sizeof(T); ++i) *at++ = static_cast<std::uint8_t>(bits >> (8 * i));
}

template <class T>
void get(T& value, const std::uint8_t*& at) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) bits |= std::uint64_t{*at++} << (8 * i);
  value = std::bit_cast<T>(static_cast<Bits<sizeof(T)>>(bits));
}

void check(const FrameHeader& header, std::size_t message_bytes) {
  bool finite = true;
  each_field(header, [&](auto field) {
    if constexpr (std::floating_point<decltype(field)>) finite = finite && std::isfinite(field);
  });
  if (!finite) throw Error("the frame's header holds a number that is not finite");
  if (header.image_format >= EnumNames<ImageFormat>::names.size())
    throw Error("the frame has image format " + std::to_string(header.image_format) + ", which is unknown");
  if (header.lens_kind >= EnumNames<LensKind>::names.size())
    throw Error("the frame has lens " + std::to_string(header.lens_kind) + ", which is unknown");
  if (frame_header_bytes + header.image_bytes != message_bytes)
    throw Error("the frame has " + std::to_string(message_bytes - frame_header_bytes) +
                " bytes of image, its header says " + std::to_string(header.image_bytes));
}

}  // namespace

FrameHeader frame_header(const Frame& frame, std::uint32_t frame_id, std::uint64_t pose_sequence,
                         std::uint8_t quality_stage, double encode_ms, std::size_t image_bytes) {
  const FrameRequest& request = frame.request;
  const CameraPose& pose = request.pose;
  FrameHeader header;
  header.quality_stage = quality_stage;
  header.lens_kind = static_cast<std::uint8_t>(request.lens.kind);
  header.frame_id = frame_id;
  header.pose_sequence = pose_sequence;
  header.width_px = static_cast<std::uint16_t>(request.size_px.width);
  header.height_px = static_cast<std::uint16_t>(request.size_px.height);
  header.vertical_fov_deg = static_cast<float>(request.lens.vertical_fov_deg);
  for (int i = 0; i < 3; ++i) header.position_m[i] = pose.position_m[i];
  header.azimuth_deg = pose.azimuth_deg;
  header.elevation_deg = pose.elevation_deg;
  header.roll_deg = pose.roll_deg;
  header.time_s = request.time_s;
  header.render_ms = static_cast<float>(frame.timings.render_ms);
  header.encode_ms = static_cast<float>(encode_ms);
  header.image_bytes = static_cast<std::uint32_t>(image_bytes);
  return header;
}

void write(const FrameHeader& header, std::span<std::uint8_t, frame_header_bytes> out) {
  std::uint8_t* at = out.data();
  each_field(header, [&](auto field) { put(field, at); });
}

FrameHeader read_frame_header(std::span<const std::uint8_t> message) {
  if (message.size() < frame_header_bytes)
    throw Error("the frame has " + std::to_string(message.size()) + " bytes: its header alone has " +
                std::to_string(frame_header_bytes));
  FrameHeader header;
  const std::uint8_t* at = message.data();
  each_field(header, [&](auto& field) { get(field, at); });
  if (header.version != FrameHeader{}.version)
    throw Error("the frame is of version " + std::to_string(header.version) + " of the protocol: must be " +
                std::to_string(FrameHeader{}.version));
  check(header, message.size());
  return header;
}

}  // namespace cloudscape::wire
