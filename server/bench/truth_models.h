// The real-time light models that are held against the path-traced reference.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/cloudscape_medium.h"

namespace cloudscape::bench {

struct TruthModel {
  const char* name;
  LightModel light;
  bool is_default() const { return light == LightModel{}; }
};
std::span<const TruthModel> truth_models();

// "all" or names with commas. Throws InvalidInput, with the nearest name.
std::vector<TruthModel> truth_models_of(const std::string& text);

}  // namespace cloudscape::bench
