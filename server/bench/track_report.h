// What the run along the track says: tables for people beside the thesis' own, JSON, and plots.
#pragma once
#include <string>
#include <vector>

#include "bench/machine.h"
#include "bench/svg_plot.h"
#include "bench/track_times.h"

namespace cloudscape::bench {

// Tables 3.1 to 3.4 of the thesis, as far as their variants were measured, and the means of each section.
std::string track_tables(const TrackTimes& track);
// Everything, each frame's times included.
std::string track_json(const TrackTimes& track, const Machine& machine);

// Figures 3.1, 3.2, 3.4 and 3.5: times along the track. In place of 3.3, a picture, the ratio of 3.2's two curves.
// File name and plot; a figure of which a variant is missing is left out. One of each kind of time that there is.
struct Figure {
  std::string file;
  LinePlot plot;
};
std::vector<Figure> track_figures(const TrackTimes& track);

}  // namespace cloudscape::bench
