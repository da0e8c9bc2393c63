// How far a sequence is, on stderr: one line rewritten in place on a terminal, a line now and then elsewhere.
#pragma once
#include <chrono>

namespace cloudscape::app {

class FrameProgress {
 public:
  // `kept` of the frames are there already.
  FrameProgress(int frames, int kept);
  void rendered();  // one more
  // Ends the line.
  void end();

 private:
  void show();
  double seconds_left() const;

  const int frames_, kept_;
  const bool terminal_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  int rendered_ = 0;
};

}  // namespace cloudscape::app
