// The window's title: the figures of the stream in one line.
#pragma once
#include <string>

#include "viewer/stream_client.h"

namespace cloudscape::viewer {

struct Figures {
  double frames_per_second = 0, latency_ms = 0, bits_per_second = 0, speed_m_per_s = 0;
};

// "fair-weather-cumulus · 24 fps · 61 ms · 8.3 Mbit/s · 200 m/s · llvmpipe (software)", or what is wrong.
std::string title(const StreamStatus& status, const Figures& figures, bool with_figures);

}  // namespace cloudscape::viewer
