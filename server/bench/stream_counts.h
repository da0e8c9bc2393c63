// How many streams a machine carries: the search for the greatest number that holds a frame rate, and what it says.
#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bench/flight_figures.h"
#include "bench/machine.h"

namespace cloudscape::bench {

// So many streams at once.
struct StreamsFigures {
  int streams = 0;
  std::vector<FlightFigures> each;
  double busy_share = 0;    // of the time that the renderer was at work or waited for its device
  double cpu_ms = 0;        // of a frame
  double stream_bytes = 0;  // that the renderer keeps for each, mean
  int sky_bakes = 0;        // tables of the sky computed in a second
};
StreamsFigures streams_figures(const std::vector<std::vector<FlownFrame>>& frames, double seconds);

bool holds(const StreamsFigures& streams, double fps);  // each of them does
// The stream that is worst off: by its median interval; by how its p95 interval compares.
FlightFigures worst_of(const StreamsFigures& streams);

// The greatest number from 0 to `most` that `holds`, which no number above one that does not, does: asks for 1, 2, 4
// and so on, and then halves what is between.
int greatest(int most, const std::function<bool(int)>& holds);

constexpr double asked_fps[] = {30, 60};

// Measures only what the search asks for, each number once.
struct StreamsResults {
  std::map<int, StreamsFigures> measured;
  std::map<int, int> held;  // by frames a second
};
StreamsResults find_streams(int most, const std::function<StreamsFigures(int)>& measure);

struct StreamsSubject {
  std::string cloudscape, path;
  ImageSize size_px;
  int most = 0;  // that the search may ask for; 0: one number was given
};
std::string streams_table(const StreamsResults& results, const StreamsSubject& subject);
std::string streams_json(const StreamsResults& results, const StreamsSubject& subject, const Machine& machine);

}  // namespace cloudscape::bench
