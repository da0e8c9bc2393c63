// How far a sequence or a path-traced picture is, on stderr: one line rewritten in place on a terminal, a line now and
// then elsewhere.
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

class SampleProgress {
 public:
  SampleProgress();
  void show(double share, int samples);  // 0..1, and what each pixel has
  void end();                            // ends the line

 private:
  const bool terminal_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point shown_{};
  int tenths_ = 0;
};

}  // namespace cloudscape::app
