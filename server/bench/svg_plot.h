// Line plots as SVG, for tables of times and of phase functions.
#pragma once
#include <string>
#include <vector>

namespace cloudscape::bench {

struct PlotLine {
  std::string name;
  std::vector<double> x, y;  // equally many; where y is not finite, or not above 0 on a logarithmic axis, it has a gap
};

struct PlotMark {
  double x = 0;
  std::string name;
};

struct LinePlot {
  std::string title, x_label, y_label;
  bool logarithmic_y = false;
  std::vector<PlotLine> lines;       // at most 6
  std::vector<PlotMark> marks = {};  // dashed lines across the frame, each with its name at its right
};

// A whole SVG document: axes with round ticks, a grid, one colour a line, a legend. A y axis that is not logarithmic
// shows 0. Lines have no more than some thousands of points. Text is UTF-8 and is escaped. Throws
// std::invalid_argument: too many lines, or a line with more x than y or the reverse.
std::string svg_of(const LinePlot& plot);

}  // namespace cloudscape::bench
