// Path-traced references, kept as EXR so that each is rendered once.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "core/frame.h"

namespace cloudscape::bench {

// The request of the view's reference: linear radiance, `samples` paths a pixel.
FrameRequest reference_request(const FrameRequest& view, const ImageSize& size_px, int samples, std::uint32_t seed);

// A name for all that the reference's pixels depend on: 64 hexadecimal characters. How the picture is displayed and
// which light model its document names is not in it, since the tracer asks for neither.
std::string reference_key(const FrameRequest& reference);

class KeptReferences {
 public:
  explicit KeptReferences(std::filesystem::path folder) : folder_(std::move(folder)) {}  // made when first needed
  std::filesystem::path path_of(const FrameRequest& reference) const;
  std::optional<Frame> load(const FrameRequest& reference) const;  // nullopt: not there. Throws Error: damaged.
  void store(const Frame& frame) const;                            // throws Error

 private:
  std::filesystem::path folder_;
};

}  // namespace cloudscape::bench
