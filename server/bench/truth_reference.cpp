#include "bench/truth_reference.h"

#include "core/content_hash.h"
#include "core/version.h"
#include "encode/encode.h"
#include "encode/exr_reader.h"
#include "settings/text_file.h"

namespace cloudscape::bench {
namespace {

// To be raised when the path tracer's pictures change for another reason than their noise.
constexpr int tracer_revision = 2;

struct ReferenceKey {
  Cloudscape cloudscape;
  CameraPose pose;
  Lens lens;
  March march;
  Tracing tracing;
  int width = 0, height = 0, samples = 0, revision = tracer_revision;
  double time_s = 0;
  std::string program_version = version;

  static void fields(auto& self, auto&& visit) {
    visit("cloudscape", self.cloudscape, Limits{}, "");
    visit("pose", self.pose, Limits{}, "");
    visit("lens", self.lens, Limits{}, "");
    visit("march", self.march, Limits{}, "");
    visit("tracing", self.tracing, Limits{}, "");
    visit("width", self.width, Limits{}, "");
    visit("height", self.height, Limits{}, "");
    visit("samples", self.samples, Limits{}, "");
    visit("revision", self.revision, Limits{}, "");
    visit("time_s", self.time_s, Limits{}, "");
    visit("program_version", self.program_version, Limits{}, "");
  }
};

}  // namespace

FrameRequest reference_request(const FrameRequest& view, const ImageSize& size_px, int samples, std::uint32_t seed) {
  FrameRequest request = view;
  request.size_px = size_px;
  request.quality = render_quality(Quality::reference);
  request.quality.samples = samples;
  request.tracing = Tracing{};
  request.tracing.seed = seed;
  request.content = FrameContent::radiance;
  return request;
}

std::string reference_key(const FrameRequest& reference) {
  ReferenceKey key{*reference.cloudscape, reference.pose,          reference.lens,           reference.march,
                   reference.tracing,     reference.size_px.width, reference.size_px.height, reference.quality.samples};
  key.time_s = reference.time_s;
  key.cloudscape.view = View{};
  key.cloudscape.title = key.cloudscape.description = "";
  key.cloudscape.medium.light_model = LightModel{};
  return content_hash(key);
}

std::filesystem::path KeptReferences::path_of(const FrameRequest& reference) const {
  return folder_ / (reference_key(reference) + ".exr");
}

std::optional<Frame> KeptReferences::load(const FrameRequest& reference) const {
  const std::filesystem::path path = path_of(reference);
  if (!std::filesystem::exists(path)) return std::nullopt;
  Frame frame = encode::read_exr(path, reference.size_px);
  frame.request = reference;
  frame.samples = reference.quality.samples;
  return frame;
}

void KeptReferences::store(const Frame& frame) const {
  std::filesystem::create_directories(folder_);
  Encoding encoding;
  encoding.format = ImageFormat::exr;
  encoding.exr_type = ExrType::float32;
  settings::write_whole_file(path_of(frame.request), encode::encode(frame, encoding).bytes);
}

}  // namespace cloudscape::bench
