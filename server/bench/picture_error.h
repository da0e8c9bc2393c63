// How far a picture is from the truth, in numbers that need no eye.
#pragma once
#include "bench/picture.h"

namespace cloudscape::bench {

using Mask = std::vector<bool>;  // which pixels count

// Of a pixel: the sum over channels of |test - reference| over the sum of the reference's channels. A pixel without
// light in the reference does not count.
struct RadianceError {
  double mean = 0, p95 = 0;
  double log_ratio = 0;  // natural logarithm of the ratio of mean luminances, test over reference
  std::size_t pixels = 0;
};
RadianceError radiance_error(const Picture& reference, const Picture& test, const Mask& counted);

// Mean over the pixels of the relative standard error, channels added up as above: of a normal distribution, 0.8 times
// it is what the mean relative radiance error of a perfect picture would be.
double relative_noise(const Frame& traced, const Mask& counted);

// What a perfect model might be measured against: the picture with normal noise of its own standard errors on it, once
// more. Always the same.
Picture noisier(const Frame& traced);

// Peak signal to noise ratio of display values, dB; 100 where not even rounding differs.
double psnr_db(const Picture& reference, const Picture& test);

}  // namespace cloudscape::bench
