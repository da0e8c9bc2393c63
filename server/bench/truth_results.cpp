#include "bench/truth_results.h"

#include <cmath>

namespace cloudscape::bench {
namespace {

// Adds up the views of one model.
struct Sum {
  ModelSummary summary;
  TruthCost cost;
  int views = 0, costs = 0;

  static void raise(Worst& worst, double value, const std::string& view) {
    if (worst.view.empty() || value > worst.value) worst = {value, view};
  }

  void add(const ModelResult& result, const std::string& view) {
    const double log_ratio = std::abs(result.clouds.log_ratio);
    ++views;
    summary.relative_error += result.clouds.mean;
    summary.relative_error_p95 += result.clouds.p95;
    summary.whole_relative_error += result.whole.mean;
    summary.tile_relative_error += result.tiles.mean;
    summary.abs_log_ratio += log_ratio;
    summary.ldr_flip += result.ldr_flip;
    summary.hdr_flip += result.hdr_flip;
    summary.psnr_db += result.psnr_db;
    raise(summary.worst_relative_error, result.clouds.mean, view);
    raise(summary.worst_abs_log_ratio, log_ratio, view);
    raise(summary.worst_ldr_flip, result.ldr_flip, view);
    raise(summary.worst_hdr_flip, result.hdr_flip, view);
    raise(summary.worst_psnr_db, -result.psnr_db, view);
    if (!result.cost) return;
    ++costs;
    cost.cpu_ms += result.cost->cpu_ms;
    cost.wall_ms += result.cost->wall_ms;
    cost.sun_change_cpu_ms += result.cost->sun_change_cpu_ms;
  }

  ModelSummary mean() {
    for (double* sum :
         {&summary.relative_error, &summary.relative_error_p95, &summary.whole_relative_error,
          &summary.tile_relative_error, &summary.abs_log_ratio, &summary.ldr_flip, &summary.hdr_flip, &summary.psnr_db})
      *sum /= views;
    summary.worst_psnr_db.value *= -1;
    if (costs) summary.cost = {cost.cpu_ms / costs, cost.wall_ms / costs, cost.sun_change_cpu_ms / costs};
    return summary;
  }
};

}  // namespace

std::vector<ModelSummary> summaries_of(const TruthResults& results) {
  std::vector<ModelSummary> summaries;
  if (results.views.empty()) return summaries;
  for (std::size_t i = 0; i < results.views.front().models.size(); ++i) {
    Sum sum;
    sum.summary.model = results.views.front().models[i].model;
    for (const ViewResult& view : results.views) sum.add(view.models[i], view.name);
    summaries.push_back(sum.mean());
  }
  return summaries;
}

ModelSummary noise_floor_of(const TruthResults& results) {
  Sum sum;
  for (const ViewResult& view : results.views)
    sum.summary.model = view.noise_floor.model, sum.add(view.noise_floor, view.name);
  return results.views.empty() ? ModelSummary{} : sum.mean();
}

const std::vector<TruthTarget>& truth_targets() {
  static const std::vector<TruthTarget> targets{
      {"mean relative radiance error", 0.15, [](const ModelSummary& model) { return model.relative_error; }},
      {"worst |log ratio of means|", 0.15, [](const ModelSummary& model) { return model.worst_abs_log_ratio.value; }},
      {"mean LDR-FLIP", 0.08, [](const ModelSummary& model) { return model.ldr_flip; }},
      {"worst LDR-FLIP", 0.12, [](const ModelSummary& model) { return model.worst_ldr_flip.value; }}};
  return targets;
}

}  // namespace cloudscape::bench
