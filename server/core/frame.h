// A picture that is asked for, the picture itself, and the picture as bytes. A still is only a request with another
// quality.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/cloudscape.h"
#include "core/quality.h"
#include "core/tracing.h"

namespace cloudscape {

using StreamId = std::uint64_t;  // a viewer's stream, or one still; never used twice in a process

struct ImageSize {
  int width = 640;
  int height = 360;
  bool operator==(const ImageSize&) const = default;
};

// display: 8 bit sRGB, tone-mapped. radiance: linear, with alpha and depth.
enum class FrameContent { display, radiance };

struct FrameRequest {
  std::shared_ptr<const Cloudscape> cloudscape;
  CameraPose pose;
  Lens lens;
  Display display;
  March march;
  ImageSize size_px;
  RenderQuality quality;
  double time_s = 0.0;
  FrameContent content = FrameContent::display;
  StreamId stream = 0;
  std::uint64_t sequence = 0;  // of the frame in its stream
  int first_sample = 0;        // 0 starts anew; n continues the average that the stream's frames before have built
  bool light_may_lag = false;  // a moving picture may show the clouds in the light of a moment ago
  Tracing tracing;             // where the quality's technique is path tracing
  double sample_share = 1;     // side of what a pixel's sample stands for, in pixels
  bool time_passes = false;    // FrameTimings::passes is filled, at the cost of waiting for each
};

struct PassTime {
  std::string name;
  double ms = 0;      // of the device; wall time where that is the processor
  double cpu_ms = 0;  // of all threads of the process; 0 with a GPU
};

struct FrameTimings {
  double queue_ms = 0;
  double render_ms = 0;  // wall time of the render thread
  double gpu_ms = 0;     // by timer queries; 0 where the driver has none
  double readback_ms = 0;
  std::vector<PassTime> passes = {};  // in their order; empty unless the request asks for them
};

// How a picture that was rendered small is shown.
struct Enlargement {
  ImageSize from_px;
  int factor = 1;           // shown pixels of a rendered one, across and down
  glm::dvec2 margin_px{0};  // of the small picture to the left of and above what is shown
};

struct Frame {
  FrameRequest request;
  int samples = 0;                         // that the picture averages, earlier frames' included
  std::vector<std::uint8_t> display_rgba;  // width * height * 4, top row first; empty for radiance
  std::vector<float> radiance_rgba;        // linear; A = 1 - cloud transmittance; empty for display
  std::vector<float> depth_m;              // along the ray to cloud or ground, infinity for sky; empty for display
  FrameTimings timings;
  std::vector<float> standard_error_rgb;        // of the radiance, as the mean of its samples; empty unless path-traced
  std::optional<Enlargement> enlargement = {};  // display_rgba is of its size still: core/enlarge.h
};

enum class ImageFormat { jpeg, png, exr };
template <>
struct EnumNames<ImageFormat> {
  static constexpr std::array<std::string_view, 3> names{"jpeg", "png", "exr"};
};
enum class ChromaSubsampling { half, none };  // 4:2:0, 4:4:4
enum class ExrType { half, float32 };
template <>
struct EnumNames<ExrType> {
  static constexpr std::array<std::string_view, 2> names{"half", "float"};
};

struct Encoding {
  ImageFormat format = ImageFormat::jpeg;
  int jpeg_quality = 90;  // 1..100
  ChromaSubsampling chroma = ChromaSubsampling::none;
  ExrType exr_type = ExrType::half;
  bool operator==(const Encoding&) const = default;
};

// Bytes ready to send. The first `front` bytes are room for headers in front of the image, which is what follows.
struct EncodedFrame {
  std::vector<std::uint8_t> bytes;
  std::size_t front = 0;
  ImageFormat format = ImageFormat::jpeg;
  double encode_ms = 0;
};

}  // namespace cloudscape
