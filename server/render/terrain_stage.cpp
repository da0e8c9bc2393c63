#include "render/terrain_stage.h"

#include <algorithm>
#include <chrono>

#include "bake/terrain_horizon.h"
#include "core/beside_frames.h"
#include "render/block_values.h"

namespace cloudscape::render {
namespace {

using gpu::Binding, gpu::Format, gpu::Texture;

constexpr std::size_t most_shadows = 8;  // tuned: streams that look at one terrain under suns of their own
constexpr auto patience = std::chrono::milliseconds(1);  // the clouds may have something to do

std::shared_ptr<Texture> shadow_map(int side, const std::vector<float>& tangents) {
  auto texture = std::make_shared<Texture>(Format::r32f, side, side, "terrain shadows");
  texture->sample_with(gpu::Filter::linear, gpu::Wrap::repeat);
  texture->upload({reinterpret_cast<const std::uint8_t*>(tangents.data()), tangents.size() * sizeof(float)});
  return texture;
}

}  // namespace

TerrainStage::TerrainStage(const gpu::Context& context, gpu::ShaderLibrary& shaders, std::filesystem::path height_maps,
                           const bake::KeptFiles& files)
    : store_(context, shaders, std::move(height_maps), files), block_("terrain") {}

TerrainStage::~TerrainStage() {
  for (Shadows& each : shadows_) each.stop.request_stop();
}

bool TerrainStage::prepare(const FrameRequest& request, Land& land) {
  if (request.cloudscape->ground.kind != GroundKind::terrain || land.sun) return true;
  if (!land.terrain) {
    const bake::TerrainRecipe recipe = store_.recipe_of(*request.cloudscape);
    land.terrain = store_.find(recipe);
    if (!land.terrain) {
      store_.advance(recipe);
      return false;
    }
  }
  return cast_shadows(request, land);
}

// On a thread of its own: a tenth of a second for 1024^2 points.
TerrainStage::Shadows TerrainStage::begin_shadows(const FrameRequest& request, const Land& land,
                                                  std::string terrain) const {
  const double azimuth_deg = light_azimuth_deg(*request.cloudscape);
  const TerrainBlock block = terrain_block(request, *land.terrain);
  Shadows shadows{std::move(terrain), azimuth_deg, {}, {}, nullptr};
  shadows.tangents = beside_frames(
      [baked = land.terrain, block, stop = shadows.stop.get_token()] {
        return bake::horizon_tangents({baked->points_m(), block.size.x, block.lattice.y, block.size.z != 0,
                                       block.rock.w, glm::dvec2(block.sun.x, block.sun.y)},
                                      stop);
      },
      request.light_may_lag ? Beside::lagging : Beside::awaited);
  return shadows;
}

// Those of the frame's sun; of light that may lag, those that are being computed: one sun after the other.
TerrainStage::ShadowsList::iterator TerrainStage::shadows_of(const FrameRequest& request, const Land& land) {
  const std::string terrain = bake::terrain_key(land.terrain->recipe()) + " " +
                              std::to_string(request.cloudscape->ground.water.level_m.value_or(-1));
  const double azimuth_deg = light_azimuth_deg(*request.cloudscape);
  auto found = std::ranges::find_if(
      shadows_, [&](const Shadows& each) { return each.terrain == terrain && each.azimuth_deg == azimuth_deg; });
  if (found == shadows_.end() && request.light_may_lag)
    found =
        std::ranges::find_if(shadows_, [&](const Shadows& each) { return each.terrain == terrain && !each.texture; });
  if (found == shadows_.end()) {
    shadows_.push_front(begin_shadows(request, land, terrain));
    drop_oldest();
    return shadows_.begin();
  }
  shadows_.splice(shadows_.begin(), shadows_, found);
  return shadows_.begin();
}

// One that is done, if there is one: others are being waited for.
void TerrainStage::drop_oldest() {
  if (shadows_.size() <= most_shadows) return;
  auto oldest = std::find_if(shadows_.rbegin(), shadows_.rend(), [](const Shadows& each) { return each.texture; });
  if (oldest == shadows_.rend()) oldest = shadows_.rbegin();
  oldest->stop.request_stop();
  shadows_.erase(std::prev(oldest.base()));
}

bool TerrainStage::cast_shadows(const FrameRequest& request, Land& land) {
  Shadows& wanted = *shadows_of(request, land);
  if (!wanted.texture) {
    const auto newest = std::ranges::find_if(shadows_, [&](const Shadows& each) {
      return request.light_may_lag && each.texture && each.terrain == wanted.terrain;
    });
    const bool lags = newest != shadows_.end();
    if (wanted.tangents.wait_for(lags ? std::chrono::milliseconds(0) : patience) == std::future_status::ready)
      wanted.texture = shadow_map(land.terrain->recipe().resolution, wanted.tangents.get());
    else if (lags)
      land.sun = newest->texture;
  }
  if (wanted.texture) land.sun = wanted.texture;
  return land.sun != nullptr;
}

std::vector<Binding> TerrainStage::bind(const FrameRequest& request, const Land& land) {
  block_.upload(land.terrain ? terrain_block(request, *land.terrain) : TerrainBlock{});
  block_.bind();
  if (!land.terrain) return {};
  return {{11, &land.terrain->heights()}, {12, &land.terrain->surface()}, {13, land.sun.get()}};
}

void TerrainStage::reload(gpu::ShaderLibrary& shaders) { store_.reload(shaders); }

}  // namespace cloudscape::render
