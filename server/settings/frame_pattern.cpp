#include "settings/frame_pattern.h"

#include <algorithm>

#include "core/error.h"

namespace cloudscape::settings {

FramePattern::FramePattern(const std::string& text) {
  const std::size_t name = text.rfind('/') == std::string::npos ? 0 : text.rfind('/') + 1;
  const std::size_t first = text.find('#'), end = std::min(text.find_first_not_of('#', first), text.size());
  if (first == std::string::npos || first < name || text.find('#', end) != std::string::npos)
    throw InvalidInput("--output", "is '" + text +
                                       "': the names of several frames must have one run of # for the number, such as "
                                       "frame_####.png");
  before_ = text.substr(0, first), after_ = text.substr(end);
  digits_ = end - first;
}

std::string FramePattern::file(int number) const {
  const std::string digits = std::to_string(number);
  return before_ + std::string(digits_ - std::min(digits_, digits.size()), '0') + digits + after_;
}

}  // namespace cloudscape::settings
