// What a flight without a window measured, as JSON.
#pragma once
#include <string>
#include <vector>

#include "viewer/stream_client.h"

namespace cloudscape::viewer {

struct FlightRecord {
  std::uint64_t poses_sent = 0;
  std::uint64_t frames = 0;                             // saved: the first of each pose that came
  std::uint64_t refinements = 0;                        // further frames of a pose that had one
  double duration_s = 0;                                // from the first pose to the last frame
  std::vector<double> latency_ms;                       // from a pose's sending to its first frame's display
  std::vector<double> decode_ms, render_ms, encode_ms;  // of the saved frames
};

// Keys: server, cloudscape, renderer, software, size_px, poses_sent, frames, refinements, duration_s, fps, latency_ms
// {p50, p95, p99, max}, decode_ms, render_ms and encode_ms likewise, drops {client, server, broken, total}, bytes,
// bits_per_second, window, reconnections.
std::string report_json(const FlightRecord& record, const StreamStatus& status, const std::string& server);

}  // namespace cloudscape::viewer
