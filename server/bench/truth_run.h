// Renders the views' references and models, and compares them.
#pragma once
#include <functional>

#include "bench/track_times.h"
#include "bench/truth_models.h"
#include "bench/truth_reference.h"
#include "bench/truth_results.h"
#include "bench/truth_views.h"

namespace cloudscape::bench {

struct TruthRun {
  std::vector<TruthView> views;
  std::vector<TruthModel> models;
  ImageSize size_px{256, 144}, cost_size_px{640, 360};
  int reference_samples = 256;
  std::uint32_t seed = 1;  // of the reference
  Quality quality = Quality::high;
  int model_samples = 32;
  int cost_frames = 7;  // 0: costs are not measured
  KeptReferences references{{}};
  std::filesystem::path pictures;  // folder for PNGs; empty: none are written
  std::function<Frame(const FrameRequest&)> render;
  Draw draw;                                                          // renders and measures
  std::function<void(const std::string&)> tell = [](const auto&) {};  // what is done next, a line
};

TruthResults run_truth(const TruthRun& run);

}  // namespace cloudscape::bench
