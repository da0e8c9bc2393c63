// How pictures and windows of different shapes go together.
#pragma once
#include "core/frame.h"

namespace cloudscape::viewer {

struct Rectangle {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const Rectangle&) const = default;
};

// Where a picture goes in a window: whole, undistorted, in the middle.
Rectangle fit(ImageSize picture, ImageSize window);

// The largest size of the window's shape that the server renders; never more than the window's.
ImageSize within(ImageSize window, ImageSize limit);

}  // namespace cloudscape::viewer
