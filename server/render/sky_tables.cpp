#include "render/sky_tables.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace cloudscape::render {
namespace {

using gpu::Binding, gpu::Format, gpu::Texture;

// tuned: streams of one sky share its tables, and those at one altitude share all.
constexpr std::size_t most_airs = 4, most_levels = 16, most_views = 8, most_lights = 8;
constexpr int orders_after_the_first = 2;  // tuned: one more changes no channel by half a hundredth

// As in shaders/render/air.glsl.
constexpr int transmittance_width = 256, transmittance_height = 64, multiple_side = 32, view_width = 48,
              view_height = 56, aerial_width = 24, aerial_height = 32, aerial_depth = 3 * 24, cloud_sun_width = 64,
              cloud_sun_height = 16;
constexpr int light_entries = 9, rays = 8 * 16, ray_rows = 2;  // render/light_directions.glsl

Texture table(int width, int height, const char* label) {
  Texture texture(Format::rgba32f, width, height, label);
  texture.sample_with(gpu::Filter::linear, gpu::Wrap::clamp);
  return texture;
}

Texture aerial_table() {
  Texture texture(Format::rgba32f, aerial_width, aerial_height, aerial_depth, "aerial perspective");
  texture.sample_with(gpu::Filter::linear, gpu::Wrap::clamp);
  return texture;
}

template <class... Values>
std::string bytes_of(const Values&... values) {
  std::string bytes;
  (bytes.append(reinterpret_cast<const char*>(&values), sizeof values), ...);
  return bytes;
}

std::string air_key(const FrameBlock& frame) {
  const glm::vec3 albedo = frame.ground.x > 0 ? glm::vec3(frame.ground_albedo) : glm::vec3(0);
  return bytes_of(frame.atmosphere, frame.aerosol, albedo, frame.light_direction.w);
}

// The sky turns with its light, so that with one light its azimuth does not matter.
std::string sky_key(const FrameBlock& frame) {
  const vec4& light = frame.light_direction;
  std::string key = air_key(frame) + bytes_of(light.z, frame.light_irradiance, frame.sample_info.z);
  if (frame.sample_info.z > 1) key += bytes_of(light, frame.second_direction, frame.second_irradiance);
  return key;
}

// Of what the lights shine on, and what is there without them.
std::string lit_key(const FrameBlock& frame, const CloudBlock& cloud) {
  return bytes_of(cloud.layer, cloud.volume.z, frame.sky, frame.night, frame.ground.x);
}

void run(const gpu::ScreenPass& pass, std::initializer_list<const Texture*> targets,
         std::initializer_list<Binding> textures) {
  const Texture& first = **targets.begin();
  pass.run({0, 0, first.width(), first.height()}, {targets.begin(), targets.size()},
           {textures.begin(), textures.size()});
}

constexpr double first_rung_m = 62.5, rung_ratio = 1.25;

}  // namespace

double level_altitude_m(int level) { return first_rung_m * (std::pow(rung_ratio, level) - 1) / (rung_ratio - 1); }

int level_below(double altitude_m) {
  const double rungs = std::log1p(std::max(altitude_m, 0.0) * (rung_ratio - 1) / first_rung_m) / std::log(rung_ratio);
  return static_cast<int>(std::floor(rungs));
}

double share_of_upper(double altitude_m) {
  const int level = level_below(altitude_m);
  const double low_m = level_altitude_m(level), high_m = level_altitude_m(level + 1);
  return std::clamp((altitude_m - low_m) / (high_m - low_m), 0.0, 1.0);
}

SkyTables::SkyTables(const gpu::Context& context, gpu::ShaderLibrary& shaders)
    : transmittance_(context, shaders, "render/sky_transmittance.glsl", {Format::rgba32f}),
      multiple_(context, shaders, "render/sky_multiple.glsl", {Format::rgba32f}),
      view_(context, shaders, "render/sky_view.glsl", {Format::rgba32f, Format::rgba32f}),
      view_blend_(context, shaders, "render/sky_view_blend.glsl", {Format::rgba32f, Format::rgba32f}),
      rays_(context, shaders, "render/sky_rays.glsl", {Format::rgba32f, Format::rgba32f}),
      light_(context, shaders, "render/sky_light.glsl", {Format::rgba32f}),
      cloud_sun_(context, shaders, "render/sky_cloud_sun.glsl", {Format::rgba32f}),
      aerial_(shaders, "render/sky_aerial.comp"),
      aerial_blend_(shaders, "render/sky_aerial_blend.comp"),
      block_("sky"),
      airs_(most_airs),
      domes_(most_levels),
      aerials_(most_levels),
      views_(most_views),
      lagging_views_(most_views),
      lights_(most_lights) {}

double blended_altitude_m(double altitude_m) {
  const int level = level_below(altitude_m);
  const double low_m = level_altitude_m(level), step_m = (level_altitude_m(level + 1) - low_m) / 16;
  return low_m + std::round((altitude_m - low_m) / step_m) * step_m;
}

SkyTables::Set SkyTables::get(const FrameBlock& frame, const CloudBlock& cloud, AltitudeOfView altitude, SkyLag lag) {
  Set set;
  set.air = airs_.get(air_key(frame), [&] { return make_air(); });
  set.lights = lights_of(frame, cloud, *set.air, lag);
  const double camera_m = std::max(0.0, double(frame.camera_forward.w));
  const double altitude_m = altitude == AltitudeOfView::exact ? camera_m : blended_altitude_m(camera_m);
  set.view = view_of(frame, *set.air, altitude_m, lag);
  return set;
}

std::shared_ptr<const SkyTables::Lights> SkyTables::lights_of(const FrameBlock& frame, const CloudBlock& cloud,
                                                              const Air& air, SkyLag lag) {
  const std::string lit = lit_key(frame, cloud), key = sky_key(frame) + lit;
  if (lag == SkyLag::all && !lights_.find(key))
    if (auto before = lights_.newest(air_key(frame), lit)) return before;
  return lights_.get(key, [&] { return make_lights(air); });
}

std::shared_ptr<const SkyTables::Dome> SkyTables::dome_of(const std::string& sky, const Air& air, int level) {
  return domes_.get(sky + bytes_of(level), [&] { return make_dome(air, level); });
}

std::shared_ptr<const SkyTables::Aerial> SkyTables::aerial_of(const std::string& sky, const Air& air, int level) {
  return aerials_.get(sky + bytes_of(level), [&] { return make_aerial(air, level); });
}

std::shared_ptr<const SkyTables::View> SkyTables::view_of(const FrameBlock& frame, const Air& air, double altitude_m,
                                                          SkyLag lag) {
  const std::string sky = sky_key(frame), key = sky + bytes_of(altitude_m);
  const int level = level_below(altitude_m);
  const double share = share_of_upper(altitude_m);
  if (lag != SkyLag::none && !views_.find(key))
    if (const auto levels = lagging_levels(frame, air, level, lag)) return lagging_view(*levels, share);
  return views_.get(key, [&] {
    return blend({dome_of(sky, air, level), dome_of(sky, air, level + 1), aerial_of(sky, air, level),
                  aerial_of(sky, air, level + 1)},
                 share);
  });
}

// The newest tables of any light, of which the oldest is renewed or none; nullopt where some are missing, or all are of
// this light.
std::optional<SkyTables::Levels> SkyTables::lagging_levels(const FrameBlock& frame, const Air& air, int level,
                                                           SkyLag lag) {
  const std::string sky = sky_key(frame), same_air = air_key(frame);
  Levels levels;
  std::vector<std::pair<int, std::function<void()>>> old;  // when it was made, and how it is renewed
  bool complete = true;
  const auto take = [&](auto& kept, auto& table, int rung, const auto& renewed) {
    table = kept.find(sky + bytes_of(rung));
    if (table) return;
    table = kept.newest(same_air, bytes_of(rung));
    if (!table) return void(complete = false);
    old.emplace_back(table->made, [&table, rung, renewed] { table = renewed(rung); });
  };
  const auto new_dome = [&](int rung) { return dome_of(sky, air, rung); };
  const auto new_aerial = [&](int rung) { return aerial_of(sky, air, rung); };
  take(domes_, levels.lower_dome, level, new_dome), take(domes_, levels.upper_dome, level + 1, new_dome);
  take(aerials_, levels.lower_air, level, new_aerial), take(aerials_, levels.upper_air, level + 1, new_aerial);
  if (!complete || old.empty()) return std::nullopt;
  if (lag == SkyLag::but_for_one)
    std::ranges::min_element(old, {}, [](const auto& each) { return each.first; })->second();
  return levels;
}

// As long as none of its tables is renewed it is the same.
std::shared_ptr<const SkyTables::View> SkyTables::lagging_view(const Levels& levels, double share) {
  const std::string key =
      bytes_of(levels.lower_dome->made, levels.upper_dome->made, levels.lower_air->made, levels.upper_air->made, share);
  return lagging_views_.get(key, [&] { return blend(levels, share); });
}

void SkyTables::set_block(double altitude_m, double share, bool first_order) {
  block_.upload({{altitude_m, share, first_order, 0}});
  block_.bind();
}

SkyTables::Air SkyTables::make_air() {
  ++bakes_;
  Air air{table(transmittance_width, transmittance_height, "sky transmittance"),
          table(multiple_side, multiple_side, "sky multiple scattering")};
  Texture other = table(multiple_side, multiple_side, "sky multiple scattering");
  run(transmittance_, {&air.transmittance}, {});
  for (int order = 0; order <= orders_after_the_first; ++order) {
    set_block(0, 0, order == 0);
    run(multiple_, {&air.multiple}, {{8, &air.transmittance}, {9, &other}});
    std::swap(air.multiple, other);
  }
  std::swap(air.multiple, other);
  return air;
}

SkyTables::Dome SkyTables::make_dome(const Air& air, int level) {
  Dome dome{table(view_width, view_height, "sky view"), table(view_width, view_height, "sky view of aerosol"),
            ++bakes_};
  set_block(level_altitude_m(level), 0, false);
  run(view_, {&dome.even, &dome.aerosol}, {{8, &air.transmittance}, {9, &air.multiple}});
  return dome;
}

SkyTables::Aerial SkyTables::make_aerial(const Air& air, int level) {
  Aerial aerial{aerial_table(), ++bakes_};
  const Binding tables[] = {{8, &air.transmittance}, {9, &air.multiple}};
  set_block(level_altitude_m(level), 0, false);
  aerial_.run(aerial.air, 0, 1, tables);  // one invocation writes all slices
  return aerial;
}

SkyTables::View SkyTables::blend(const Levels& levels, double share) {
  View view{table(view_width, view_height, "sky view"), table(view_width, view_height, "sky view of aerosol"),
            aerial_table()};
  const Dome &lower = *levels.lower_dome, &upper = *levels.upper_dome;
  set_block(0, share, false);
  run(view_blend_, {&view.even, &view.aerosol},
      {{0, &lower.even}, {1, &upper.even}, {2, &lower.aerosol}, {3, &upper.aerosol}});
  const Binding airs[] = {{0, &levels.lower_air->air}, {1, &levels.upper_air->air}};
  aerial_blend_.run(view.aerial, 0, aerial_depth, airs);
  return view;
}

SkyTables::Lights SkyTables::make_lights(const Air& air) {
  ++bakes_;
  Lights lights{table(light_entries, 1, "sky light"), table(cloud_sun_width, cloud_sun_height, "sun at the clouds")};
  const Texture around = table(rays, ray_rows, "sky about the clouds"), through = table(rays, ray_rows, "air below");
  run(rays_, {&around, &through}, {{8, &air.transmittance}, {9, &air.multiple}});
  run(light_, {&lights.light}, {{0, &around}, {1, &through}, {8, &air.transmittance}});
  run(cloud_sun_, {&lights.cloud_sun}, {{8, &air.transmittance}});
  return lights;
}

void SkyTables::reload(gpu::ShaderLibrary& shaders) {
  for (gpu::ScreenPass* pass : {&transmittance_, &multiple_, &view_, &view_blend_, &rays_, &light_, &cloud_sun_})
    pass->reload(shaders);
  aerial_ = gpu::VolumePass(shaders, "render/sky_aerial.comp");
  aerial_blend_ = gpu::VolumePass(shaders, "render/sky_aerial_blend.comp");
  airs_.clear(), domes_.clear(), aerials_.clear(), views_.clear(), lights_.clear();
  lagging_views_.clear();
}

}  // namespace cloudscape::render
