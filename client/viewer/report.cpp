// The report of a flight.
#include "viewer/report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace cloudscape::viewer {
namespace {

using Json = nlohmann::ordered_json;

Json distribution(const std::vector<double>& values) {
  return {{"p50", percentile(values, 50)},
          {"p95", percentile(values, 95)},
          {"p99", percentile(values, 99)},
          {"max", percentile(values, 100)},
          {"count", values.size()}};
}

double per_second(double amount, double duration_s) { return duration_s > 0 ? amount / duration_s : 0.0; }

Json server_part(const StreamStatus& status, const std::string& server) {
  const wire::Welcome welcome = status.welcome.value_or(wire::Welcome{});
  return {{"server", server},
          {"program_version", welcome.program_version},
          {"cloudscape", welcome.cloudscape},
          {"renderer", welcome.renderer},
          {"software", welcome.software},
          {"size_px", {welcome.size_px.width, welcome.size_px.height}}};
}

Json drops(const StreamStatus& status) {
  const std::uint64_t server = status.stats.frames_dropped;
  return {{"client", status.frames_skipped},
          {"server", server},
          {"broken", status.frames_broken},
          {"total", status.frames_skipped + server + status.frames_broken}};
}

}  // namespace

std::string report_json(const FlightRecord& record, const StreamStatus& status, const std::string& server) {
  Json report = server_part(status, server);
  report["poses_sent"] = record.poses_sent;
  report["frames"] = record.frames;
  report["refinements"] = record.refinements;
  report["duration_s"] = record.duration_s;
  report["fps"] = per_second(static_cast<double>(record.frames), record.duration_s);
  report["latency_ms"] = distribution(record.latency_ms);
  report["decode_ms"] = distribution(record.decode_ms);
  report["render_ms"] = distribution(record.render_ms);
  report["encode_ms"] = distribution(record.encode_ms);
  report["drops"] = drops(status);
  report["bytes"] = status.bytes_received;
  report["bits_per_second"] = per_second(8.0 * static_cast<double>(status.bytes_received), record.duration_s);
  report["window"] = status.stats.window;
  report["reconnections"] = status.connections > 0 ? status.connections - 1 : 0;
  return report.dump(2) + "\n";
}

}  // namespace cloudscape::viewer
