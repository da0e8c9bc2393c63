#include "bench/realtime_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bench/flip.h"
#include "core/formatted.h"
#include "core/version.h"
#include "settings/json_text.h"
#include "stream/quality_control.h"

namespace cloudscape::bench {
namespace {

using Json = nlohmann::ordered_json;

std::string row_of(const char* name, const Spread& spread) {
  return formatted("  %-24s %9.1f %9.1f %9.1f\n", name, spread.median_ms, spread.p95_ms, spread.max_ms);
}

Json json_of(const Spread& spread) {
  return {{"median_ms", spread.median_ms}, {"p95_ms", spread.p95_ms}, {"max_ms", spread.max_ms}};
}

Json json_of(const FlickerFigure& flicker) {
  return {{"mean_percent", flicker.mean_percent}, {"p99_percent", flicker.p99_percent}, {"frames", flicker.frames}};
}

double total_of(const std::vector<PassTime>& passes) {
  double total = 0;
  for (const PassTime& pass : passes) total += pass.ms;
  return total;
}

std::string words_of(int detail) {
  const stream::MovingDetail& level = stream::moving_details.at(static_cast<std::size_t>(detail));
  return formatted("1 in %d pixels marched, of a picture kept at 1/%d", level.reuse, level.resolution_divisor) +
         (level.step_factor > 1 ? formatted(", in steps %d times as long", level.step_factor) : "");
}

std::string flight_table(const RealtimeResults& results) {
  const FlightFigures& flight = results.flight;
  std::string text =
      formatted("%dx%d, %s along %s at %.0f m/s, %d frames in %.1f s\n", results.size_px.width, results.size_px.height,
                results.cloudscape.c_str(), results.path.c_str(), results.speed_m_per_s, flight.frames, flight.seconds);
  text += formatted("frames a second            mean %.1f, median second %.1f, least %.0f; %s\n", flight.fps_mean,
                    flight.fps_median, flight.fps_least, words_of(flight.detail).c_str());
  text += formatted("  %-24s %9s %9s %9s\n", "ms", "median", "p95", "max");
  text += row_of("frame to frame", flight.interval) + row_of("pose to picture", flight.age);
  text += row_of("render", flight.render) + row_of("of that, device", flight.device);
  text += row_of("read back", flight.readback) + row_of("encode", flight.encode);
  text += formatted("CPU of a frame             %.1f ms:", results.cpu_ms);
  for (const auto& [name, ms] : results.threads) text += formatted(" %s %.1f", name.c_str(), ms);
  return text + formatted("\nbytes of a frame           %.1f KiB\n", flight.bytes / 1024);
}

std::string passes_table(const std::vector<PassTime>& passes, int frames) {
  if (passes.empty()) return "passes                     not told by the renderer\n";
  std::string text = formatted("  %-24s %9s %9s %9s\n", "passes of a frame", "ms", "CPU ms", "share");
  for (const PassTime& pass : passes)
    text += formatted("  %-24s %9.2f %9.2f %7.1f %%\n", pass.name.c_str(), pass.ms / std::max(1, frames),
                      pass.cpu_ms / std::max(1, frames), 100 * pass.ms / std::max(total_of(passes), 1e-9));
  return text;
}

std::string quality_table(const MovingQuality& quality) {
  std::string text = formatted("\nmoving pictures, %s, before the encoder\n", words_of(quality.detail).c_str());
  if (!quality.compared.empty()) {
    const QualityFigures figures = figures_of(quality.compared);
    text += passes_table(quality.passes, quality.timed_frames);
    text += formatted("LDR-FLIP (%.0f px a degree)  mean %.4f, worst %.4f of %zu frames\n", flip_pixels_per_degree,
                      figures.flip_mean, figures.flip_worst, quality.compared.size());
    text += formatted("PSNR                       mean %.1f dB, worst %.1f dB\n", figures.psnr_mean_db,
                      figures.psnr_worst_db);
  }
  for (const auto& [name, flicker] : {std::pair{"still camera", quality.still}, std::pair{"slow pan", quality.pan}})
    if (flicker.frames > 0)
      text += formatted("flicker, %-16s  mean %.3f %%, 99th percentile %.3f %% of white over %d frames\n", name,
                        flicker.mean_percent, flicker.p99_percent, flicker.frames);
  return text;
}

Json flight_json(const RealtimeResults& results) {
  const FlightFigures& flight = results.flight;
  return {
      {"frames", flight.frames},
      {"seconds", flight.seconds},
      {"fps", {{"mean", flight.fps_mean}, {"median_second", flight.fps_median}, {"least_second", flight.fps_least}}},
      {"interval", json_of(flight.interval)},
      {"age", json_of(flight.age)},
      {"render", json_of(flight.render)},
      {"device", json_of(flight.device)},
      {"readback", json_of(flight.readback)},
      {"encode", json_of(flight.encode)},
      {"cpu_ms_per_frame", results.cpu_ms},
      {"cpu_ms_per_frame_of_threads", results.threads},
      {"bytes_per_frame", flight.bytes},
      {"detail", flight.detail}};
}

Json quality_json(const MovingQuality& quality, const QualityRun& run) {
  const QualityFigures figures = figures_of(quality.compared);
  Json frames = Json::array(), passes = Json::array();
  for (const ComparedFrame& frame : quality.compared)
    frames.push_back({{"time_s", frame.time_s}, {"flip", frame.flip}, {"psnr_db", frame.psnr_db}});
  for (const PassTime& pass : quality.passes)
    passes.push_back({{"name", pass.name},
                      {"ms_per_frame", pass.ms / std::max(1, quality.timed_frames)},
                      {"cpu_ms_per_frame", pass.cpu_ms / std::max(1, quality.timed_frames)},
                      {"share", pass.ms / std::max(total_of(quality.passes), 1e-9)}});
  return {{"detail", quality.detail},
          {"truth_samples", run.truth_samples},
          {"passes", std::move(passes)},
          {"flip", {{"mean", figures.flip_mean}, {"worst", figures.flip_worst}}},
          {"flip_pixels_per_degree", flip_pixels_per_degree},
          {"psnr_db", {{"mean", figures.psnr_mean_db}, {"worst", figures.psnr_worst_db}}},
          {"compared", std::move(frames)},
          {"flicker",
           {{"time_s", run.flicker_at_s},
            {"size_px", {run.flicker_size_px.width, run.flicker_size_px.height}},
            {"pan_deg_per_s", pan_deg_per_s},
            {"still", json_of(quality.still)},
            {"pan", json_of(quality.pan)}}}};
}

}  // namespace

QualityFigures figures_of(const std::vector<ComparedFrame>& compared) {
  if (compared.empty()) return {};
  QualityFigures figures{0, 0, 0, compared.front().psnr_db};
  const auto count = static_cast<double>(compared.size());
  for (const ComparedFrame& frame : compared) {
    figures.flip_mean += frame.flip / count;
    figures.psnr_mean_db += frame.psnr_db / count;
    figures.flip_worst = std::max(figures.flip_worst, frame.flip);
    figures.psnr_worst_db = std::min(figures.psnr_worst_db, frame.psnr_db);
  }
  return figures;
}

std::string realtime_table(const RealtimeResults& results) {
  return (results.flight.frames > 0 ? flight_table(results) : "") +
         (results.quality ? quality_table(*results.quality) : "");
}

std::string realtime_json(const RealtimeResults& results, const Machine& machine) {
  Json document{{"benchmark", "realtime"},
                {"program_version", version},
                {"machine", json_of(machine)},
                {"cloudscape", results.cloudscape},
                {"path", results.path},
                {"size_px", {results.size_px.width, results.size_px.height}},
                {"speed", results.speed},
                {"speed_m_per_s", results.speed_m_per_s},
                {"target_fps", results.target_fps},
                {"poses_per_s", results.poses_per_s},
                {"latency_ms", results.latency_ms},
                {"flight", flight_json(results)}};
  if (results.quality) document["quality"] = quality_json(*results.quality, results.judged);
  return settings::to_text(document, 1) + "\n";
}

}  // namespace cloudscape::bench
