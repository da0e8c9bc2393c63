// What `cloudscape bench truth` finds: each model in each view against the path-traced reference, and what they add up
// to.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "bench/picture_error.h"
#include "core/quality.h"

namespace cloudscape::bench {

// Of a frame of one sample at the quality interactive, the camera at rest: medians. sun_change_cpu_ms: what the frame
// after the sun moved by a degree takes more. CPU time is of all threads.
struct TruthCost {
  double cpu_ms = 0, wall_ms = 0, sun_change_cpu_ms = 0;
};

constexpr int tile_px = 8;  // tuned: an eighth of the noise, and still a cloud's own light and shade

struct ModelResult {
  std::string model;
  RadianceError clouds, whole;  // over the pixels where the reference met cloud, and over all
  // Over squares of tile_px pixels a side where it did: the reference's noise, which at a pixel is skewed and great,
  // averages out.
  RadianceError tiles;
  double ldr_flip = 0, hdr_flip = 0, psnr_db = 0;
  std::optional<TruthCost> cost;  // nullopt: not measured
};

struct ViewResult {
  std::string name, title, description;
  double cloud_share = 0;      // of the pixels
  double reference_noise = 0;  // relative_noise over the clouds
  // The reference with its own noise on it once more: about what a perfect model would show. No cost.
  ModelResult noise_floor;
  std::vector<ModelResult> models;
};

struct TruthResults {
  ImageSize size_px, cost_size_px;
  int reference_samples = 0, model_samples = 0, cost_frames = 0;
  Quality quality = Quality::high;
  std::string default_model;
  std::vector<ViewResult> views;
};

struct Worst {
  double value = 0;
  std::string view;
};

// Of a model, over the views.
struct ModelSummary {
  std::string model;
  double relative_error = 0, relative_error_p95 = 0, whole_relative_error = 0,
         tile_relative_error = 0;  // means of the views' figures
  double abs_log_ratio = 0, ldr_flip = 0, hdr_flip = 0, psnr_db = 0;
  Worst worst_relative_error, worst_abs_log_ratio, worst_ldr_flip, worst_hdr_flip, worst_psnr_db;
  std::optional<TruthCost> cost;  // means
};
std::vector<ModelSummary> summaries_of(const TruthResults& results);
ModelSummary noise_floor_of(const TruthResults& results);

// What the default model must reach.
struct TruthTarget {
  const char* name;
  double limit;
  double (*value)(const ModelSummary& summary);
  bool met(const ModelSummary& summary) const { return value(summary) <= limit; }
};
const std::vector<TruthTarget>& truth_targets();

}  // namespace cloudscape::bench
