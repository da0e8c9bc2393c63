// The comparison with the truth as a page: a row of pictures for each view.
#include "bench/truth_pictures.h"
#include "bench/truth_report.h"
#include "core/formatted.h"
#include "core/version.h"

namespace cloudscape::bench {
namespace {

constexpr const char* head = R"(<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<title>How right is the light?</title>
<style>
body { font: 14px/1.4 sans-serif; margin: 24px; color: #222; background: #fff }
table { border-collapse: collapse; margin: 0 0 24px }
th, td { padding: 4px 8px; text-align: left; vertical-align: top }
.figures td, .figures th { border-bottom: 1px solid #ddd; text-align: right }
.figures td:first-child, .figures th:first-child { text-align: left }
.met { color: #060 } .missed { color: #b00; font-weight: bold }
img { display: block; width: 256px; image-rendering: pixelated }
small { display: block; color: #444 }
</style>
)";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    result += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : c == '"' ? "&quot;" : std::string(1, c);
  return result;
}

std::string image(const std::string& file, const std::string& about) {
  return "<img src=\"" + escaped(file) + "\" alt=\"" + escaped(about) + "\">\n";
}

std::string target_cells(const ModelSummary& model) {
  std::string cells;
  for (const TruthTarget& target : truth_targets())
    cells += formatted("<td class=\"%s\">%.3f</td>", target.met(model) ? "met" : "missed", target.value(model));
  return cells;
}

std::string cost_cells(const std::optional<TruthCost>& cost) {
  return cost ? formatted("<td>%.1f</td><td>%.1f</td><td>%.1f</td>", cost->cpu_ms, cost->wall_ms,
                          cost->sun_change_cpu_ms)
              : "<td></td><td></td><td></td>";
}

std::string summary_row(const ModelSummary& model, bool is_default) {
  return formatted("<tr><td>%s%s</td>", model.model.c_str(), is_default ? " (default)" : "") + target_cells(model) +
         formatted("<td>%.1f %%</td><td>%.4f</td><td>%.1f</td><td>%.1f %%</td><td>%.1f %%</td>",
                   100 * model.relative_error_p95, model.hdr_flip, model.psnr_db, 100 * model.whole_relative_error,
                   100 * model.tile_relative_error) +
         cost_cells(model.cost) + "</tr>\n";
}

std::string summary(const TruthResults& results) {
  std::string text = "<table class=\"figures\">\n<tr><th>model</th>";
  for (const TruthTarget& target : truth_targets())
    text += formatted("<th>%s<br>at most %.2f</th>", target.name, target.limit);
  text +=
      "<th>error, p95</th><th>HDR-FLIP</th><th>PSNR, dB</th><th>error of the whole picture</th><th>error of 8x8 "
      "tiles</th>"
      "<th>CPU ms a frame</th><th>wall ms a frame</th><th>CPU ms a sun change</th></tr>\n";
  for (const ModelSummary& model : summaries_of(results))
    text += summary_row(model, model.model == results.default_model);
  return text + summary_row(noise_floor_of(results), false) + "</table>\n";
}

std::string figures_of(const ModelResult& model) {
  return formatted(
      "<small>error %.1f %% (p95 %.1f %%), ln ratio %.3f</small>"
      "<small>LDR-FLIP %.4f, HDR-FLIP %.4f, PSNR %.1f dB</small>"
      "<small>whole picture: error %.1f %%, ln ratio %.3f; tiles: error %.1f %%</small>",
      100 * model.clouds.mean, 100 * model.clouds.p95, model.clouds.log_ratio, model.ldr_flip, model.hdr_flip,
      model.psnr_db, 100 * model.whole.mean, model.whole.log_ratio, 100 * model.tiles.mean);
}

std::string reference_cell(const ViewResult& view) {
  return "<td>" + image(picture_file(view.name, "reference"), view.name + ", reference") +
         image(flip_map_file(view.name, view.noise_floor.model), "LDR-FLIP of noise") +
         formatted("<small>path-traced; clouds on %.0f %% of the picture, noise there %.1f %%. Noise alone:</small>",
                   100 * view.cloud_share, 100 * view.reference_noise) +
         figures_of(view.noise_floor) + "</td>\n";
}

std::string model_cell(const ViewResult& view, const ModelResult& model) {
  return "<td>" + image(picture_file(view.name, model.model), view.name + ", " + model.model) +
         image(flip_map_file(view.name, model.model), "LDR-FLIP") + figures_of(model) + "</td>\n";
}

std::string view_row(const ViewResult& view) {
  std::string row = "<tr><th>" + escaped(view.title) + "<small>" + escaped(view.description) + "</small></th>\n";
  row += reference_cell(view);
  for (const ModelResult& model : view.models) row += model_cell(view, model);
  return row + "</tr>\n";
}

std::string gallery(const TruthResults& results) {
  std::string text = "<table>\n<tr><th>view</th><th>reference</th>";
  for (const ModelSummary& model : summaries_of(results)) text += "<th>" + model.model + "</th>";
  text += "</tr>\n";
  for (const ViewResult& view : results.views) text += view_row(view);
  return text + "</table>\n";
}

}  // namespace

std::string truth_html(const TruthResults& results, const Machine& machine) {
  return head +
         formatted(
             "<h1>How right is the light?</h1>\n<p>cloudscape %s on %s, %u cores. Pictures of %dx%d; references of %d "
             "paths a pixel; models at quality %s with %d samples. Errors are relative radiance errors where the "
             "reference met cloud, unless said otherwise. Below each picture its LDR-FLIP map: black 0, red, yellow, "
             "white 0.5 and more.</p>\n",
             version, escaped(machine.renderer).c_str(), machine.cores, results.size_px.width, results.size_px.height,
             results.reference_samples, std::string(name_of(results.quality)).c_str(), results.model_samples) +
         summary(results) + gallery(results) + "</html>\n";
}

}  // namespace cloudscape::bench
