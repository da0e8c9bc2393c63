// Which known name a misspelt one is nearest to.
#include <algorithm>
#include <cctype>
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

// Levenshtein's distance (insertions, deletions, replacements) where two neighbours that changed places count once.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> distance(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) distance[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) distance[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = distance[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      distance[i][j] = std::min({replaced, distance[i - 1][j] + 1, distance[i][j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        distance[i][j] = std::min(distance[i][j], distance[i - 2][j - 2] + 1);
    }
  return distance.back().back();
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
