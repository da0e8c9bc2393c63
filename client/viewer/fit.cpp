// Sizes of pictures and windows.
#include "viewer/fit.h"

#include <algorithm>

namespace cloudscape::viewer {

Rectangle fit(ImageSize picture, ImageSize window) {
  const double scale = std::min(static_cast<double>(window.width) / std::max(picture.width, 1),
                                static_cast<double>(window.height) / std::max(picture.height, 1));
  const int width = static_cast<int>(picture.width * scale + 0.5),
            height = static_cast<int>(picture.height * scale + 0.5);
  return {(window.width - width) / 2, (window.height - height) / 2, width, height};
}

ImageSize within(ImageSize window, ImageSize limit) {
  const double scale = std::min({1.0, static_cast<double>(limit.width) / std::max(window.width, 1),
                                 static_cast<double>(limit.height) / std::max(window.height, 1)});
  return {std::max(static_cast<int>(window.width * scale), 1), std::max(static_cast<int>(window.height * scale), 1)};
}

}  // namespace cloudscape::viewer
