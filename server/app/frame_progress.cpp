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

std::string bar_text(double share) {
  constexpr int width = 30;
  const int filled = static_cast<int>(width * share);
  return "[" + std::string(filled, '#') + std::string(width - filled, '.') + "] ";
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
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

double FrameProgress::seconds_left() const { return seconds_since(start_) / rendered_ * (frames_ - kept_ - rendered_); }

void FrameProgress::show() {
  const int done = kept_ + rendered_;
  const std::string left = rendered_ == 0 ? "" : ", " + time_text(seconds_left()) + " left";
  const std::string bar = bar_text(1.0 * done / frames_);
  std::fprintf(stderr, "%s%d of %d frames%s%s", terminal_ ? ("\r" + bar).c_str() : "", done, frames_, left.c_str(),
               terminal_ ? "\x1b[K" : "\n");  // clears what a longer line before left
  std::fflush(stderr);
}

SampleProgress::SampleProgress() : terminal_(isatty(STDERR_FILENO)) {}

void SampleProgress::show(double share, int samples) {
  const int tenths = static_cast<int>(10 * share);
  if (terminal_ ? seconds_since(shown_) < 0.2 : tenths == tenths_) return;  // often enough to be seen moving
  shown_ = std::chrono::steady_clock::now();
  tenths_ = tenths;
  const std::string left = share > 0.02 ? ", " + time_text(seconds_since(start_) * (1 - share) / share) + " left" : "";
  std::fprintf(stderr, "%s%.0f %%, %d samples%s%s", terminal_ ? ("\r" + bar_text(share)).c_str() : "", 100 * share,
               samples, left.c_str(), terminal_ ? "\x1b[K" : "\n");
  std::fflush(stderr);
}

void SampleProgress::end() {
  if (terminal_ && shown_ != std::chrono::steady_clock::time_point{}) std::fputc('\n', stderr);
}

}  // namespace cloudscape::app
