// How a moving picture is put together from a part of its pixels: the sizes, which pixels are marched in a frame, and
// the block of the passes that continue the picture before it.
#pragma once
#include <cstdint>
#include <optional>

#include "render/block_values.h"

namespace cloudscape::render {

// Whether the frame continues its stream's last picture.
bool continues_picture(const FrameRequest& request);

struct ResolvePlan {
  ImageSize shown;          // the picture that was asked for
  int divisor = 1;          // of the kept picture's resolution
  int stride = 1;           // between the marched pixels of the kept picture
  ImageSize kept, marched;  // kept: whole blocks of stride by stride pixels, with the shown picture in its middle
  glm::dvec2 margin_px{0};  // of the kept picture to the left of and above the shown one
};
ResolvePlan resolve_plan(const FrameRequest& request);
std::optional<Enlargement> enlargement_of(const ResolvePlan& plan);  // of the kept picture

// Which pixel of each block is marched in a frame: each once in stride * stride frames, and at any time those of the
// last frames lie evenly in the block (Bayer 1973's order of a dither matrix).
glm::ivec2 marched_pixel(int stride, std::uint64_t frame);

// The frame that marches one pixel of each block: its pixels are the blocks.
FrameRequest marched_request(const FrameRequest& asked, const ResolvePlan& plan);
// The frame of all kept pixels, of which those are marched that are newly seen.
FrameRequest newly_seen_request(const FrameRequest& asked, const ResolvePlan& plan);
// Offset of its rays, in its pixels, from the middles of the blocks. While the view rests each pixel's move about
// within it, so that its average has smooth edges; what moves shows each of them for too short a time.
glm::dvec2 marched_offset(const ResolvePlan& plan, std::uint64_t frame, bool resting);
// Index of the frame's sample in the averages, which places what is random along a ray: even over the frames of a
// pixel, and different in the pixels of a block.
int marched_sample(const ResolvePlan& plan, std::uint64_t frame);

// What a kept picture shows.
struct KeptView {
  CameraPose pose;
  double vertical_fov_deg = 0, aspect = 1;  // of the kept picture
  double time_s = 0;
  std::shared_ptr<const Cloudscape> cloudscape;
};
KeptView kept_view(const FrameRequest& asked, const ResolvePlan& plan);
double half_height_of(double vertical_fov_deg);               // where the distance is 1
bool same_clouds(const Cloudscape& a, const Cloudscape& b);   // be it in another light
double moved_m(const KeptView& now, const KeptView& before);  // against the clouds
// `before`: nullopt if there is none that this one could continue. `resting`: whether that showed the same.
ResolveBlock resolve_block(const ResolvePlan& plan, std::uint64_t frame, const KeptView& now,
                           const std::optional<KeptView>& before, bool resting);

}  // namespace cloudscape::render
