#include "render/terrain_stage.h"

#include <algorithm>

#include "render/block_values.h"

namespace cloudscape::render {
namespace {

using gpu::Binding, gpu::Format, gpu::Texture;

constexpr std::size_t most_shadows = 8;  // tuned: streams that look at one terrain under suns of their own
// tuned: about 40 ms on two cores, so that a frame rendered in between is not late.
constexpr int points_per_slice = 1 << 17;

std::shared_ptr<Texture> shadow_map(int side) {
  auto texture = std::make_shared<Texture>(Format::r32f, side, side, "terrain shadows");
  texture->sample_with(gpu::Filter::linear, gpu::Wrap::repeat);
  return texture;
}

}  // namespace

TerrainStage::TerrainStage(const gpu::Context& context, gpu::ShaderLibrary& shaders, std::filesystem::path height_maps)
    : store_(context, shaders, std::move(height_maps)),
      shadows_pass_(context, shaders, "render/terrain_sun.glsl", {Format::r32f}),
      block_("terrain") {}

bool TerrainStage::prepare(const FrameRequest& request, Land& land) {
  if (request.cloudscape->ground.kind != GroundKind::terrain || land.sun) return true;
  if (!land.terrain) {
    const bake::TerrainRecipe recipe = store_.recipe_of(*request.cloudscape);
    land.terrain = store_.find(recipe);
    if (!land.terrain) store_.advance(recipe);
    return false;
  }
  return cast_shadows(request, land);
}

bool TerrainStage::cast_shadows(const FrameRequest& request, Land& land) {
  const std::string key = bake::terrain_key(land.terrain->recipe()) + " " +
                          std::to_string(light_azimuth_deg(*request.cloudscape)) + " " +
                          std::to_string(request.cloudscape->ground.water.level_m.value_or(-1));
  auto found = std::ranges::find(shadows_, key, &Shadows::key);
  if (found == shadows_.end()) {
    if (shadows_.size() >= most_shadows) shadows_.pop_back();
    shadows_.push_front({key, shadow_map(land.terrain->recipe().resolution)});
    found = shadows_.begin();
  }
  shadows_.splice(shadows_.begin(), shadows_, found);
  const int side = found->texture->width();
  if (found->next_row < side) {
    block_.upload(terrain_block(request, *land.terrain));
    block_.bind();
    const Binding heights[] = {{11, &land.terrain->heights()}};
    const Texture* target[] = {found->texture.get()};
    const int rows = std::max(1, points_per_slice / side);
    shadows_pass_.run({0, found->next_row, side, rows}, target, heights);
    found->next_row += rows;
  }
  if (found->next_row < side) return false;
  land.sun = found->texture;
  return true;
}

std::vector<Binding> TerrainStage::bind(const FrameRequest& request, const Land& land) {
  block_.upload(land.terrain ? terrain_block(request, *land.terrain) : TerrainBlock{});
  block_.bind();
  if (!land.terrain) return {};
  return {{11, &land.terrain->heights()}, {12, &land.terrain->surface()}, {13, land.sun.get()}};
}

void TerrainStage::reload(gpu::ShaderLibrary& shaders) {
  store_.reload(shaders);
  shadows_pass_.reload(shaders);
  shadows_.clear();
}

}  // namespace cloudscape::render
