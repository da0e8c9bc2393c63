#include "bake/phase_cache.h"

#include <cstring>
#include <string>

namespace cloudscape::bake {
namespace {

constexpr std::string_view magic = "cloudscape phase 1\n";

std::string name_of(const PhaseRecipe& recipe) { return phase_key(recipe) + ".phase"; }

// All numbers of a table in their order in the file: of each colour the optics, then the texels.
void for_each_number(auto& table, auto&& visit) {
  for (std::size_t colour = 0; colour < 3; ++colour) {
    auto& optics = table.optics[colour];
    visit(optics.extinction_efficiency), visit(optics.single_scattering_albedo), visit(optics.asymmetry_g);
    for (auto& value : table.phase_per_sr[colour]) visit(value);
  }
}

std::string payload_of(const PhaseTable& table) {
  std::string payload;
  for_each_number(table, [&](double number) { payload.append(reinterpret_cast<const char*>(&number), sizeof number); });
  return payload;
}

// Empty if the payload has not the size of a table.
std::optional<PhaseTable> table_of(const PhaseRecipe& recipe, std::string_view payload) {
  if (payload.size() != 3 * (3 + phase_table_texels) * sizeof(double)) return std::nullopt;
  PhaseTable table{recipe, {}, {}};
  for (std::vector<double>& texels : table.phase_per_sr) texels.resize(phase_table_texels);
  for_each_number(table, [&](double& number) {
    std::memcpy(&number, payload.data(), sizeof number);
    payload.remove_prefix(sizeof number);
  });
  return table;
}

}  // namespace

std::filesystem::path PhaseCache::path_of(const PhaseRecipe& recipe) const { return files_.path_of(name_of(recipe)); }

std::optional<PhaseTable> PhaseCache::load(const PhaseRecipe& recipe) const {
  std::optional<PhaseTable> table;
  files_.load(name_of(recipe), magic, [&](std::string_view payload) {
    table = table_of(recipe, payload);
    return table.has_value();
  });
  return table;
}

void PhaseCache::store(const PhaseTable& table) const { files_.store(name_of(table.recipe), magic, payload_of(table)); }

}  // namespace cloudscape::bake
