// The views that light models are held against the truth in: config/truth.
#pragma once
#include <string>
#include <vector>

#include "core/frame.h"
#include "settings/cloudscape_json.h"

namespace cloudscape::bench {

struct TruthView {
  std::string name, title, description;
  FrameRequest request;  // its cloudscape, pose, lens, exposure and march
};

// "all" or names with commas. Throws InvalidInput, with the nearest name.
std::vector<TruthView> truth_views_of(const std::string& text, const settings::CloudscapeLibrary& library);

}  // namespace cloudscape::bench
