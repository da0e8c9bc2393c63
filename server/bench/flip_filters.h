// The filters of FLIP: what the eye does not resolve is blurred away, and edges and points are found.
#pragma once
#include <span>
#include <vector>

#include "core/frame.h"

namespace cloudscape::bench {

using Plane = std::vector<double>;   // one number a pixel, rows from the top
using Kernel = std::vector<double>;  // of odd length, about its middle

// Along the rows and then along the columns. Beyond the border stands the border's value.
Plane filtered(const Plane& plane, const ImageSize& size_px, const Kernel& along_x, const Kernel& along_y);

// A contrast sensitivity in space: the sum over lobes of a sqrt(pi / b) exp(-pi^2 r^2 / b), r in degrees, sum 1.
struct SensitivityLobe {
  double a = 0, b = 0;
};
Plane blurred(const Plane& plane, const ImageSize& size_px, std::span<const SensitivityLobe> lobes,
              double pixels_per_degree);

// A Gaussian as wide as the eye's detectors of edges, and its first and second derivative. The positive weights of each
// add up to 1; the negative ones, where there are such, to -1.
struct FeatureKernels {
  Kernel gaussian, slope, curvature;
};
FeatureKernels feature_kernels(double pixels_per_degree);

}  // namespace cloudscape::bench
