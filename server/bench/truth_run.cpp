#include "bench/truth_run.h"

#include <algorithm>

#include "bench/flip.h"
#include "bench/truth_cost.h"
#include "bench/truth_pictures.h"

namespace cloudscape::bench {
namespace {

// tuned: less is a veil whose error is the sky's.
constexpr float least_cloud = 0.05F;

// What models are compared with.
struct Reference {
  Picture radiance, display;
  Mask clouds, cloud_tiles;
};

Frame reference_frame(const TruthRun& run, const TruthView& view) {
  const FrameRequest request = reference_request(view.request, run.size_px, run.reference_samples, run.seed);
  if (auto kept = run.references.load(request)) return std::move(*kept);
  run.tell(view.name + ": path tracing the reference, " + std::to_string(run.reference_samples) + " samples a pixel");
  Frame frame = run.render(request);
  run.references.store(frame);
  return frame;
}

Mask clouds_of(const Frame& traced) {
  Mask clouds;
  for (std::size_t i = 3; i < traced.radiance_rgba.size(); i += 4)
    clouds.push_back(traced.radiance_rgba[i] >= least_cloud);
  return clouds;
}

// Where the tile's mean is as of a cloud.
Mask cloud_tiles_of(const Frame& traced) {
  Picture alpha{traced.request.size_px, {}};
  for (std::size_t i = 3; i < traced.radiance_rgba.size(); i += 4) alpha.rgb.emplace_back(traced.radiance_rgba[i]);
  Mask clouds;
  for (const glm::dvec3& tile : tiles_of(alpha, tile_px).rgb) clouds.push_back(tile.x >= least_cloud);
  return clouds;
}

FrameRequest model_request(const TruthRun& run, const TruthView& view, const TruthModel& model) {
  auto lit = std::make_shared<Cloudscape>(*view.request.cloudscape);
  lit->medium.light_model = model.light;
  FrameRequest request = view.request;
  request.cloudscape = std::move(lit);
  request.size_px = run.size_px;
  request.quality = render_quality(run.quality);
  request.quality.samples = run.model_samples;
  request.content = FrameContent::radiance;
  return request;
}

void write_pictures(const TruthRun& run, const std::string& view, const std::string& column, const Picture& display,
                    const std::vector<double>& errors) {
  if (run.pictures.empty()) return;
  write_picture(run.pictures / picture_file(view, column), display);
  if (!errors.empty()) write_picture(run.pictures / flip_map_file(view, column), flip_map(errors, run.size_px));
}

// A picture and its figures, without its cost.
ModelResult compare(const TruthRun& run, const TruthView& view, const std::string& name, const Picture& radiance,
                    const Reference& reference) {
  const Picture display = display_picture(radiance, view.request.display);
  const std::vector<double> errors = ldr_flip(reference.display, display);
  ModelResult result;
  result.model = name;
  result.clouds = radiance_error(reference.radiance, radiance, reference.clouds);
  result.whole = radiance_error(reference.radiance, radiance, Mask(radiance.rgb.size(), true));
  result.tiles =
      radiance_error(tiles_of(reference.radiance, tile_px), tiles_of(radiance, tile_px), reference.cloud_tiles);
  result.ldr_flip = mean_of(errors);
  result.hdr_flip = mean_of(hdr_flip(reference.radiance, radiance));
  result.psnr_db = psnr_db(reference.display, display);
  write_pictures(run, view.name, name, display, errors);
  return result;
}

ModelResult compare_model(const TruthRun& run, const TruthView& view, const TruthModel& model,
                          const Reference& reference) {
  run.tell(view.name + ": " + model.name);
  const FrameRequest request = model_request(run, view, model);
  ModelResult result = compare(run, view, model.name, radiance_picture(run.render(request)), reference);
  if (run.cost_frames > 0) result.cost = truth_cost(run, request);
  return result;
}

ViewResult compare_all(const TruthRun& run, const TruthView& view) {
  const Frame traced = reference_frame(run, view);
  Reference reference{radiance_picture(traced), {}, clouds_of(traced), cloud_tiles_of(traced)};
  reference.display = display_picture(reference.radiance, view.request.display);
  write_pictures(run, view.name, "reference", reference.display, {});
  const auto clouds = static_cast<double>(std::count(reference.clouds.begin(), reference.clouds.end(), true));
  ViewResult result;
  result.name = view.name, result.title = view.title, result.description = view.description;
  result.cloud_share = clouds / static_cast<double>(reference.clouds.size());
  result.reference_noise = relative_noise(traced, reference.clouds);
  result.noise_floor = compare(run, view, "noise", noisier(traced), reference);
  for (const TruthModel& model : run.models) result.models.push_back(compare_model(run, view, model, reference));
  return result;
}

std::string default_model() {
  for (const TruthModel& model : truth_models())
    if (model.is_default()) return model.name;
  return "";
}

}  // namespace

TruthResults run_truth(const TruthRun& run) {
  TruthResults results{run.size_px,     run.cost_size_px, run.reference_samples, run.model_samples,
                       run.cost_frames, run.quality,      default_model(),       {}};
  for (const TruthView& view : run.views) results.views.push_back(compare_all(run, view));
  return results;
}

}  // namespace cloudscape::bench
