#include "bake/light_cache.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

namespace cloudscape::bake {
namespace {

constexpr std::string_view magic = "cloudscape light 1\n";

// Radiance is kept in 16 bits, in units of a power of two that the brightest texel is below.
float unit_of(const std::vector<glm::vec4>& mean) {
  float brightest = 1e-30F;
  for (const glm::vec4& texel : mean) brightest = std::max({brightest, texel.x, texel.y, texel.z});
  return std::exp2(std::ceil(std::log2(brightest)));
}

std::uint64_t packed(const glm::vec4& texel, float unit) {
  return glm::packHalf4x16(glm::vec4(glm::vec3(texel) / unit, texel.w));
}
glm::vec4 unpacked(std::uint64_t bits, float unit) {
  const glm::vec4 texel = glm::unpackHalf4x16(bits);
  return {glm::vec3(texel) * unit, texel.w};
}

void append(std::string& payload, const auto& value) {
  payload.append(reinterpret_cast<const char*>(&value), sizeof value);
}
template <class T>
T taken(std::string_view& payload) {
  T value;
  std::memcpy(&value, payload.data(), sizeof value);
  payload.remove_prefix(sizeof value);
  return value;
}

}  // namespace

LightTexels light_texels(const std::vector<InScatterSolution>& levels) {
  LightTexels light;
  for (const InScatterSolution& level : levels)
    for (std::size_t i = 0; i < level.light.size(); ++i) {
      const Moments& at = level.light[i];
      light.mean.emplace_back(at.even[0], at.even[1], at.even[2], level.beam[i]);
      const float scale = 1 / std::max(1e-20F, luminance(at.even));
      light.directed.emplace_back(scale * luminance(at.east), scale * luminance(at.north), scale * luminance(at.up), 0);
    }
  const float unit = unit_of(light.mean);
  for (glm::vec4& texel : light.mean) texel = unpacked(packed(texel, unit), unit);
  for (glm::vec4& texel : light.directed) texel = unpacked(packed(texel, 1), 1);
  return light;
}

std::optional<LightTexels> LightCache::load(const std::string& key, std::size_t texels) const {
  std::optional<LightTexels> light;
  files_.load(key + ".light", magic, [&](std::string_view payload) {
    if (payload.size() != sizeof(float) + 2 * texels * sizeof(std::uint64_t)) return false;
    const auto unit = taken<float>(payload);
    light.emplace();
    for (std::size_t i = 0; i < texels; ++i) light->mean.push_back(unpacked(taken<std::uint64_t>(payload), unit));
    for (std::size_t i = 0; i < texels; ++i) light->directed.push_back(unpacked(taken<std::uint64_t>(payload), 1));
    return true;
  });
  return light;
}

void LightCache::store(const std::string& key, const LightTexels& light) const {
  const float unit = unit_of(light.mean);
  std::string payload;
  append(payload, unit);
  for (const glm::vec4& texel : light.mean) append(payload, packed(texel, unit));
  for (const glm::vec4& texel : light.directed) append(payload, packed(texel, 1));
  files_.store(key + ".light", magic, payload);
}

}  // namespace cloudscape::bake
