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
// tuned: a viewer asks for its frame many times a second. Who has not asked for so long has gone, or moved the sun on.
constexpr auto forgotten_after = std::chrono::seconds(2);
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
  constexpr const char* version = "1";  // of the solver and the grid: raise it when they change what they make
  return version + content_hash(sky) + bake::bake_key(wanted.baked.texels().recipe) +
         std::to_string(wanted.mean_cosine);
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

Texture volume_texture(const glm::ivec3& size, bool periodic, const std::vector<glm::vec4>& texels, const char* label) {
  Texture texture(Format::rgba32f, size.x, size.y, size.z, label);
  const Wrap across = periodic ? Wrap::repeat : Wrap::clamp;
  texture.sample_with(Filter::linear, across, across, Wrap::clamp);
  texture.upload({reinterpret_cast<const std::uint8_t*>(texels.data()), texels.size() * sizeof(glm::vec4)});
  return texture;
}

std::size_t texels_of(const InScatterPlan& plan) {
  return static_cast<std::size_t>(plan.size.x) * static_cast<std::size_t>(plan.size.y) *
         static_cast<std::size_t>(plan.size.z) * plan.thresholds.size();
}

std::optional<bake::LightTexels> solve(const std::vector<bake::InScatterProblem>& levels, const std::stop_token& stop) {
  std::vector<bake::InScatterSolution> solutions;
  for (const bake::InScatterProblem& level : levels) {
    auto solution = bake::solve_in_scatter(level, {}, stop);
    if (!solution) return std::nullopt;
    solutions.push_back(std::move(*solution));
  }
  return bake::light_texels(solutions);
}

}  // namespace

InScatterVolumes::InScatterVolumes(gpu::ShaderLibrary& shaders, bake::LightCache cache)
    : extinction_(shaders, "render/in_scatter_extinction.comp"),
      cloud_("cloud"),
      block_("in-scatter grid"),
      cache_(std::move(cache)) {}

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

InScatterVolumes::Job& InScatterVolumes::job_of(const std::string& key, const std::shared_ptr<Clouds>& clouds,
                                                const Wanted& wanted, const bake::InScatterLight& light) {
  const auto found = std::find_if(jobs_.begin(), jobs_.end(), [&](const Job& each) { return each.key == key; });
  if (found != jobs_.end()) return *found;
  std::vector<bake::InScatterProblem> levels;
  for (const bake::InScatterGrid& grid : clouds->grids)
    levels.push_back({grid, bake::scatter_moments(wanted.mean_cosine),
                      wanted.request.cloudscape->medium.single_scattering_albedo, light});
  Job& job = jobs_.emplace_back(Job{key, clouds, {}, {}, Clock::now()});
  job.result = std::async(std::launch::async,
                          [levels = std::move(levels), stop = job.stop.get_token()] { return solve(levels, stop); });
  return job;
}

std::shared_ptr<const InScatterVolume> InScatterVolumes::kept(const std::string& key) {
  const auto found = std::find_if(volumes_.begin(), volumes_.end(), [&](const Kept& each) { return each.key == key; });
  if (found == volumes_.end()) return nullptr;
  volumes_.splice(volumes_.begin(), volumes_, found);
  return volumes_.front().volume;
}

std::shared_ptr<const InScatterVolume> InScatterVolumes::keep(const std::string& key, Clouds& clouds,
                                                              const bake::LightTexels& light) {
  const InScatterPlan& plan = clouds.plan;
  const glm::ivec3 size(plan.size.x, plan.size.y, plan.size.z * static_cast<int>(plan.thresholds.size()));
  auto volume = std::make_shared<InScatterVolume>();
  volume->mean = volume_texture(size, plan.periodic, light.mean, "in-scatter volume");
  volume->directed = volume_texture(size, plan.periodic, light.directed, "in-scatter volume's directions");
  volumes_.push_front({key, volume});
  if (volumes_.size() > most_volumes) volumes_.pop_back();
  return clouds.newest = volume;
}

void InScatterVolumes::take_results() {
  for (auto job = jobs_.begin(); job != jobs_.end();) {
    if (job->result.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
      ++job;
      continue;
    }
    if (const std::optional<bake::LightTexels> light = job->result.get()) {
      ++solved_;
      keep(job->key, *job->clouds, *light);
      cache_.store(job->key, *light);
    }
    job = jobs_.erase(job);
  }
}

void InScatterVolumes::drop_the_forgotten() {
  jobs_.remove_if([now = Clock::now()](Job& job) {
    if (now - job.asked < forgotten_after) return false;
    job.stop.request_stop();  // its end is waited for: an iteration
    return true;
  });
}

std::shared_ptr<const InScatterVolume> InScatterVolumes::find(const Wanted& wanted) {
  take_results();
  const std::shared_ptr<Clouds> clouds = clouds_of(wanted);
  const bake::InScatterLight light = light_of(wanted, clouds->plan);
  const std::string key = sha256_hex(clouds->key + bytes_of(std::span(&light.sun_direction, 1)) +
                                     bytes_of(std::span<const glm::vec3>(light.sun_irradiance)) +
                                     bytes_of(std::span<const glm::vec3>(light.surroundings)));
  if (auto volume = kept(key)) return clouds->newest = volume;
  // Light that may lag is solved one sun after the other, each to its end.
  if (wanted.request.light_may_lag && clouds->newest)
    for (Job& job : jobs_)
      if (job.clouds == clouds) {
        job.asked = Clock::now();
        return clouds->newest;
      }
  drop_the_forgotten();
  if (const auto light_on_disk = cache_.load(key, texels_of(clouds->plan))) return keep(key, *clouds, *light_on_disk);
  Job& job = job_of(key, clouds, wanted, light);
  job.asked = Clock::now();
  if (wanted.request.light_may_lag && clouds->newest) return clouds->newest;
  if (job.result.wait_for(longest_wait) == std::future_status::ready) take_results();
  return kept(key);
}

void InScatterVolumes::reload(gpu::ShaderLibrary& shaders) {
  extinction_ = gpu::VolumePass(shaders, "render/in_scatter_extinction.comp");
  clouds_.clear(), volumes_.clear();
}

}  // namespace cloudscape::render
