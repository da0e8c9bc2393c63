// Which variants of a table were measured.
#pragma once
#include <algorithm>

#include "bench/track_times.h"

namespace cloudscape::bench {

inline const VariantTimes* find(const TrackTimes& track, TrackVariant variant) {
  const auto found = std::find_if(track.variants.begin(), track.variants.end(),
                                  [&](const VariantTimes& times) { return times.variant == variant; });
  return found == track.variants.end() ? nullptr : &*found;
}

// Whether there is something to compare: the base and one more.
inline bool measured(const TrackTimes& track, const ThesisTable& table) {
  return std::count_if(table.rows.begin(), table.rows.end(),
                       [&](const ThesisRow& row) { return find(track, row.variant) != nullptr; }) > 1;
}

}  // namespace cloudscape::bench
