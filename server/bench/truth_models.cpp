#include "bench/truth_models.h"

#include <algorithm>

#include "bench/chosen_names.h"

namespace cloudscape::bench {
namespace {

// A model a line, with the parameters that documents have by default unless it names others.
const TruthModel models[] = {
    {"single", {.kind = LightModelKind::single}},
    {"olajos", {.kind = LightModelKind::olajos}},
    {"beer-octaves", {.kind = LightModelKind::beer_octaves}},
    {"beer-powder", {.kind = LightModelKind::beer_powder}},
    {"in-scatter-volume", {.kind = LightModelKind::in_scatter_volume}},
};

}  // namespace

std::span<const TruthModel> truth_models() { return models; }

std::vector<TruthModel> truth_models_of(const std::string& text) {
  std::vector<std::string_view> known;
  for (const TruthModel& model : models) known.push_back(model.name);
  std::vector<TruthModel> chosen;
  for (const std::string_view name : chosen_names("--models", text, known))
    chosen.push_back(*std::find_if(std::begin(models), std::end(models),
                                   [&](const TruthModel& model) { return model.name == name; }));
  return chosen;
}

}  // namespace cloudscape::bench
