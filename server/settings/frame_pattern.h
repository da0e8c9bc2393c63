// The names of a sequence's files: "flight/frame_####.png", where the run of # stands for the frame's number.
#pragma once
#include <string>

namespace cloudscape::settings {

class FramePattern {
 public:
  // Throws InvalidInput that names --output: there must be one run of #, in the file's name.
  explicit FramePattern(const std::string& text);
  // The number is padded with zeros to the length of the run; a longer one is written whole.
  std::string file(int number) const;

 private:
  std::string before_, after_;
  std::size_t digits_ = 0;
};

}  // namespace cloudscape::settings
