#include "app/frame_progress.h"

#include <unistd.h>

#include <cstdio>
#include <string>

namespace cloudscape::app {
namespace {

std::string time_text(double seconds) {
  const int whole = static_cast<int>(seconds + 0.5), hours = whole / 3600, minutes = whole / 60 % 60;
  char text[32] = "";
  if (hours > 0)
    std::snprintf(text, sizeof text, "%d:%02d:%02d", hours, minutes, whole % 60);
  else
    std::snprintf(text, sizeof text, "%d:%02d", minutes, whole % 60);
  return text;
}

}  // namespace

FrameProgress::FrameProgress(int frames, int kept) : frames_(frames), kept_(kept), terminal_(isatty(STDERR_FILENO)) {
  if (kept_ > 0) std::fprintf(stderr, "%d of %d frames are there already\n", kept_, frames_);
  if (terminal_ && kept_ < frames_) show();
}

void FrameProgress::rendered() {
  ++rendered_;
  constexpr int lines = 10;  // in a log
  const int done = kept_ + rendered_;
  if (terminal_ || done == frames_ || done * lines / frames_ != (done - 1) * lines / frames_) show();
}

void FrameProgress::end() {
  if (terminal_ && kept_ < frames_) std::fputc('\n', stderr);
}

double FrameProgress::seconds_left() const {
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
  return passed.count() / rendered_ * (frames_ - kept_ - rendered_);
}

void FrameProgress::show() {
  constexpr int width = 30;
  const int done = kept_ + rendered_, filled = static_cast<int>(1.0 * width * done / frames_);
  const std::string left = rendered_ == 0 ? "" : ", " + time_text(seconds_left()) + " left";
  const std::string bar = "[" + std::string(filled, '#') + std::string(width - filled, '.') + "] ";
  std::fprintf(stderr, "%s%d of %d frames%s%s", terminal_ ? ("\r" + bar).c_str() : "", done, frames_, left.c_str(),
               terminal_ ? "\x1b[K" : "\n");  // clears what a longer line before left
  std::fflush(stderr);
}

}  // namespace cloudscape::app
