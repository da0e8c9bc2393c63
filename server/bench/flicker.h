// Flicker: what a sequence of pictures does from frame to frame that the truth does not.
//
// e(t) is the luma (Rec. 709 weights on display values, 0..1) of a pixel in frame t minus that of the truth of the same
// moment; where the truth stands still, what it is does not matter. What changes slowly is an error, but no flicker:
// h(t) = (e(t) - (e(t-1) + e(t+1)) / 2) / sqrt(3/2) is 0 for a constant and for any steady drift, and has the standard
// deviation of e where e is noise that is new in every frame (it passes a frequency of f by
// (1 - cos(2 pi f / fps)) / sqrt(3/2): at 30 frames a second 0.4 at 5 Hz, 1 at 9, 1.6 at 15). A pixel's flicker is the
// root of the mean square of h over time, in percent of white.
#pragma once
#include <vector>

#include "bench/picture.h"

namespace cloudscape::bench {

// Of the picture's pixels.
struct FlickerFigure {
  double mean_percent = 0, p99_percent = 0;
  int frames = 0;
};

class Flicker {
 public:
  void add(const Picture& shown, const Picture& truth);  // display values; the next frame
  void add(const Picture& shown);                        // before a truth that stands still
  FlickerFigure figure() const;                          // zeros of fewer than three frames

 private:
  using Lumas = std::vector<double>;
  void add(Lumas difference);
  Lumas last_, before_last_;
  std::vector<double> sum_of_squares_;
  int frames_ = 0;
};

}  // namespace cloudscape::bench
