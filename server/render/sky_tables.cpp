#include "render/sky_tables.h"

#include <algorithm>

namespace cloudscape::render {
namespace {

using gpu::Binding, gpu::Format, gpu::Texture;

constexpr std::size_t most_sets = 8;  // tuned: streams of one sky share a set only while their cameras are equally high

Texture table(Format format, int width, int height, const char* label) {
  Texture texture(format, width, height, label);
  texture.sample_with(gpu::Filter::linear, gpu::Wrap::clamp);
  return texture;
}

template <class... Values>
std::string bytes_of(const Values&... values) {
  std::string bytes;
  (bytes.append(reinterpret_cast<const char*>(&values), sizeof values), ...);
  return bytes;
}

std::string key_of(const FrameBlock& frame, const CloudBlock& cloud) {
  return bytes_of(frame.camera_forward.w, frame.sun_direction, frame.sun_irradiance, frame.sky, frame.atmosphere,
                  frame.ground_albedo, frame.ground.x, cloud.layer.x, cloud.layer.y);
}

}  // namespace

SkyTables::SkyTables(const gpu::Context& context, gpu::ShaderLibrary& shaders)
    : transmittance_(context, shaders, "render/sky_transmittance.glsl", {Format::rgba16f}),
      view_(context, shaders, "render/sky_view.glsl", {Format::rgba16f}),
      light_(context, shaders, "render/sky_light.glsl", {Format::rgba32f}) {}

const SkyTables::Set& SkyTables::get(const FrameBlock& frame, const CloudBlock& cloud) {
  const std::string key = key_of(frame, cloud);
  auto found = std::find_if(sets_.begin(), sets_.end(), [&](const Set& set) { return set.key == key; });
  if (found == sets_.end()) {
    if (sets_.size() < most_sets) {
      sets_.push_back({"", table(Format::rgba16f, 64, 64, "sky transmittance"),
                       table(Format::rgba16f, 96, 96, "sky view"), table(Format::rgba32f, 6, 1, "sky light")});
    }
    found = std::prev(sets_.end());
    found->key = key;
    compute(*found);
  }
  sets_.splice(sets_.begin(), sets_, found);
  return sets_.front();
}

void SkyTables::compute(Set& set) const {
  const Binding tables[] = {{8, &set.transmittance}, {9, &set.view}};
  const Texture* transmittance[] = {&set.transmittance};
  const Texture* view[] = {&set.view};
  const Texture* light[] = {&set.light};
  transmittance_.run({0, 0, 64, 64}, transmittance, {});
  view_.run({0, 0, 96, 96}, view, std::span(tables).first(1));
  light_.run({0, 0, 6, 1}, light, tables);
}

void SkyTables::reload(gpu::ShaderLibrary& shaders) {
  for (gpu::ScreenPass* pass : {&transmittance_, &view_, &light_}) pass->reload(shaders);
  sets_.clear();
}

}  // namespace cloudscape::render
