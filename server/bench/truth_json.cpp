// The comparison with the truth as JSON.
#include <nlohmann/json.hpp>

#include "bench/truth_report.h"
#include "core/version.h"

namespace cloudscape::bench {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const RadianceError& error) {
  return {{"pixels", error.pixels},
          {"relative_error_mean", error.mean},
          {"relative_error_p95", error.p95},
          {"log_ratio_of_means", error.log_ratio}};
}

Json json_of(const std::optional<TruthCost>& cost) {
  if (!cost) return nullptr;
  return {
      {"frame_cpu_ms", cost->cpu_ms}, {"frame_wall_ms", cost->wall_ms}, {"sun_change_cpu_ms", cost->sun_change_cpu_ms}};
}

Json json_of(const ModelResult& model) {
  return {{"model", model.model},          {"clouds", json_of(model.clouds)}, {"whole", json_of(model.whole)},
          {"tiles", json_of(model.tiles)}, {"ldr_flip", model.ldr_flip},      {"hdr_flip", model.hdr_flip},
          {"psnr_db", model.psnr_db},      {"cost", json_of(model.cost)}};
}

Json json_of(const ViewResult& view) {
  Json models = Json::array();
  for (const ModelResult& model : view.models) models.push_back(json_of(model));
  return {{"view", view.name},
          {"title", view.title},
          {"cloud_share", view.cloud_share},
          {"reference_noise", view.reference_noise},
          {"noise_floor", json_of(view.noise_floor)},
          {"models", std::move(models)}};
}

Json json_of(const Worst& worst) { return {{"value", worst.value}, {"view", worst.view}}; }

Json json_of(const ModelSummary& model) {
  Json targets = Json::array();
  for (const TruthTarget& target : truth_targets())
    targets.push_back(
        {{"target", target.name}, {"limit", target.limit}, {"value", target.value(model)}, {"met", target.met(model)}});
  return {{"model", model.model},
          {"relative_error_mean", model.relative_error},
          {"relative_error_p95", model.relative_error_p95},
          {"whole_relative_error_mean", model.whole_relative_error},
          {"tile_relative_error_mean", model.tile_relative_error},
          {"abs_log_ratio_of_means", model.abs_log_ratio},
          {"ldr_flip", model.ldr_flip},
          {"hdr_flip", model.hdr_flip},
          {"psnr_db", model.psnr_db},
          {"worst",
           {{"relative_error_mean", json_of(model.worst_relative_error)},
            {"abs_log_ratio_of_means", json_of(model.worst_abs_log_ratio)},
            {"ldr_flip", json_of(model.worst_ldr_flip)},
            {"hdr_flip", json_of(model.worst_hdr_flip)},
            {"psnr_db", json_of(model.worst_psnr_db)}}},
          {"cost", json_of(model.cost)},
          {"targets", std::move(targets)}};
}

template <class Values>
Json list_of(const Values& values) {
  Json list = Json::array();
  for (const auto& value : values) list.push_back(json_of(value));
  return list;
}

}  // namespace

std::string truth_json(const TruthResults& results, const Machine& machine) {
  const Json document{{"benchmark", "truth"},
                      {"program_version", version},
                      {"machine", json_of(machine)},
                      {"size_px", {results.size_px.width, results.size_px.height}},
                      {"reference_samples", results.reference_samples},
                      {"quality", name_of(results.quality)},
                      {"model_samples", results.model_samples},
                      {"cost_size_px", {results.cost_size_px.width, results.cost_size_px.height}},
                      {"cost_frames", results.cost_frames},
                      {"default_model", results.default_model},
                      {"summary", list_of(summaries_of(results))},
                      {"noise_floor", json_of(noise_floor_of(results))},
                      {"views", list_of(results.views)}};
  return document.dump(2) + "\n";
}

}  // namespace cloudscape::bench
