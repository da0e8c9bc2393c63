#include "render/in_scatter_volumes.h"

#include <algorithm>
#include <cstring>
#include <glm/common.hpp>
#include <thread>

#include "core/beside_frames.h"
#include "core/content_hash.h"
#include "core/wind.h"
#include "render/block_values.h"

namespace cloudscape::render {
namespace {

using gpu::Filter, gpu::Format, gpu::Texture, gpu::Wrap;

// tuned: what the streams of a server look at together.
constexpr std::size_t most_clouds = 4, most_questions = 8, most_volume_bytes = 128 << 20;
constexpr std::size_t most_jobs = 2;  // tuned: each takes a core, and up to 200 MB
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

// What the light in the clouds depends on beside the light that comes to them.
std::string clouds_key(const Cloudscape& marched, const bake::BakedCloudscape& baked, double mean_cosine) {
  constexpr const char* version = "3";  // of the solver and the grid: raise it when they change what they make
  Cloudscape sky = marched;
  sky.title = sky.description = "";
  const glm::dvec2 lean = lean_m(sky);
  sky.sun = {}, sky.moon = {}, sky.sky = {}, sky.ground = {}, sky.wind = {}, sky.view = {};
  sky.medium.ambient = 1;
  return version + content_hash(sky) + bake::bake_key(baked.texels().recipe) + std::to_string(mean_cosine) +
         (lean == glm::dvec2(0) ? "" : bytes_of(std::span(&lean, 1)));
}

// The sun along the middle of the table of render/sky_cloud_sun.glsl, at a place 0..1 of the volume's height.
glm::vec3 sun_at(const std::vector<glm::vec4>& table, const Texture& texture, double place) {
  const int width = texture.width(), height = texture.height();
  const double at = std::clamp(place, 0.0, 1.0) * (height - 1);
  const int row = std::min(static_cast<int>(at), height - 2);
  const auto middle = [&](int r) {  // lies between two texels
    const auto texel = static_cast<std::size_t>(r * width + width / 2);
    return 0.5F * (glm::vec3(table[texel - 1]) + glm::vec3(table[texel]));
  };
  return glm::mix(middle(row), middle(row + 1), static_cast<float>(at - row));
}

bake::InScatterLight light_of(const Cloudscape& sky, const SkyTables::Lights& lights, const InScatterPlan& plan) {
  bake::InScatterLight light;
  light.sun_direction = direction_of_light(sky);
  const std::vector<glm::vec4> sun = texels_of(lights.cloud_sun), around = texels_of(lights.light);
  for (int layer = 0; layer < plan.size.z; ++layer)
    light.sun_irradiance.push_back(sun_at(sun, lights.cloud_sun, plan.first.z + layer * plan.spacing.z));
  for (std::size_t part = 0; part < 6; ++part) {
    const std::size_t entry = part == 5 ? 8 : 2 + part;  // shaders/render/sky_light.glsl
    light.surroundings[part] = static_cast<float>(sky.medium.ambient) * glm::vec3(around[entry]);
  }
  return light;
}

std::string light_key(const bake::InScatterLight& light) {
  return bytes_of(std::span(&light.sun_direction, 1)) + bytes_of(std::span<const glm::vec3>(light.sun_irradiance)) +
         bytes_of(std::span<const glm::vec3>(light.surroundings));
}

Texture volume_texture(const glm::ivec3& size, bool periodic, const std::vector<glm::vec4>& texels, const char* label) {
  Texture texture(Format::rgba32f, size.x, size.y, size.z, label);
  const Wrap across = periodic ? Wrap::repeat : Wrap::clamp;
  texture.sample_with(Filter::linear, across, across, Wrap::clamp);
  texture.upload({reinterpret_cast<const std::uint8_t*>(texels.data()), texels.size() * sizeof(glm::vec4)});
  return texture;
}

std::size_t count_of(const InScatterPlan& plan) {
  return static_cast<std::size_t>(plan.size.x) * static_cast<std::size_t>(plan.size.y) *
         static_cast<std::size_t>(plan.size.z) * plan.thresholds.size();
}

std::shared_ptr<const InScatterVolume> volume_of(const InScatterPlan& plan, const bake::LightTexels& light) {
  const glm::ivec3 size(plan.size.x, plan.size.y, plan.size.z * static_cast<int>(plan.thresholds.size()));
  auto volume = std::make_shared<InScatterVolume>();
  volume->mean = volume_texture(size, plan.periodic, light.mean, "in-scatter volume");
  volume->directed = volume_texture(size, plan.periodic, light.directed, "in-scatter volume's directions");
  return volume;
}

template <class List>
void keep_first(List& list, std::size_t most) {
  while (list.size() > most) list.pop_back();
}

}  // namespace

// On a thread of its own. The level in the middle comes first, and is a draft of all of them; the others yield to the
// flight that this draft begins.
std::optional<bake::LightTexels> InScatterVolumes::solve(const std::vector<bake::InScatterProblem>& levels,
                                                         Beside beside, const std::stop_token& stop, Draft& draft) {
  const std::size_t middle = levels.size() / 2;
  auto first = bake::solve_in_scatter(levels[middle], {}, stop);
  if (!first) return std::nullopt;
  std::vector<bake::InScatterSolution> solutions(levels.size(), *first);
  if (levels.size() > 1) {
    draft.light = bake::light_texels(solutions);
    draft.ready = true;
  }
  for (std::size_t level = 0; level < levels.size(); ++level) {
    if (level == middle) continue;
    yield_to_frames(beside);
    auto solution = bake::solve_in_scatter(levels[level], {}, stop);
    if (!solution) return std::nullopt;
    solutions[level] = std::move(*solution);
  }
  return bake::light_texels(solutions);
}

InScatterVolumes::InScatterVolumes(gpu::ShaderLibrary& shaders, bake::LightCache cache)
    : extinction_(shaders), cache_(std::move(cache)) {}

InScatterVolumes::~InScatterVolumes() {
  for (Job& job : jobs_) job.stop.request_stop();
}

std::shared_ptr<InScatterVolumes::Clouds> InScatterVolumes::clouds_of(const Wanted& wanted) {
  const std::shared_ptr<const Cloudscape> marched = as_marched(wanted.request, *wanted.baked).cloudscape;
  const std::string key = clouds_key(*marched, *wanted.baked, wanted.mean_cosine);
  const auto found = std::find_if(clouds_.begin(), clouds_.end(), [&](const auto& each) { return each->key == key; });
  if (found != clouds_.end()) {
    clouds_.splice(clouds_.begin(), clouds_, found);
    return clouds_.front();
  }
  auto clouds = std::make_shared<Clouds>();
  clouds->key = key;
  clouds->plan = in_scatter_plan_of(*marched, *wanted.baked);
  clouds->marched = marched;
  clouds_.push_front(clouds);
  keep_first(clouds_, most_clouds);
  return clouds;
}

const InScatterVolumes::Question* InScatterVolumes::known_question(const Wanted& wanted) {
  const auto found = std::find_if(questions_.begin(), questions_.end(), [&](const Question& each) {
    return each.cloudscape == wanted.request.cloudscape && each.baked.lock() == wanted.baked &&
           each.lights.lock() == wanted.lights && each.mean_cosine == wanted.mean_cosine;
  });
  if (found == questions_.end()) return nullptr;
  questions_.splice(questions_.begin(), questions_, found);
  return &questions_.front();
}

// Reads the light back from the device, and waits for it.
const InScatterVolumes::Question& InScatterVolumes::ask(const Wanted& wanted, const std::shared_ptr<Clouds>& clouds) {
  Question question{wanted.request.cloudscape, wanted.baked, wanted.lights, wanted.mean_cosine, clouds, {}, {}};
  question.light = light_of(*question.cloudscape, *wanted.lights, question.clouds->plan);
  question.key = sha256_hex(question.clouds->key + light_key(question.light));
  questions_.push_front(std::move(question));
  keep_first(questions_, most_questions);
  return questions_.front();
}

InScatterVolumes::Job* InScatterVolumes::job_of(const std::string& key) {
  const auto found = std::find_if(jobs_.begin(), jobs_.end(), [&](const Job& each) { return each.key == key; });
  return found == jobs_.end() ? nullptr : &*found;
}

InScatterVolumes::Job* InScatterVolumes::job_in(const Clouds& clouds) {
  const auto found = std::ranges::find_if(jobs_, [&](const Job& each) { return each.clouds.get() == &clouds; });
  return found == jobs_.end() ? nullptr : &*found;
}

// nullptr: enough is being solved, or the clouds are not there yet.
InScatterVolumes::Job* InScatterVolumes::start(const Question& question, const bake::BakedCloudscape& baked,
                                               Beside beside) {
  stop_the_forgotten();
  Clouds& clouds = *question.clouds;
  if (!extinction_.advance(clouds.marched, baked, clouds.plan, clouds.grids, beside) || jobs_.size() >= most_jobs)
    return nullptr;
  std::vector<bake::InScatterProblem> levels;
  for (const bake::InScatterGrid& grid : clouds.grids.done)
    levels.push_back({grid, bake::scatter_moments(question.mean_cosine),
                      question.cloudscape->medium.single_scattering_albedo, question.light});
  Job& job = jobs_.emplace_back(Job{question.key, question.clouds, {}, {}, Clock::now(), std::make_shared<Draft>()});
  job.result = beside_frames(
      [levels = std::move(levels), beside, stop = job.stop.get_token(), cache = cache_, key = question.key,
       draft = job.draft] {
        auto light = solve(levels, beside, stop, *draft);
        if (light) cache.store(key, *light);
        return light;
      },
      beside);
  return &job;
}

std::shared_ptr<const InScatterVolume> InScatterVolumes::kept(const std::string& key) {
  const auto found = std::find_if(volumes_.begin(), volumes_.end(), [&](const Kept& each) { return each.key == key; });
  if (found == volumes_.end()) return nullptr;
  volumes_.splice(volumes_.begin(), volumes_, found);
  return volumes_.front().volume;
}

void InScatterVolumes::keep(const std::string& key, Clouds& clouds, const bake::LightTexels& light) {
  const auto volume = volume_of(clouds.plan, light);
  volumes_.push_front({key, volume});
  keep_first(volumes_, std::max(std::size_t{1}, most_volume_bytes / volume->bytes()));
  clouds.newest = volume;
}

void InScatterVolumes::take_results() {
  jobs_.remove_if([this](Job& job) {
    if (job.result.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
    if (const std::optional<bake::LightTexels> light = job.result.get()) keep(job.key, *job.clouds, *light);
    return true;
  });
}

// They end by themselves soon, and are then taken off the list.
void InScatterVolumes::stop_the_forgotten() {
  for (Job& job : jobs_)
    if (Clock::now() - job.asked > forgotten_after) job.stop.request_stop();
}

std::shared_ptr<const InScatterVolume> InScatterVolumes::find(const Wanted& wanted) {
  take_results();
  const Question* known = known_question(wanted);
  const std::shared_ptr<Clouds> in = known ? known->clouds : clouds_of(wanted);
  Clouds& clouds = *in;
  const bool may_lag = wanted.request.light_may_lag && clouds.newest;
  // Light that may lag is solved one sun after the other, each to its end.
  Job* running = may_lag ? job_in(clouds) : nullptr;
  if (may_lag && !known && (running || wanted.rests)) {
    if (running) running->asked = Clock::now();
    return clouds.newest;
  }
  const Question& question = known ? *known : ask(wanted, in);
  if (auto volume = kept(question.key)) return clouds.newest = volume;
  Job* job = job_of(question.key);
  if (!job) job = running;
  if (!job) {
    if (const auto light = cache_.load(question.key, count_of(clouds.plan))) {
      keep(question.key, clouds, *light);
      return clouds.newest;
    }
    job = start(question, *wanted.baked, may_lag ? Beside::lagging : Beside::awaited);
  }
  if (job) job->asked = Clock::now();
  if (may_lag) return clouds.newest;
  if (wanted.request.light_may_lag && job && job->draft->ready)
    return clouds.newest = volume_of(clouds.plan, job->draft->light);
  const bool busy = clouds.grids.done.size() < clouds.plan.thresholds.size();
  if (!job && !busy)
    std::this_thread::sleep_for(longest_wait);
  else if (job && job->result.wait_for(longest_wait) == std::future_status::ready)
    take_results();
  return kept(question.key);
}

void InScatterVolumes::reload(gpu::ShaderLibrary& shaders) {
  extinction_ = InScatterExtinction(shaders);
  questions_.clear(), clouds_.clear(), volumes_.clear();
}

}  // namespace cloudscape::render
