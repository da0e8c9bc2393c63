// Which known name a misspelt one is nearest to.
#include <algorithm>
#include <cctype>
#include <numeric>
#include <vector>

#include "settings/json_text.h"

namespace cloudscape::settings {
namespace {

// Longer names than any of ours are not worth the quadratic search.
constexpr std::size_t max_name = 64;
constexpr std::size_t listed_names = 24;

std::string plain(std::string_view name) {
  std::string text(name);
  for (char& c : text) c = c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// Levenshtein's distance: insertions, deletions and replacements.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

// Part of a name ("extinction" of extinction_per_m, "fov" of vertical_fov_deg), or the name with something more.
bool is_part(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  return a.size() >= 3 && b.find(a) != std::string_view::npos;
}

}  // namespace

std::optional<std::string_view> nearest(std::string_view name, std::span<const std::string_view> known) {
  if (name.empty() || name.size() > max_name) return std::nullopt;
  const std::string wanted = plain(name);
  std::optional<std::string_view> best;
  std::pair<bool, std::size_t> best_rank{true, max_name};  // few edits before parts of names, then the fewest edits
  for (const std::string_view candidate : known) {
    const std::size_t distance = edits(wanted, plain(candidate));
    const bool near = distance <= std::max<std::size_t>(1, wanted.size() / 3);
    if (!near && !is_part(wanted, plain(candidate))) continue;
    const std::pair rank{!near, distance};
    if (rank < best_rank) best = candidate, best_rank = rank;
  }
  return best;
}

std::string suggestion(std::string_view name, std::span<const std::string_view> known) {
  if (const auto best = nearest(name, known)) return "did you mean " + std::string(*best) + "?";
  std::string list = "known are ";
  for (std::size_t i = 0; i < known.size() && i < listed_names; ++i) list += (i ? ", " : "") + std::string(known[i]);
  return known.empty() ? "none is known" : list + (known.size() > listed_names ? ", ..." : "");
}

}  // namespace cloudscape::settings
