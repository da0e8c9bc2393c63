#include "render/resolver.h"

#include <array>

namespace cloudscape::render {

using gpu::Binding, gpu::Format, gpu::ScreenPass, gpu::Texture;

namespace {

Texture picture_texture(Format format, ImageSize size, const char* label) {
  Texture texture(format, size.width, size.height, label);
  texture.sample_with(gpu::Filter::linear, gpu::Wrap::clamp);
  return texture;
}

// Makes it anew where its size is another.
bool fits(const Texture& texture, ImageSize size) {
  return texture && texture.width() == size.width && texture.height() == size.height;
}

constexpr auto tiles_too = gpu::Shades::rects_and_tiles;

bool has_land(const ResolvedFrame& frame) { return frame.asked.cloudscape->ground.kind == GroundKind::terrain; }

gpu::Rect whole(ImageSize size) { return {0, 0, size.width, size.height}; }

}  // namespace

Resolver::Resolver(const gpu::Context& context, gpu::ShaderLibrary& shaders)
    : context_(context),
      shaders_(shaders),
      even_(context, shaders, "render/resolve_even.glsl", {kept_format(context)}),
      resolve_(context, shaders, "render/resolve.glsl", {kept_format(context)}),
      resolve_land_(context, shaders, "render/resolve_land.glsl", {kept_format(context), Format::r32f}),
      newly_seen_(context, shaders, "render/newly_seen.glsl", {kept_format(context)}, "", tiles_too),
      newly_seen_land_(context, shaders, "render/newly_seen_land.glsl", {kept_format(context), Format::r32f}, "",
                       tiles_too),
      block_("resolve") {
  block_.upload(ResolveBlock{});  // the scene's and the march's passes have it, whoever runs them
  block_.bind();
}

ResolvedFrame Resolver::begin(const FrameRequest& asked) const {
  const auto found = pictures_.find(asked.stream);
  if (found == pictures_.end()) return {asked, resolve_plan(asked)};
  const KeptView& before = found->second.view;
  const bool resting = before.pose == asked.pose && before.time_s == asked.time_s;
  return {asked, resolve_plan(asked), found->second.frames, resting};
}

Resolver::Shared& Resolver::shared_of(ImageSize kept, ImageSize marched) {
  constexpr std::size_t most_sizes = 4;  // tuned: sizes that alternate without being made anew each time
  if (shared_.size() > most_sizes) shared_.clear();
  Shared& shared = shared_[{kept.width, kept.height}];
  if (!shared.spare) shared.spare = picture_texture(kept_format(context_), kept, "spare picture");
  if (!fits(shared.even, marched)) shared.even = picture_texture(kept_format(context_), marched, "evened radiance");
  if (!shared.marks) shared.marks = gpu::TileMarks(kept.width, kept.height);
  return shared;
}

bool Resolver::resolve(const ResolvedFrame& frame, const Accumulation& marched, PassClock& clock) {
  const ResolvePlan& plan = frame.plan;
  Shared& shared = shared_of(plan.kept, plan.marched);
  Picture& picture = pictures_[frame.asked.stream];
  const KeptView now = kept_view(frame.asked, plan);
  const bool before = static_cast<bool>(picture.radiance);
  const ResolveBlock block =
      resolve_block(plan, frame.frame, now, before ? std::optional(picture.view) : std::nullopt, frame.resting);
  block_.upload(block);
  block_.bind();
  const Texture* even[] = {&shared.even};
  const Binding seen[] = {{0, &marched.radiance}, {1, &marched.depth}};
  even_.run(whole(plan.marched), even, seen);
  clock.lap("even");
  const bool land = has_land(frame);
  Texture& closeness = shared.spare_closeness;
  if (land && !fits(closeness, plan.kept)) closeness = picture_texture(Format::r32f, plan.kept, "spare closeness");
  const std::array<Binding, 3> textures{{{0, &shared.even},
                                         {1, before ? &picture.radiance : &shared.even},
                                         {2, picture.closeness ? &picture.closeness : &shared.even}}};
  const std::array<const Texture*, 2> outputs{&shared.spare, &closeness};
  shared.marks.begin();
  (land ? resolve_land_ : resolve_)
      .run(whole(plan.kept), std::span(outputs).first(land ? 2 : 1), std::span(textures).first(land ? 3 : 2));
  shared.marks.end();
  clock.lap("resolve");
  std::swap(picture.radiance, shared.spare);
  if (land)
    std::swap(picture.closeness, closeness);
  else
    picture.closeness = {};
  if (!fits(shared.spare, plan.kept)) shared.spare = {};
  picture.view = now;
  picture.frames = frame.frame + 1;
  return block.kept.w != 0 || block.sun.z > 0 || block.moon.z > 0;
}

Passes::NewlySeen Resolver::newly_seen(const ResolvedFrame& frame) const {
  const ImageSize kept = frame.plan.kept;
  return {shared_.at({kept.width, kept.height}).marks, pictures_.at(frame.asked.stream).radiance};
}

void Resolver::add_newly_seen(const ResolvedFrame& frame, const Targets& targets, PassClock& clock) {
  const Picture& picture = pictures_.at(frame.asked.stream);
  const std::array<Binding, 4> textures{{{0, &targets.scene_radiance},
                                         {1, &targets.scene_depth},
                                         {2, &targets.march_radiance},
                                         {3, &targets.march_depth}}};
  const std::array<const Texture*, 2> outputs{&picture.radiance, &picture.closeness};
  const bool land = has_land(frame);
  (land ? newly_seen_land_ : newly_seen_)
      .run_tiles(newly_seen(frame).marks, std::span(outputs).first(land ? 2 : 1), textures);
  clock.lap("newly_seen");
}

const Texture* Resolver::glow(const ResolvedFrame& frame, const Bloom& bloom, const Texture& radiance) {
  const Display& display = frame.asked.display;
  if (display.bloom_strength <= 0) return nullptr;
  std::unique_ptr<BloomChain>& chain = shared_of(frame.plan.kept, frame.plan.marched).bloom;
  if (!chain || !chain->fits(display.bloom_radius, false))
    chain = std::make_unique<BloomChain>(frame.plan.kept, display.bloom_radius, false, moving_bloom_rows);
  return &bloom.glow(*chain, radiance);
}

const Texture& Resolver::present(const ResolvedFrame& frame, const Bloom& bloom, PassClock& clock) {
  const Picture& picture = pictures_.at(frame.asked.stream);
  const ResolvePlan& plan = frame.plan;
  if (!fits(developed_, plan.kept))
    developed_ = Texture(Format::rgba8, plan.kept.width, plan.kept.height, "developed picture");
  const Texture* glows = glow(frame, bloom, picture.radiance);
  if (glows) clock.lap("bloom");
  develop(picture.radiance, glows, frame.asked.display.tone_curve);
  clock.lap("develop");
  return developed_;
}

ScreenPass& Resolver::developing(ToneCurve curve, bool glows) {
  const auto found = develop_.find({curve, glows});
  if (found != develop_.end()) return found->second;
  const std::string define = "#define TONE_CURVE " + std::to_string(static_cast<int>(curve)) + "\n";
  const char* path = glows ? "render/develop_bloom.glsl" : "render/develop.glsl";
  ScreenPass pass(context_, shaders_, path, {Format::rgba8}, define);
  return develop_.emplace(std::pair{curve, glows}, std::move(pass)).first->second;
}

void Resolver::develop(const Texture& radiance, const Texture* glow, ToneCurve curve) {
  const Texture* output[] = {&developed_};
  const Binding plain[] = {{0, &radiance}}, glowing[] = {{0, &radiance}, {1, glow}};
  developing(curve, glow != nullptr)
      .run(whole({developed_.width(), developed_.height()}), output, glow ? std::span<const Binding>(glowing) : plain);
}

void Resolver::outdate(const FrameRequest& shown) {
  const auto found = pictures_.find(shown.stream);
  if (found != pictures_.end() && found->second.view.pose != shown.pose) pictures_.erase(found);
}

std::vector<StreamId> Resolver::remembered() const {
  std::vector<StreamId> streams;
  for (const auto& [stream, picture] : pictures_) streams.push_back(stream);
  return streams;
}

std::size_t Resolver::bytes_of(StreamId stream) const {
  const auto found = pictures_.find(stream);
  if (found == pictures_.end() || !found->second.radiance) return 0;
  const Texture& closeness = found->second.closeness;
  return found->second.radiance.bytes() + (closeness ? closeness.bytes() : 0);
}

std::size_t Resolver::bytes() const {
  std::size_t sum = 0;
  for (const auto& [stream, picture] : pictures_) sum += bytes_of(stream);
  return sum;
}

void Resolver::reload(gpu::ShaderLibrary& shaders) {
  for (ScreenPass* pass : {&even_, &resolve_, &resolve_land_, &newly_seen_, &newly_seen_land_}) pass->reload(shaders);
  for (auto& [variant, pass] : develop_) pass.reload(shaders);
}

}  // namespace cloudscape::render
