#include "bench/frame_times.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/formatted.h"
#include "core/version.h"
#include "encode/encode.h"

namespace cloudscape::bench {
namespace {

constexpr StreamId bench_stream = 1;

nlohmann::ordered_json json_of(const Spread& spread) {
  return {{"median_ms", spread.median_ms}, {"p95_ms", spread.p95_ms}, {"max_ms", spread.max_ms}};
}

}  // namespace

Spread spread_of(std::vector<double> values_ms) {
  if (values_ms.empty()) return {};
  std::sort(values_ms.begin(), values_ms.end());
  const auto rank = [&](double share) {
    const auto nearest = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values_ms.size())));
    return values_ms[std::max<std::size_t>(nearest, 1) - 1];
  };
  return {rank(0.5), rank(0.95), values_ms.back()};
}

FrameTimes measure_frames(render::Renderer& renderer, const FrameRequest& request, int frames, int warm_up) {
  FrameRequest each = request;
  each.stream = bench_stream;
  FrameTimes times{"", "", each.size_px, each.quality.march_divisor, frames, {}, {}, {}, 0};
  std::vector<double> render, gpu, encode;
  for (int i = -warm_up; i < frames; ++i) {
    const Frame frame = renderer.render(each);
    const EncodedFrame jpeg = encode::encode(frame, {ImageFormat::jpeg, 80, ChromaSubsampling::half, ExrType::half});
    if (i < 0) continue;
    render.push_back(frame.timings.render_ms + frame.timings.readback_ms);
    gpu.push_back(frame.timings.gpu_ms);
    encode.push_back(jpeg.encode_ms);
    times.jpeg_bytes += static_cast<double>(jpeg.bytes.size()) / frames;
  }
  each.time_passes = true;
  times.passes = renderer.render(each).timings.passes;
  renderer.forget(bench_stream);
  times.render = spread_of(render), times.gpu = spread_of(gpu), times.encode = spread_of(encode);
  return times;
}

namespace {

std::string passes_of(const FrameTimes& row) {
  if (row.passes.empty()) return {};
  std::string text = "   ";
  for (const PassTime& pass : row.passes) text += formatted(" %s %.1f", pass.name.c_str(), pass.ms);
  return text + " ms\n";
}

nlohmann::ordered_json json_of(const std::vector<PassTime>& passes) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const PassTime& pass : passes) list.push_back({{"name", pass.name}, {"ms", pass.ms}, {"cpu_ms", pass.cpu_ms}});
  return list;
}

}  // namespace

std::string table_of(const std::vector<FrameTimes>& rows) {
  char line[160];
  std::snprintf(line, sizeof line, "%-24s %-12s %9s %3s  %9s %9s %9s  %9s  %9s %7s\n", "cloudscape", "quality", "size",
                "1/n", "median ms", "p95 ms", "max ms", "device ms", "jpeg ms", "KiB");
  std::string text = line;
  for (const FrameTimes& row : rows) {
    const std::string size = std::to_string(row.size_px.width) + "x" + std::to_string(row.size_px.height);
    std::snprintf(line, sizeof line, "%-24.24s %-12s %9s %3d  %9.1f %9.1f %9.1f  %9.1f  %9.2f %7.1f\n",
                  row.cloudscape.c_str(), row.quality.c_str(), size.c_str(), row.march_divisor, row.render.median_ms,
                  row.render.p95_ms, row.render.max_ms, row.gpu.median_ms, row.encode.median_ms, row.jpeg_bytes / 1024);
    text += line + passes_of(row);
  }
  return text;
}

std::string json_of(const std::vector<FrameTimes>& rows, const std::string& renderer,
                    const std::string& pass_execution) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const FrameTimes& row : rows) {
    list.push_back({{"cloudscape", row.cloudscape},
                    {"quality", row.quality},
                    {"size_px", {row.size_px.width, row.size_px.height}},
                    {"march_divisor", row.march_divisor},
                    {"frames", row.frames},
                    {"render", json_of(row.render)},
                    {"device", json_of(row.gpu)},
                    {"encode", json_of(row.encode)},
                    {"jpeg_bytes", row.jpeg_bytes},
                    {"passes", json_of(row.passes)}});
  }
  const nlohmann::ordered_json document{{"benchmark", "frames"},
                                        {"program_version", version},
                                        {"renderer", renderer},
                                        {"pass_execution", pass_execution},
                                        {"frame_times", std::move(list)}};
  return document.dump(2) + "\n";
}

}  // namespace cloudscape::bench
