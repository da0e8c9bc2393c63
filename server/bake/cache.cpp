#include "bake/cache.h"

#include <string>

namespace cloudscape::bake {
namespace {

constexpr std::string_view magic = "cloudscape bake 1\n";

std::size_t cube(int side, std::size_t texel_bytes) {
  return static_cast<std::size_t>(side) * side * side * texel_bytes;
}

std::string payload_of(const BakedTexels& texels) {
  std::string payload(texels.shape.begin(), texels.shape.end());
  payload.append(texels.detail.begin(), texels.detail.end());
  payload.append(texels.variation.begin(), texels.variation.end());
  return payload;
}

// Empty if the payload has not the size that the recipe asks for.
std::optional<BakedTexels> texels_of(const BakeRecipe& recipe, std::string_view payload) {
  const std::size_t shape = cube(recipe.resolution, static_cast<std::size_t>(bytes_per_texel(recipe.format)));
  const std::size_t detail = cube(recipe.detail_resolution, 4);
  const std::size_t variation = static_cast<std::size_t>(variation_resolution) * variation_resolution * 8;
  if (payload.size() != shape + detail + variation) return std::nullopt;
  const auto part = [&](std::size_t begin, std::size_t size) {
    return std::vector<std::uint8_t>(payload.begin() + static_cast<std::ptrdiff_t>(begin),
                                     payload.begin() + static_cast<std::ptrdiff_t>(begin + size));
  };
  return BakedTexels{recipe, part(0, shape), part(shape, detail), part(shape + detail, variation)};
}

std::string name_of(const BakeRecipe& recipe) { return bake_key(recipe) + ".bake"; }

}  // namespace

std::filesystem::path BakeCache::path_of(const BakeRecipe& recipe) const { return files_.path_of(name_of(recipe)); }

std::optional<BakedTexels> BakeCache::load(const BakeRecipe& recipe) const {
  std::optional<BakedTexels> texels;
  files_.load(name_of(recipe), magic, [&](std::string_view payload) {
    texels = texels_of(recipe, payload);
    return texels.has_value();
  });
  return texels;
}

void BakeCache::store(const BakedTexels& texels) const {
  files_.store(name_of(texels.recipe), magic, payload_of(texels));
}

}  // namespace cloudscape::bake
