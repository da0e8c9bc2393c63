#include "bake/terrain.h"

#include <algorithm>
#include <chrono>
#include <cstring>

#include "bake/height_map.h"
#include "core/beside_frames.h"

namespace cloudscape::bake {
namespace {

using gpu::Filter, gpu::Format, gpu::Texture, gpu::Wrap;

constexpr std::string_view magic = "cloudscape relief 1\n";

// tuned: about 50 ms on two cores, so that a frame rendered in between is not late.
constexpr int points_per_slice = 1 << 16;

template <class T>
std::span<const std::uint8_t> bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T)};
}

Texture heights_texture(const TerrainTexels& texels) {
  const int side = texels.recipe.resolution;
  Texture texture(Format::rg32f, side, side, "terrain heights", static_cast<int>(texels.heights.size()));
  texture.sample_with(Filter::nearest, Wrap::repeat);
  for (std::size_t level = 0; level < texels.heights.size(); ++level)
    texture.upload_level(static_cast<int>(level), bytes_of(texels.heights[level]));
  return texture;
}

Texture surface_texture(const TerrainTexels& texels) {
  const int side = texels.recipe.resolution;
  Texture texture(Format::rgba16f, side, side, "terrain surface", static_cast<int>(texels.heights.size()));
  texture.sample_with(Filter::linear, Wrap::repeat);
  texture.upload(bytes_of(texels.surface));
  texture.make_levels();
  return texture;
}

std::vector<float> points_of(const std::vector<float>& interleaved) {
  std::vector<float> points(interleaved.size() / 2);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = interleaved[2 * i];
  return points;
}

std::string noise_name(const TerrainRecipe& recipe) { return terrain_key(recipe) + ".relief"; }

TerrainBakeBlock block_of(const TerrainRecipe& recipe) {
  TerrainBakeBlock block;
  block.noise = {recipe.cells, recipe.octaves, recipe.resolution, 0};
  block.shape = {recipe.roughness, recipe.erosion, 0, 0};
  block.seed = {recipe.seed, 0, 0, 0};
  return block;
}

std::vector<float> floats_of(std::string_view bytes) {
  std::vector<float> values(bytes.size() / sizeof(float));
  std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

}  // namespace

BakedTerrain::BakedTerrain(const TerrainTexels& texels)
    : recipe_(texels.recipe),
      heights_(heights_texture(texels)),
      surface_(surface_texture(texels)),
      points_m_(points_of(texels.heights[0])),
      lowest_m_(texels.lowest_m),
      highest_m_(texels.highest_m) {}

TerrainJob::TerrainJob(const gpu::ScreenPass& noise, TerrainRecipe recipe, std::filesystem::path folder,
                       KeptFiles files)
    : noise_(noise), recipe_(std::move(recipe)), files_(std::move(files)), block_("terrain bake") {
  if (recipe_.height_map.empty()) {
    files_.has(noise_name(recipe_)) ? load_noise() : begin_noise();
    return;
  }
  next_row_ = recipe_.resolution;
  texels_ = beside_frames([recipe = recipe_, folder = std::move(folder)] {
    const HeightMap map = read_height_map(folder, recipe.height_map);
    return std::optional(terrain_texels(recipe, resampled(map, recipe.resolution)));
  });
}

void TerrainJob::begin_noise() {
  next_row_ = 0;
  heights_ = Texture(Format::r32f, recipe_.resolution, recipe_.resolution, "terrain being baked");
  block_.upload(block_of(recipe_));
}

void TerrainJob::load_noise() {
  next_row_ = recipe_.resolution;
  texels_ = beside_frames([recipe = recipe_, files = files_] {
    std::optional<TerrainTexels> texels;
    files.load(noise_name(recipe), magic, [&](std::string_view payload) {
      if (payload.size() != sizeof(float) * recipe.resolution * recipe.resolution) return false;
      texels = terrain_texels(recipe, floats_of(payload));
      return true;
    });
    return texels;
  });
}

void TerrainJob::bake_rows() {
  const int rows = std::clamp(points_per_slice / recipe_.resolution, 8, recipe_.resolution - next_row_);
  const Texture* targets[] = {&heights_};
  block_.bind();
  noise_.run({0, next_row_, recipe_.resolution, rows}, targets, {});
  next_row_ += rows;
  if (next_row_ < recipe_.resolution) return;
  texels_ = beside_frames([recipe = recipe_, files = files_, noise = heights_.download()] {
    const std::string_view bytes(reinterpret_cast<const char*>(noise.data()), noise.size());
    files.store(noise_name(recipe), magic, bytes);
    return std::optional(terrain_texels(recipe, floats_of(bytes)));
  });
}

bool TerrainJob::advance() {
  if (next_row_ < recipe_.resolution) {
    bake_rows();
    return false;
  }
  constexpr auto patience = std::chrono::milliseconds(1);  // the clouds may have something to do
  if (texels_.wait_for(patience) != std::future_status::ready) return false;
  const std::optional<TerrainTexels> texels = texels_.get();
  if (!texels) return begin_noise(), false;
  baked_ = std::make_shared<const BakedTerrain>(*texels);
  return true;
}

double TerrainJob::progress() const {
  return baked_ ? 1.0 : 0.8 * next_row_ / recipe_.resolution;  // tuned: the levels take about a fifth
}

std::shared_ptr<const BakedTerrain> TerrainJob::take() { return std::move(baked_); }

}  // namespace cloudscape::bake
