// The comparison with the truth as text.
#include "bench/truth_report.h"
#include "core/formatted.h"

namespace cloudscape::bench {
namespace {

std::string row_of(const ModelResult& model) {
  return formatted("  %-18s %7.1f%% %7.1f%% %8.3f %8.4f %8.4f %8.1f %7.1f%% %7.1f%%\n", model.model.c_str(),
                   100 * model.clouds.mean, 100 * model.clouds.p95, model.clouds.log_ratio, model.ldr_flip,
                   model.hdr_flip, model.psnr_db, 100 * model.whole.mean, 100 * model.tiles.mean);
}

std::string view_table(const ViewResult& view) {
  std::string text =
      formatted("\n%s: %s (clouds cover %.0f %%, the reference's own noise there %.1f %%)\n", view.name.c_str(),
                view.title.c_str(), 100 * view.cloud_share, 100 * view.reference_noise);
  text += formatted("  %-18s %8s %8s %8s %8s %8s %8s %8s %8s\n", "", "error", "p95", "ln ratio", "LDRFLIP", "HDRFLIP",
                    "PSNR dB", "whole", "tiles");
  for (const ModelResult& model : view.models) text += row_of(model);
  return text + row_of(view.noise_floor);
}

std::string summary_table(std::vector<ModelSummary> models, const ModelSummary& noise_floor) {
  std::string text = formatted("\nMeans over the views:\n  %-18s %8s %8s %9s %8s %8s %8s %8s %8s\n", "", "error", "p95",
                               "|ln rat.|", "LDRFLIP", "HDRFLIP", "PSNR dB", "whole", "tiles");
  models.push_back(noise_floor);
  for (const ModelSummary& model : models)
    text += formatted("  %-18s %7.1f%% %7.1f%% %9.3f %8.4f %8.4f %8.1f %7.1f%% %7.1f%%\n", model.model.c_str(),
                      100 * model.relative_error, 100 * model.relative_error_p95, model.abs_log_ratio, model.ldr_flip,
                      model.hdr_flip, model.psnr_db, 100 * model.whole_relative_error, 100 * model.tile_relative_error);
  return text;
}

std::string worst_table(const std::vector<ModelSummary>& models) {
  std::string text = formatted("\nWorst view:\n  %-18s %-28s %-28s %s\n", "", "error", "|ln ratio|", "LDRFLIP");
  for (const ModelSummary& model : models)
    text += formatted("  %-18s %6.1f%% %-20s %7.3f %-20s %7.4f %s\n", model.model.c_str(),
                      100 * model.worst_relative_error.value, model.worst_relative_error.view.c_str(),
                      model.worst_abs_log_ratio.value, model.worst_abs_log_ratio.view.c_str(),
                      model.worst_ldr_flip.value, model.worst_ldr_flip.view.c_str());
  return text;
}

std::string cost_table(const TruthResults& results, const std::vector<ModelSummary>& models) {
  if (models.empty() || !models.front().cost) return "";
  std::string text = formatted(
      "\nCost at %dx%d, quality interactive, one sample, mean over the views:\n"
      "  %-18s %12s %12s %18s\n",
      results.cost_size_px.width, results.cost_size_px.height, "", "CPU ms/frame", "wall ms/frame",
      "CPU ms/sun change");
  for (const ModelSummary& model : models)
    if (model.cost)
      text += formatted("  %-18s %12.1f %13.1f %18.1f\n", model.model.c_str(), model.cost->cpu_ms, model.cost->wall_ms,
                        model.cost->sun_change_cpu_ms);
  return text;
}

std::string target_table(const TruthResults& results, const std::vector<ModelSummary>& models) {
  std::string text = "\nTargets:\n";
  for (const TruthTarget& target : truth_targets()) {
    text += formatted("  %-30s at most %.2f:", target.name, target.limit);
    for (const ModelSummary& model : models)
      text += formatted("  %s%s %.3f %s", model.model.c_str(), model.model == results.default_model ? " (default)" : "",
                        target.value(model), target.met(model) ? "met" : "MISSED");
    text += "\n";
  }
  return text;
}

}  // namespace

std::string truth_tables(const TruthResults& results) {
  std::string text = formatted(
      "%zu views of %dx%d, reference of %d samples a pixel, models at quality %s with %d samples.\n"
      "error, p95: relative radiance error where the reference met cloud; ln ratio: of the mean radiances there; "
      "whole: error of the whole picture; tiles: of squares of 8x8 pixels, whose noise is an eighth; noise: what a "
      "perfect model would show, from the reference's own noise.\n",
      results.views.size(), results.size_px.width, results.size_px.height, results.reference_samples,
      std::string(name_of(results.quality)).c_str(), results.model_samples);
  for (const ViewResult& view : results.views) text += view_table(view);
  const std::vector<ModelSummary> models = summaries_of(results);
  return text + summary_table(models, noise_floor_of(results)) + worst_table(models) + cost_table(results, models) +
         target_table(results, models);
}

}  // namespace cloudscape::bench
