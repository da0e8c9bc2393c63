// A picture that is made larger shows the same.
#include "core/enlarge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cloudscape {
namespace {

using Bytes = std::vector<std::uint8_t>;

template <class Value>
Bytes picture(ImageSize size, Value value) {
  Bytes rgba;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      for (int c = 0; c < 4; ++c) rgba.push_back(static_cast<std::uint8_t>(value(x, y, c)));
  return rgba;
}

// Of whatever value, at the edges too, by each factor, and where the large picture ends within a small pixel.
TEST(EnlargeTest, even_picture_stays_as_it_is) {
  for (const int factor : {2, 3, 4})
    for (const int value : {0, 1, 127, 254, 255})
      for (const ImageSize to : {ImageSize{39, 21}, ImageSize{40, 24}, ImageSize{1, 1}}) {
        const ImageSize from{(to.width + factor - 1) / factor + 1, (to.height + factor - 1) / factor};
        const Enlargement how{from, factor, {0.5, 0}};
        const Bytes large = enlarged(picture(from, [&](int, int, int) { return value; }), how, to);
        EXPECT_EQ(large, picture(to, [&](int, int, int) { return value; })) << value << " by " << factor;
      }
}

// The cubic goes straight along those of a line; each channel by itself.
TEST(EnlargeTest, slope_stays_straight_and_in_its_place) {
  const ImageSize from{20, 12}, to{56, 33};
  const glm::dvec2 margin(0.5 * (20 - 56 / 3.0), 0.5 * (12 - 33 / 3.0));
  const auto slope = [](double x, double y, int c) { return 20 + 6 * x + 5 * y + 10 * c; };
  const Bytes large = enlarged(picture(from, slope), {from, 3, margin}, to);
  ASSERT_EQ(large.size(), 56U * 33 * 4);
  for (int y = 3; y < to.height - 3; ++y)
    for (int x = 3; x < to.width - 3; ++x)
      for (int c = 0; c < 4; ++c) {
        const double place_x = (x + 0.5) / 3 + margin.x - 0.5, place_y = (y + 0.5) / 3 + margin.y - 0.5;
        ASSERT_NEAR(large[4 * (static_cast<std::size_t>(y) * 56 + x) + c], slope(place_x, place_y, c), 1.3)
            << x << " " << y << " " << c;
      }
}

// An edge may overshoot in a cubic, and a byte must not wrap around there.
TEST(EnlargeTest, hard_edge_does_not_wrap_around) {
  const ImageSize from{16, 16}, to{64, 64};
  const Bytes large =
      enlarged(picture(from, [](int x, int y, int) { return (x < 8) == (y < 8) ? 255 : 0; }), {from, 4, {0, 0}}, to);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      if (std::abs(x - 31.5) < 4 || std::abs(y - 31.5) < 4) continue;
      const int value = large[4 * static_cast<std::size_t>(y * 64 + x)];
      ASSERT_EQ(value, (x < 32) == (y < 32) ? 255 : 0) << x << " " << y;
    }
}

// The cubic does not make much of a pixel of its own: it fades into its neighbours, and is not lost.
TEST(EnlargeTest, lone_pixel_is_softened) {
  const ImageSize from{16, 16}, to{32, 32};
  const auto large =
      enlarged(picture(from, [](int x, int y, int) { return x == 8 && y == 8 ? 200 : 0; }), {from, 2, {0, 0}}, to);
  const int brightest = *std::ranges::max_element(large);
  EXPECT_LT(brightest, 0.65 * 200);
  EXPECT_GT(brightest, 0.4 * 200);
}

// A ray that met a silver edge, or a gap in it, alone. Two of them are a thing, and so is all that touches the
// picture's edge, whatever the size.
TEST(EnlargeTest, grain_is_lost_where_it_would_be_large) {
  for (const ImageSize from : {ImageSize{3, 3}, ImageSize{9, 4}, ImageSize{18, 12}, ImageSize{21, 9}}) {
    const ImageSize to{4 * from.width, 4 * from.height};
    const auto large = [&](auto value) { return enlarged(picture(from, value), {from, 4, {0, 0}}, to); };
    const auto even = picture(to, [](int, int, int) { return 90; });
    for (int at_y = 0; at_y < from.height; ++at_y)
      for (int at_x = 0; at_x < from.width; ++at_x) {
        const bool inside = at_x > 0 && at_y > 0 && at_x < from.width - 1 && at_y < from.height - 1;
        const auto is_grain = [&](int x, int y) { return x == at_x && y == at_y; };
        for (const int value : {0, 250}) {
          EXPECT_EQ(large([&](int x, int y, int) { return is_grain(x, y) ? value : 90; }) == even, inside)
              << at_x << " " << at_y << " of " << from.width << " x " << from.height;
          EXPECT_NE(large([&](int x, int y, int) { return is_grain(x, y) || is_grain(x, y - 1) ? value : 90; }), even);
        }
      }
  }
}

TEST(EnlargeTest, frame_that_was_not_kept_small_is_left_alone) {
  Frame frame;
  frame.request.size_px = {2, 1};
  frame.display_rgba = {1, 2, 3, 4, 5, 6, 7, 8};
  enlarge(frame);
  EXPECT_EQ(frame.display_rgba, (Bytes{1, 2, 3, 4, 5, 6, 7, 8}));
  frame.request.size_px = {4, 2};
  frame.enlargement = Enlargement{{2, 1}, 2, {0, 0}};
  enlarge(frame);
  EXPECT_EQ(frame.display_rgba.size(), 32U);
  EXPECT_FALSE(frame.enlargement);
}

}  // namespace
}  // namespace cloudscape
