#include "core/enlarge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace cloudscape {
namespace {

constexpr int channels = 4, one = 64;  // weights are 64ths: four products with bytes fit into 16 bits
constexpr std::size_t chunk = 16;      // bytes that are worked on at once

// What a pixel of the large picture is made of: four pixels of the small one.
struct Taps {
  int first = 0;
  std::array<std::int16_t, 4> weights{};
};

// Mitchell and Netravali's cubic (Reconstruction Filters in Computer Graphics, 1988). tuned: on their line
// of the good ones (b + 2c = 1), between Catmull and Rom's (b = 0), whose sharper pictures show each single ray as a
// grain and each pixel of an edge as a stair, and the B-spline (b = 1), which blurs land.
double share_at(double distance_px) {
  constexpr double b = 2.0 / 3, c = (1 - b) / 2;
  const double x = std::abs(distance_px);
  if (x < 1) return ((12 - 9 * b - 6 * c) * x * x * x + (-18 + 12 * b + 6 * c) * x * x + 6 - 2 * b) / 6;
  return ((-b - 6 * c) * x * x * x + (6 * b + 30 * c) * x * x + (-12 * b - 48 * c) * x + 8 * b + 24 * c) / 6;
}

Taps taps_at(double place_px) {
  const double middle = std::floor(place_px), f = place_px - middle;
  const auto weight = [](double distance) { return static_cast<std::int16_t>(std::lround(one * share_at(distance))); };
  Taps taps{static_cast<int>(middle) - 1, {weight(1 + f), 0, weight(1 - f), weight(2 - f)}};
  taps.weights[1] = static_cast<std::int16_t>(one - taps.weights[0] - taps.weights[2] - taps.weights[3]);
  return taps;
}

// Of every `factor`-th pixel, beginning with each of the first ones.
std::vector<Taps> phases_of(int factor, double margin_px) {
  std::vector<Taps> phases;
  for (int phase = 0; phase < factor; ++phase) phases.push_back(taps_at((phase + 0.5) / factor + margin_px - 0.5));
  return phases;
}

using Bytes = std::vector<std::uint8_t>;
std::size_t whole_chunks(std::size_t bytes) { return (bytes + chunk - 1) / chunk * chunk; }

// What a vector unit works on at once (GCC's and Clang's vector types).
using Bytes16 [[gnu::vector_size(16)]] = std::uint8_t;
using Shorts16 [[gnu::vector_size(32)]] = std::int16_t;

[[gnu::always_inline]] inline Shorts16 loaded(const std::uint8_t* bytes) {
  Bytes16 loaded;
  std::memcpy(&loaded, bytes, sizeof loaded);
  return __builtin_convertvector(loaded, Shorts16);
}
// The weighted sum of four rows of `bytes` bytes (whole chunks) into `sum`.
void combine(const std::array<const std::uint8_t*, 4>& rows, const std::array<std::int16_t, 4>& weights,
             std::size_t bytes, std::uint8_t* sum) {
  const auto [a, b, c, d] = rows;
  const auto [weight_a, weight_b, weight_c, weight_d] = weights;
  for (std::size_t i = 0; i < bytes; i += chunk) {
    Shorts16 value = loaded(a + i) * weight_a + loaded(b + i) * weight_b + loaded(c + i) * weight_c +
                     loaded(d + i) * weight_d + one / 2;
    value >>= 6;
    value = value < 0 ? Shorts16{} : value;
    value = value > 255 ? Shorts16{} + 255 : value;
    const Bytes16 stored = __builtin_convertvector(value, Bytes16);
    std::memcpy(sum + i, &stored, sizeof stored);
  }
}

// tuned: a picture of half the width has few grains, and what is so small is more often there (1 % of LDR-FLIP).
constexpr int least_factor_without_grains = 3;

// Each channel of a pixel within those of the four beside it, as they were: a ray that met a silver edge alone, or a
// gap in it, is a grain of this size. The picture's edge stays as it is.
Bytes without_grains(std::span<const std::uint8_t> rgba, ImageSize size) {
  Bytes from(rgba.begin(), rgba.end());
  from.resize(from.size() + chunk);  // the last chunk of a row reads and writes beyond it
  Bytes to = from;
  const std::size_t row_bytes = static_cast<std::size_t>(size.width) * channels, last = row_bytes - channels;
  const auto bytes_at = [&](std::size_t place) {
    Bytes16 bytes;
    std::memcpy(&bytes, from.data() + place, sizeof bytes);
    return bytes;
  };
  const auto lesser = [](Bytes16 a, Bytes16 b) { return a < b ? a : b; };
  const auto greater = [](Bytes16 a, Bytes16 b) { return a > b ? a : b; };
  for (std::size_t row = row_bytes; row + row_bytes < rgba.size(); row += row_bytes) {
    for (std::size_t i = row + channels; i < row + last; i += chunk) {
      const Bytes16 left = bytes_at(i - channels), right = bytes_at(i + channels), above = bytes_at(i - row_bytes),
                    below = bytes_at(i + row_bytes);
      const Bytes16 least = lesser(lesser(left, right), lesser(above, below)),
                    most = greater(greater(left, right), greater(above, below)),
                    kept = lesser(greater(bytes_at(i), least), most);
      std::memcpy(to.data() + i, &kept, sizeof kept);
    }
    std::memcpy(to.data() + row + last, from.data() + row + last, chunk);
  }
  return to;
}

// A row of the small picture made as wide as the large one.
class Widener {
 public:
  Widener(const Enlargement& enlargement, int to_width)
      : from_(enlargement.from_px.width),
        to_(to_width),
        factor_(enlargement.factor),
        phases_(phases_of(factor_, enlargement.margin_px.x)),
        columns_((to_ + factor_ - 1) / factor_),
        padded_((static_cast<std::size_t>(std::max(from_, columns_)) + 2 * pad) * channels + 2 * chunk),
        widened_(whole_chunks(static_cast<std::size_t>(columns_) * channels)) {}

  void widen(const std::uint8_t* row, std::uint8_t* wide) {
    pad_row(row);
    for (int phase = 0; phase < factor_; ++phase) {
      const Taps& taps = phases_[static_cast<std::size_t>(phase)];
      const std::uint8_t* first = padded_.data() + (taps.first + pad) * channels;
      combine({first, first + channels, first + 2 * channels, first + 3 * channels}, taps.weights, widened_.size(),
              widened_.data());
      for (int column = 0, x = phase; x < to_; ++column, x += factor_)
        std::memcpy(wide + x * channels, widened_.data() + column * channels, channels);
    }
  }

 private:
  static constexpr int pad = 4;  // pixels on each side that repeat the edge's

  void pad_row(const std::uint8_t* row) {
    const auto pixel = [&](int x) { return padded_.data() + (x + pad) * channels; };
    std::memcpy(pixel(0), row, static_cast<std::size_t>(from_) * channels);
    const int end = static_cast<int>(padded_.size()) / channels - pad;
    for (int x = -pad; x < 0; ++x) std::memcpy(pixel(x), row, channels);
    for (int x = from_; x < end; ++x) std::memcpy(pixel(x), row + (from_ - 1) * channels, channels);
  }

  int from_, to_, factor_;
  std::vector<Taps> phases_;
  int columns_;
  Bytes padded_, widened_;
};

}  // namespace

std::vector<std::uint8_t> enlarged(std::span<const std::uint8_t> rgba, const Enlargement& enlargement,
                                   ImageSize to_px) {
  const ImageSize from = enlargement.from_px;
  Bytes even;
  if (enlargement.factor >= least_factor_without_grains) rgba = even = without_grains(rgba, from);
  const std::size_t from_bytes = static_cast<std::size_t>(from.width) * channels,
                    to_bytes = static_cast<std::size_t>(to_px.width) * channels, row_bytes = whole_chunks(to_bytes);
  Bytes wide(row_bytes * static_cast<std::size_t>(from.height));
  Widener widener(enlargement, to_px.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(from.height); ++y)
    widener.widen(rgba.data() + y * from_bytes, wide.data() + y * row_bytes);
  const auto row = [&](int y) {
    return wide.data() + static_cast<std::size_t>(std::clamp(y, 0, from.height - 1)) * row_bytes;
  };
  const std::vector<Taps> phases = phases_of(enlargement.factor, enlargement.margin_px.y);
  Bytes large(to_bytes * static_cast<std::size_t>(to_px.height)), sum(row_bytes);
  for (int y = 0; y < to_px.height; ++y) {
    const Taps& taps = phases[static_cast<std::size_t>(y % enlargement.factor)];
    const int first = taps.first + y / enlargement.factor;
    combine({row(first), row(first + 1), row(first + 2), row(first + 3)}, taps.weights, row_bytes, sum.data());
    std::memcpy(large.data() + static_cast<std::size_t>(y) * to_bytes, sum.data(), to_bytes);
  }
  return large;
}

void enlarge(Frame& frame) {
  if (!frame.enlargement) return;
  frame.display_rgba = enlarged(frame.display_rgba, *frame.enlargement, frame.request.size_px);
  frame.enlargement.reset();
}

}  // namespace cloudscape
