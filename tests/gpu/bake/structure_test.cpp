// The structure encloses whatever the march can find in the shape texture, with its padding, and not much more.
#include "bake/structure.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include "fixture.h"

namespace cloudscape::bake {
namespace {

constexpr std::array<double, 3> weights{0.9, 0.5, 0.3};

// The shape texture as the device interpolates it, and then mixes the channels; coordinates in tiles.
class Shape {
 public:
  explicit Shape(const BakedTexels& texels) : texels_(texels), side_(texels.recipe.resolution) {}
  double at(double x, double y, double z) const {
    std::array<double, 4> noise{};
    const double u = x * side_ - 0.5, v = y * side_ - 0.5, w = z * side_ - 0.5;
    for (int corner = 0; corner < 8; ++corner) {
      const int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
      const double weight = share(u, i) * share(v, j) * share(w, k);
      for (std::size_t channel = 0; channel < 4; ++channel) noise[channel] += weight * texel(u, v, w, i, j, k, channel);
    }
    double fine = 1;
    for (std::size_t i = 0; i < 3; ++i) fine += weights[i] * (noise[i + 1] - 0.5);
    return noise[0] * fine;
  }

 private:
  static double share(double at, int upper) {
    const double fraction = at - std::floor(at);
    return upper != 0 ? fraction : 1 - fraction;
  }
  double texel(double u, double v, double w, int i, int j, int k, std::size_t channel) const {
    const auto wrapped = [&](double at, int upper) {
      return static_cast<std::size_t>((static_cast<int>(std::floor(at)) + upper + side_) % side_);
    };
    const auto side = static_cast<std::size_t>(side_);
    const std::size_t index = (wrapped(w, k) * side + wrapped(v, j)) * side + wrapped(u, i);
    return texels_.shape[4 * index + channel] / 255.0;
  }
  const BakedTexels& texels_;
  int side_;
};

struct Cells {
  std::vector<glm::vec2> values;
  glm::ivec3 size;
  // With all of the padding, or without its outer layer.
  float at(const glm::ivec3& cell, int padding = structure_padding) const {
    const glm::ivec3 wrapped = (cell + size) % size;
    const glm::vec2 value = values[static_cast<std::size_t>((wrapped.z * size.y + wrapped.y) * size.x + wrapped.x)];
    return padding == structure_padding ? value.x : value.y;
  }
};

class Structure : public BakeTest {
 protected:
  Cells built(const BakedCloudscape& baked) {
    const gpu::Texture& texture = builder_.of(baked, weights);
    const std::vector<std::uint8_t> bytes = texture.download();
    Cells cells{std::vector<glm::vec2>(bytes.size() / sizeof(glm::vec2)), baked.structure_size()};
    std::memcpy(cells.values.data(), bytes.data(), bytes.size());
    return cells;
  }
  StructureBuilder builder_{shaders_};
};

TEST_F(Structure, IsAtLeastWhatCanBeFoundWithinItsPadding) {
  const BakedTexels texels = bake(small_recipe());
  const BakedCloudscape baked(texels);
  const Cells cells = built(baked);
  const Shape shape(texels);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const int padding : {structure_padding, structure_padding - 1}) {
    const auto offset = [&] { return static_cast<int>(random() % (2 * padding + 1)) - padding; };
    int close = 0;
    for (int i = 0; i < 200000; ++i) {
      const glm::dvec3 point(unit(random), unit(random), unit(random));
      const glm::ivec3 own = glm::ivec3(point * glm::dvec3(cells.size));
      const glm::ivec3 cell = own + glm::ivec3(offset(), offset(), offset());
      if (cell.z < 0 || cell.z >= cells.size.z) continue;
      const double found = shape.at(point.x, point.y, point.z);
      ASSERT_GE(cells.at(cell, padding), found - 1e-5) << "cell " << cell.x << " " << cell.y << " " << cell.z;
      if (found > 0.7 * cells.at(cell, padding)) ++close;
    }
    EXPECT_GT(close, 100) << "a bound that nothing comes near encloses air";
  }
}

TEST_F(Structure, OfOneCloudIsTheCloudAndItsPadding) {
  BakeRecipe recipe = small_recipe();
  recipe.height_over_width = 1;
  const auto texel_count = static_cast<std::size_t>(recipe.resolution) * recipe.resolution * recipe.resolution;
  BakedTexels texels{recipe, std::vector<std::uint8_t>(4 * texel_count), std::vector<std::uint8_t>(4 * texel_count),
                     std::vector<std::uint8_t>(8 * variation_resolution * variation_resolution)};
  const auto texel = [&](int x, int y, int z) { return static_cast<std::size_t>(4 * ((z * 16 + y) * 16 + x)); };
  for (std::size_t i = 0; i < 4; ++i) texels.shape[texel(1, 8, 6) + i] = 255;
  const Cells cells = built(BakedCloudscape(texels));
  // Interpolation carries the texel into the neighbouring cells; then come the layers of padding.
  for (int z = 0; z < 16; ++z) {
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 16; ++x) {
        const int across = std::min((x - 1 + 16) % 16, (1 - x + 16) % 16);
        for (const int padding : {structure_padding, structure_padding - 1}) {
          const int reach = 1 + padding;
          const bool enclosed = across <= reach && std::abs(y - 8) <= reach && std::abs(z - 6) <= reach;
          ASSERT_EQ(cells.at({x, y, z}, padding) > 0, enclosed) << x << " " << y << " " << z;
        }
      }
    }
  }
}

TEST_F(Structure, IsBuiltOnceForEachOfTheLastFewWeights) {
  const BakedCloudscape baked(bake(small_recipe()));
  const gpu::Texture* first = &builder_.of(baked, weights);
  const gpu::Texture* second = &builder_.of(baked, {0, 0, 0});
  EXPECT_NE(first, second);
  EXPECT_EQ(&builder_.of(baked, weights), first);
  EXPECT_EQ(&builder_.of(baked, {0, 0, 0}), second);
}

}  // namespace
}  // namespace cloudscape::bake
