#include "render/passes.h"

#include <algorithm>

namespace cloudscape::render {

using gpu::Binding, gpu::Format, gpu::ScreenPass, gpu::Texture;

namespace {

constexpr auto tiles_too = gpu::Shades::rects_and_tiles;

std::vector<Binding> march_textures(const Targets& targets, const SkyTables::Set& sky, const Passes::Medium& medium,
                                    const Texture& kept) {
  std::vector<Binding> textures{{0, &medium.baked.shape()},     {1, &medium.baked.detail()},
                                {2, &medium.baked.variation()}, {3, &targets.scene_depth},
                                {4, &medium.nearness},          {6, &sky.lights->cloud_sun},
                                {8, &sky.air->transmittance},   {10, &sky.lights->light},
                                {14, &sky.view->aerial},        {16, &kept}};
  if (medium.phase) textures.push_back({5, medium.phase});
  if (medium.in_scatter)
    textures.insert(textures.end(), {{11, &medium.in_scatter->mean}, {12, &medium.in_scatter->directed}});
  if (medium.sun_depth) textures.push_back({13, medium.sun_depth});
  if (medium.ambient) textures.push_back({15, medium.ambient});
  return textures;
}

std::vector<Binding> scene_textures(const SkyTables::Set& sky, const Passes::Medium& medium, const Texture& kept) {
  std::vector<Binding> textures(medium.land.begin(), medium.land.end());
  textures.insert(textures.end(), {{7, &sky.view->aerosol},
                                   {8, &sky.air->transmittance},
                                   {9, &sky.view->even},
                                   {10, &sky.lights->light},
                                   {14, &sky.view->aerial},
                                   {16, &kept}});
  return textures;
}

// Of the format of kept pictures, and no power of two in size: else llvmpipe compiles programs anew for those.
Texture nothing(const gpu::Context& context) {
  Texture texture(kept_format(context), 3, 3, "nothing kept");
  texture.clear();
  texture.sample_with(gpu::Filter::linear, gpu::Wrap::clamp);
  return texture;
}

}  // namespace

Passes::Passes(const gpu::Context& context, gpu::ShaderLibrary& shaders)
    : half_scene_(context, shaders, "render/scene.glsl", {Format::rgba16f, Format::r32f}, {}, tiles_too),
      full_scene_(context, shaders, "render/scene.glsl", {Format::rgba32f, Format::r32f}, {}, tiles_too),
      context_(context),
      shaders_(shaders),
      smooth_(context, shaders, "render/smooth.glsl", {Format::rgba16f, Format::rg32f}),
      composite_(context, shaders, "render/composite.glsl", {Format::rgba32f, Format::r32f}),
      composite_alone_(context, shaders, "render/composite.glsl", {Format::rgba32f, Format::r32f},
                       "#define WHOLE_AND_ALONE\n"),
      tone_map_(context, shaders, "render/tone_map.glsl", {Format::rgba8}),
      tone_map_bloom_(context, shaders, "render/tone_map_bloom.glsl", {Format::rgba8}),
      nothing_kept_(nothing(context)),
      bloom_(context, shaders) {}

SceneKind scene_kind_of(const Cloudscape& cloudscape) {
  if (cloudscape.ground.water.level_m) return SceneKind::water;
  return cloudscape.ground.kind == GroundKind::terrain ? SceneKind::land : SceneKind::plain;
}

const ScreenPass& Passes::scene_with(SceneKind kind, bool float32) const {
  if (kind == SceneKind::plain) return float32 ? full_scene_ : half_scene_;
  const bool water = kind == SceneKind::water;
  auto& pass = scenes_[(water ? 2 : 0) + (float32 ? 1 : 0)];
  const Format radiance = float32 ? Format::rgba32f : Format::rgba16f;
  const char* path = water ? "render/scene_water.glsl" : "render/scene_land.glsl";
  if (!pass) pass.emplace(context_, shaders_, path, std::vector{radiance, Format::r32f}, "", tiles_too);
  return *pass;
}

std::string march_kinds(const CloudBlock& cloud, SkyKind sky) {
  const auto define = [](const char* name, double value) {
    return std::string("#define ") + name + " " + std::to_string(static_cast<int>(value)) + "\n";
  };
  return define("VOLUME_KIND", cloud.layer.w) + define("PHASE_KIND", cloud.medium.w) +
         define("LIGHT_KIND", cloud.phase.w) + define("SKY_KIND", static_cast<int>(sky)) + "#define LAYERED " +
         (cloud.volume.w > 0 ? "true\n" : "false\n") + (cloud.shape.z <= 0 ? "#define EVEN_COVERAGE\n" : "");
}

const ScreenPass& Passes::march_of(const Medium& medium, bool float32) const {
  constexpr std::size_t most_programs = 24;  // tuned: of the documents that are shown by turns
  const std::string defines = medium.kinds + (medium.distances ? "" : "#define THESIS_STRUCTURE\n");
  const std::string name = defines + (float32 ? "32" : "16");
  if (const auto found = marches_.find(name); found != marches_.end()) return found->second;
  if (marches_.size() >= most_programs) marches_.clear();
  const std::vector formats{float32 ? Format::rgba32f : Format::rgba16f, Format::rg32f};
  return marches_.try_emplace(name, context_, shaders_, "render/march.glsl", formats, defines, tiles_too).first->second;
}

void Passes::march(const Targets& targets, const SkyTables::Set& sky, const Medium& medium, int row_begin, int row_end,
                   PassClock& clock) const {
  const int divisor = targets.march_divisor;
  const Texture* scene[] = {&targets.scene_radiance, &targets.scene_depth};
  const Texture* march[] = {&targets.march_radiance, &targets.march_depth};
  const glm::ivec2 origin = targets.march_origin;
  const int scene_end = std::min(row_end * divisor, targets.size.height);
  scene_with(medium.scene, targets.float32)
      .run({origin.x, origin.y + row_begin * divisor, targets.size.width, scene_end - row_begin * divisor}, scene,
           scene_textures(sky, medium, nothing_kept_));
  clock.lap("scene");
  march_of(medium, targets.float32)
      .run({origin.x, origin.y + row_begin, targets.march_size.width, row_end - row_begin}, march,
           march_textures(targets, sky, medium, nothing_kept_));
  clock.lap("march");
}

void Passes::march_newly(const Targets& targets, const SkyTables::Set& sky, const Medium& medium,
                         const NewlySeen& newly, PassClock& clock) const {
  const Texture* scene[] = {&targets.scene_radiance, &targets.scene_depth};
  const Texture* march[] = {&targets.march_radiance, &targets.march_depth};
  scene_with(medium.scene, targets.float32).run_tiles(newly.marks, scene, scene_textures(sky, medium, newly.kept));
  march_of(medium, targets.float32).run_tiles(newly.marks, march, march_textures(targets, sky, medium, newly.kept));
  clock.lap("newly_seen");
}

void Passes::composite(const Targets& targets, const Accumulation& previous, PassClock& clock) const {
  if (targets.smooth) {
    const Binding march[] = {{0, &targets.march_radiance}, {1, &targets.march_depth}};
    const Texture* smooth[] = {&targets.smooth_radiance, &targets.smooth_depth};
    smooth_.run({0, 0, targets.march_size.width, targets.march_size.height}, smooth, march);
    clock.lap("smooth");
  }
  const Binding textures[] = {{0, &targets.scene_radiance}, {1, &targets.scene_depth}, {2, &targets.clouds()},
                              {3, &targets.clouds_depth()}, {4, &previous.radiance},   {5, &previous.depth}};
  const Texture* output[] = {&targets.scratch.radiance, &targets.scratch.depth};
  const bool alone = !previous.radiance && targets.march_divisor == 1;
  (alone ? composite_alone_ : composite_).run({0, 0, targets.size.width, targets.size.height}, output, textures);
  clock.lap("composite");
}

void Passes::tone_map(const Targets& targets, const Accumulation& accumulation, PassClock& clock) const {
  const gpu::Rect all{0, 0, targets.size.width, targets.size.height};
  const Texture* output[] = {&targets.display};
  const Texture* glow = targets.bloom ? &bloom_.glow(*targets.bloom, accumulation.radiance) : nullptr;
  if (glow) clock.lap("bloom");
  const Binding plain[] = {{0, &accumulation.radiance}}, glowing[] = {plain[0], {1, glow}};
  if (glow)
    tone_map_bloom_.run(all, output, glowing);
  else
    tone_map_.run(all, output, plain);
  clock.lap("tone_map");
}

void Passes::reload(gpu::ShaderLibrary& shaders) {
  for (ScreenPass* pass :
       {&half_scene_, &full_scene_, &smooth_, &composite_, &composite_alone_, &tone_map_, &tone_map_bloom_})
    pass->reload(shaders);
  for (auto& pass : scenes_)
    if (pass) pass->reload(shaders);
  for (auto& [name, pass] : marches_) pass.reload(shaders);
  bloom_.reload(shaders);
}

}  // namespace cloudscape::render
