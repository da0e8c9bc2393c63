#include "render/resolver.h"

namespace cloudscape::render {

using gpu::Binding, gpu::Format, gpu::ScreenPass, gpu::Texture;

namespace {

Texture picture_texture(ImageSize size, const char* label) {
  Texture texture(Format::rgba16f, size.width, size.height, label);
  texture.sample_with(gpu::Filter::linear, gpu::Wrap::clamp);
  return texture;
}

// Makes it anew where its size is another.
void fit(Texture& texture, ImageSize size, const char* label) {
  if (texture && texture.width() == size.width && texture.height() == size.height) return;
  texture = Texture(Format::rgba8, size.width, size.height, label);
  texture.sample_with(gpu::Filter::linear, gpu::Wrap::clamp);
}

gpu::Rect whole(ImageSize size) { return {0, 0, size.width, size.height}; }

}  // namespace

Resolver::Resolver(const gpu::Context& context, gpu::ShaderLibrary& shaders)
    : context_(context),
      shaders_(shaders),
      range_(context, shaders, "render/resolve_range.glsl", {Format::rgba16f, Format::rgba16f}),
      resolve_(context, shaders, "render/resolve.glsl", {Format::rgba16f}),
      enlarge_(context, shaders, "render/enlarge.glsl", {Format::rgba8}),
      block_("resolve") {}

ResolvedFrame Resolver::begin(const FrameRequest& asked) const {
  const auto found = pictures_.find(asked.stream);
  return {asked, resolve_plan(asked), found == pictures_.end() ? 0 : found->second.frames};
}

Resolver::Shared& Resolver::shared_of(ImageSize kept, ImageSize marched) {
  constexpr std::size_t most_sizes = 4;  // tuned: sizes that alternate without being made anew each time
  if (shared_.size() > most_sizes) shared_.clear();
  Shared& shared = shared_[{kept.width, kept.height}];
  if (!shared.spare) shared.spare = picture_texture(kept, "spare picture");
  if (!shared.least || shared.least.width() != marched.width || shared.least.height() != marched.height) {
    shared.least = picture_texture(marched, "least radiance");
    shared.greatest = picture_texture(marched, "greatest radiance");
  }
  return shared;
}

void Resolver::resolve(const ResolvedFrame& frame, const Accumulation& marched, PassClock& clock) {
  const ResolvePlan& plan = frame.plan;
  Shared& shared = shared_of(plan.kept, plan.marched);
  Picture& picture = pictures_[frame.asked.stream];
  const KeptView now = kept_view(frame.asked, plan);
  const bool before = static_cast<bool>(picture.radiance);
  picture.block = resolve_block(plan, frame.frame, now, before ? std::optional(picture.view) : std::nullopt);
  block_.upload(picture.block);
  block_.bind();
  const Texture* range[] = {&shared.least, &shared.greatest};
  const Binding seen[] = {{0, &marched.radiance}, {1, &marched.depth}};
  range_.run(whole(plan.marched), range, seen);
  clock.lap("range");
  const Binding textures[] = {{0, &marched.radiance},
                              {1, &shared.least},
                              {2, &shared.greatest},
                              {3, before ? &picture.radiance : &marched.radiance}};
  const Texture* output[] = {&shared.spare};
  resolve_.run(whole(plan.kept), output, textures);
  clock.lap("resolve");
  std::swap(picture.radiance, shared.spare);
  if (shared.spare && (shared.spare.width() != plan.kept.width || shared.spare.height() != plan.kept.height))
    shared.spare = {};
  picture.view = now;
  picture.frames = frame.frame + 1;
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
  fit(display_, plan.shown, "shown picture");
  const Texture* glows = glow(frame, bloom, picture.radiance);
  if (glows) clock.lap("bloom");
  block_.upload(picture.block);  // other streams' frames may have come in between
  block_.bind();
  const bool same_size = plan.kept == plan.shown;
  if (!same_size) fit(developed_, plan.kept, "developed picture");
  develop(picture.radiance, glows, frame.asked.display.tone_curve, same_size ? display_ : developed_);
  clock.lap("develop");
  if (same_size) return display_;
  const Texture* output[] = {&display_};
  const Binding developed[] = {{0, &developed_}};
  enlarge_.run(whole(plan.shown), output, developed);
  clock.lap("enlarge");
  return display_;
}

ScreenPass& Resolver::developing(ToneCurve curve, bool glows) {
  const auto found = develop_.find({curve, glows});
  if (found != develop_.end()) return found->second;
  const std::string define = "#define TONE_CURVE " + std::to_string(static_cast<int>(curve)) + "\n";
  const char* path = glows ? "render/develop_bloom.glsl" : "render/develop.glsl";
  ScreenPass pass(context_, shaders_, path, {Format::rgba8}, define);
  return develop_.emplace(std::pair{curve, glows}, std::move(pass)).first->second;
}

void Resolver::develop(const Texture& radiance, const Texture* glow, ToneCurve curve, const Texture& target) {
  const Texture* output[] = {&target};
  const Binding plain[] = {{0, &radiance}}, glowing[] = {{0, &radiance}, {1, glow}};
  const ScreenPass& pass = developing(curve, glow != nullptr);
  pass.run({0, 0, target.width(), target.height()}, output, glow ? std::span<const Binding>(glowing) : plain);
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
  return found == pictures_.end() || !found->second.radiance ? 0 : found->second.radiance.bytes();
}

std::size_t Resolver::bytes() const {
  std::size_t sum = 0;
  for (const auto& [stream, picture] : pictures_) sum += bytes_of(stream);
  return sum;
}

void Resolver::reload(gpu::ShaderLibrary& shaders) {
  for (ScreenPass* pass : {&range_, &resolve_, &enlarge_}) pass->reload(shaders);
  for (auto& [variant, pass] : develop_) pass.reload(shaders);
}

}  // namespace cloudscape::render
