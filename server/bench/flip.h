// FLIP: how different two pictures look to somebody who flips between them. LDR-FLIP: Andersson et al. 2020, "FLIP: A
// Difference Evaluator for Alternating Images". HDR-FLIP: Andersson et al. 2021, "Visualizing Errors in Rendered High
// Dynamic Range Images".
#pragma once
#include <vector>

#include "bench/picture.h"

namespace cloudscape::bench {

// A display 3840 pixels and 0.7 m wide, seen from 0.7 m (Andersson et al. 2020): 67 pixels a degree.
constexpr double flip_pixels_per_degree = 3840 * 3.14159265358979323846 / 180;

// 0 (the same) to 1 of each pixel. Both of display values, of one size. Symmetric.
std::vector<double> ldr_flip(const Picture& reference, const Picture& test,
                             double pixels_per_degree = flip_pixels_per_degree);

// Exposures in which a radiance is judged: from that which brings its brightest pixel to 0.85 through the ACES curve to
// that which does so with its median, about one stop apart.
struct ExposureRange {
  double start_ev = 0, stop_ev = 0;
  int count = 1;
  double exposure_ev(int i) const { return count > 1 ? start_ev + i * (stop_ev - start_ev) / (count - 1) : start_ev; }
};
ExposureRange exposure_range(const Picture& reference);

// The worst LDR-FLIP of each pixel over the exposures. Both linear, of one size; not symmetric, since the reference
// chooses the exposures.
std::vector<double> hdr_flip(const Picture& reference, const Picture& test,
                             double pixels_per_degree = flip_pixels_per_degree);

}  // namespace cloudscape::bench
