#include "render/in_scatter_volumes.h"

#include <algorithm>
#include <cstring>
#include <glm/geometric.hpp>

#include "core/content_hash.h"
#include "render/block_values.h"

namespace cloudscape::render {
namespace {

using gpu::Filter, gpu::Format, gpu::Texture, gpu::Wrap;

// tuned: what the streams of a server look at together; a volume takes some megabytes.
constexpr std::size_t most_clouds = 4, most_volumes = 8;
constexpr auto longest_wait = std::chrono::milliseconds(5);

std::vector<glm::vec4> texels_of(const Texture& texture) {
  const std::vector<std::uint8_t> bytes = texture.download();
  std::vector<glm::vec4> texels(bytes.size() / sizeof(glm::vec4));
  std::memcpy(texels.data(), bytes.data(), bytes.size());
  return texels;
}

template <class T>
std::string bytes_of(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

// What the light of the clouds depends on beside their light.
std::string clouds_key(const InScatterVolumes::Wanted& wanted) {
  Cloudscape sky = *wanted.request.cloudscape;
  sky.title = sky.description = "";
  sky.sun = {}, sky.moon = {}, sky.sky = {}, sky.ground = {}, sky.wind = {}, sky.view = {};
  sky.medium.ambient = 1;
  return content_hash(sky) + bake::bake_key(wanted.baked.texels().recipe) + std::to_string(wanted.mean_cosine);
}

// From the middle of the cloud's altitudes: the sun along them, and what is around (shaders/render/sky_cloud_sun.glsl,
// sky_light.glsl).
bake::InScatterLight light_of(const InScatterVolumes::Wanted& wanted, const InScatterPlan& plan) {
  bake::InScatterLight light;
  const Cloudscape& sky = *wanted.request.cloudscape;
  light.sun_direction = direction_of_light(sky);
  const std::vector<glm::vec4> sun = texels_of(wanted.lights.cloud_sun), around = texels_of(wanted.lights.light);
  const int width = wanted.lights.cloud_sun.width(), height = wanted.lights.cloud_sun.height();
  for (int layer = 0; layer < plan.size.z; ++layer) {
    const double place = std::clamp(plan.first.z + layer * plan.spacing.z, 0.0, 1.0) * (height - 1);
    const int row = std::min(static_cast<int>(place), height - 2);
    const auto at = [&](int r) {  // the middle lies between two texels
      const auto texel = static_cast<std::size_t>(r * width + width / 2);
      return 0.5F * (glm::vec3(sun[texel - 1]) + glm::vec3(sun[texel]));
    };
    const float share = static_cast<float>(place) - static_cast<float>(row);
    light.sun_irradiance.push_back(at(row) * (1 - share) + at(row + 1) * share);
  }
  const auto scale = static_cast<float>(sky.medium.ambient);
  for (std::size_t part = 0; part < 6; ++part)
    light.surroundings[part] = scale * glm::vec3(around[part == 5 ? 8 : 2 + part]);
  return light;
}

float luminance(const glm::vec4& c) { return glm::dot(glm::vec3(c), glm::vec3(0.2126F, 0.7152F, 0.0722F)); }

Texture volume_texture(const glm::ivec3& size, bool periodic, const std::vector<glm::vec4>& texels, const char* label) {
  Texture texture(Format::rgba32f, size.x, size.y, size.z, label);
  const Wrap across = periodic ? Wrap::repeat : Wrap::clamp;
  texture.sample_with(Filter::linear, across, across, Wrap::clamp);
  texture.upload({reinterpret_cast<const std::uint8_t*>(texels.data()), texels.size() * sizeof(glm::vec4)});
  return texture;
}

std::shared_ptr<const InScatterVolume> uploaded(const InScatterPlan& plan,
                                                const std::vector<bake::InScatterSolution>& levels) {
  std::vector<glm::vec4> mean, directed;
  for (const bake::InScatterSolution& level : levels) {
    mean.insert(mean.end(), level.mean.begin(), level.mean.end());
    for (std::size_t i = 0; i < level.mean.size(); ++i) {
      const float scale = 1 / std::max(1e-20F, luminance(level.mean[i]));
      directed.emplace_back(scale * luminance(level.directed[0][i]), scale * luminance(level.directed[1][i]),
                            scale * luminance(level.directed[2][i]), 0);
    }
  }
  const glm::ivec3 size(plan.size.x, plan.size.y, plan.size.z * static_cast<int>(levels.size()));
  auto volume = std::make_shared<InScatterVolume>();
  volume->mean = volume_texture(size, plan.periodic, mean, "in-scatter volume");
  volume->directed = volume_texture(size, plan.periodic, directed, "in-scatter volume's directions");
  return volume;
}

}  // namespace

InScatterVolumes::InScatterVolumes(gpu::ShaderLibrary& shaders)
    : extinction_(shaders, "render/in_scatter_extinction.comp"), cloud_("cloud"), block_("in-scatter grid") {}

InScatterVolumes::~InScatterVolumes() {
  for (Job& job : jobs_) job.stop.request_stop();
}

bake::InScatterGrid InScatterVolumes::grid_of(const Wanted& wanted, const InScatterPlan& plan, double threshold) {
  const Volume& volume = wanted.request.cloudscape->volume;
  FrameRequest neutral;
  neutral.cloudscape = wanted.request.cloudscape;
  neutral.quality = render_quality(Quality::high);
  const glm::dvec3 below(volume.origin_m.x + 0.5 * volume.size_m.x, volume.origin_m.y + 0.5 * volume.size_m.y, 0);
  neutral.pose.position_m = below;
  CloudBlock cloud = cloud_block(neutral, wanted.baked);
  cloud.volume.y = 0;                                                // flat
  cloud.shape.x = static_cast<float>(threshold), cloud.shape.z = 0;  // the same everywhere
  cloud_.upload(cloud);
  cloud_.bind();
  const glm::dvec3 first = volume.origin_m + plan.first * volume.size_m - below, spacing = plan.spacing * volume.size_m;
  block_.upload({vec4(first, 0), vec4(spacing, 0), ivec4(plan.size, 0)});
  block_.bind();
  Texture target(Format::r32f, plan.size.x, plan.size.y, plan.size.z, "extinction");
  const gpu::Binding textures[] = {
      {0, &wanted.baked.shape()}, {1, &wanted.baked.detail()}, {2, &wanted.baked.variation()}, {4, &wanted.structure}};
  extinction_.run(target, 0, plan.size.z, textures);
  const std::vector<std::uint8_t> bytes = target.download();
  bake::InScatterGrid grid{plan.size, spacing, plan.periodic, std::vector<float>(bytes.size() / sizeof(float))};
  std::memcpy(grid.extinction_per_m.data(), bytes.data(), bytes.size());
  return grid;
}

std::shared_ptr<InScatterVolumes::Clouds> InScatterVolumes::clouds_of(const Wanted& wanted) {
  const std::string key = clouds_key(wanted);
  const auto found = std::find_if(clouds_.begin(), clouds_.end(), [&](const auto& each) { return each->key == key; });
  if (found != clouds_.end()) {
    clouds_.splice(clouds_.begin(), clouds_, found);
    return clouds_.front();
  }
  auto clouds = std::make_shared<Clouds>();
  clouds->key = key;
  clouds->plan = in_scatter_plan_of(*wanted.request.cloudscape, wanted.baked);
  for (const double threshold : clouds->plan.thresholds)
    clouds->grids.push_back(grid_of(wanted, clouds->plan, threshold));
  clouds_.push_front(clouds);
  if (clouds_.size() > most_clouds) clouds_.pop_back();
  return clouds;
}

void InScatterVolumes::start(const std::string& key, const std::shared_ptr<Clouds>& clouds, const Wanted& wanted,
                             const bake::InScatterLight& light) {
  std::vector<bake::InScatterProblem> problems;
  for (const bake::InScatterGrid& grid : clouds->grids)
    problems.push_back({grid, bake::scatter_moments(wanted.mean_cosine),
                        wanted.request.cloudscape->medium.single_scattering_albedo, light});
  Job job{key, {}, {}, clouds};
  job.result = std::async(std::launch::async,
                          [problems = std::move(problems), begin = clouds->latest,
                           token = job.stop.get_token()]() -> std::optional<Solutions> {
                            Solutions solutions;
                            for (std::size_t i = 0; i < problems.size(); ++i) {
                              auto solution =
                                  bake::solve_in_scatter(problems[i], {}, begin ? &(*begin)[i] : nullptr, token);
                              if (!solution) return std::nullopt;
                              solutions.push_back(std::move(*solution));
                            }
                            return solutions;
                          });
  jobs_.push_back(std::move(job));
}

std::shared_ptr<const InScatterVolume> InScatterVolumes::find(const Wanted& wanted) {
  const std::shared_ptr<Clouds> clouds = clouds_of(wanted);
  const bake::InScatterLight light = light_of(wanted, clouds->plan);
  const std::string key = clouds->key + bytes_of(std::span(&light.sun_direction, 1)) +
                          bytes_of(std::span<const glm::vec3>(light.sun_irradiance)) +
                          bytes_of(std::span<const glm::vec3>(light.surroundings));
  const auto found =
      std::find_if(volumes_.begin(), volumes_.end(), [&](const auto& each) { return each.first == key; });
  if (found != volumes_.end()) {
    volumes_.splice(volumes_.begin(), volumes_, found);
    return volumes_.front().second;
  }
  auto job = std::find_if(jobs_.begin(), jobs_.end(), [&](const Job& each) { return each.key == key; });
  if (job == jobs_.end()) {
    start(key, clouds, wanted, light);
    job = std::prev(jobs_.end());
  }
  if (job->result.wait_for(longest_wait) != std::future_status::ready) return nullptr;
  std::optional<Solutions> solutions = job->result.get();
  jobs_.erase(job);
  if (!solutions) return nullptr;
  clouds->latest = std::make_shared<const Solutions>(std::move(*solutions));
  volumes_.emplace_front(key, uploaded(clouds->plan, *clouds->latest));
  if (volumes_.size() > most_volumes) volumes_.pop_back();
  ++solved_;
  return volumes_.front().second;
}

void InScatterVolumes::reload(gpu::ShaderLibrary& shaders) {
  extinction_ = gpu::VolumePass(shaders, "render/in_scatter_extinction.comp");
  clouds_.clear(), volumes_.clear();
}

}  // namespace cloudscape::render
