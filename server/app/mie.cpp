// `cloudscape mie`: the phase function of water droplets as a table, and as a plot.
#include <cmath>
#include <numbers>

#include "app/commands.h"
#include "bake/mie_phase.h"
#include "bench/svg_plot.h"
#include "core/error.h"
#include "core/formatted.h"
#include "settings/text_file.h"

namespace cloudscape::app {
namespace {

struct MieOptions {
  double effective_radius_um = 10, effective_variance = 0.1, sun_radius_deg = 0;
  int angles = 1801;
  std::string output, plot;
};

constexpr double degree = std::numbers::pi / 180;

// Equal steps: what a spreadsheet wants. The table itself is finer towards both ends.
double angle_deg_of(const MieOptions& options, int i) { return 180.0 * i / (options.angles - 1); }

std::string csv_of(const MieOptions& options, const bake::PhaseTable& table) {
  std::string csv =
      formatted("# phase function of water droplets, 1/sr: effective radius %g um, effective variance %g\n",
                options.effective_radius_um, options.effective_variance);
  if (options.sun_radius_deg > 0)
    csv += formatted("# as a sun of radius %g degrees shows it\n", options.sun_radius_deg);
  constexpr const char* names[] = {"red", "green", "blue"};
  for (std::size_t colour = 0; colour < 3; ++colour) {
    const bake::DropletOptics& optics = table.optics[colour];
    csv +=
        formatted("# %s: wavelength_um=%g extinction_efficiency=%.5f asymmetry_g=%.5f single_scattering_albedo=%.8f\n",
                  names[colour], bake::water[colour].wavelength_um, optics.extinction_efficiency, optics.asymmetry_g,
                  optics.single_scattering_albedo);
  }
  csv += "angle_deg,cos_theta,red,green,blue\n";
  for (int i = 0; i < options.angles; ++i) {
    const double angle_deg = angle_deg_of(options, i);
    const auto phase = table.at(angle_deg * degree);
    csv +=
        formatted("%.9g,%.9g,%.7g,%.7g,%.7g\n", angle_deg, std::cos(angle_deg * degree), phase[0], phase[1], phase[2]);
  }
  return csv;
}

std::string plot_of(const MieOptions& options, const bake::PhaseTable& table) {
  bench::LinePlot plot;
  plot.title = formatted("Phase function of droplets of %g µm, variance %g", options.effective_radius_um,
                         options.effective_variance);
  plot.x_label = "scattering angle, degrees", plot.y_label = "1/sr", plot.logarithmic_y = true;
  plot.lines = {{"450 nm", {}, {}}, {"550 nm", {}, {}}, {"650 nm", {}, {}}};
  for (std::size_t texel = 0; texel < bake::phase_table_texels; ++texel)
    for (std::size_t line = 0; line < 3; ++line) {
      const double coordinate = static_cast<double>(texel) / bake::phase_table_cells;
      plot.lines[line].x.push_back(bake::phase_angle_rad(coordinate) / degree);
      plot.lines[line].y.push_back(table.phase_per_sr[2 - line][texel]);
    }
  return bench::svg_of(plot);
}

void check(const char* option, double value, double least, double most) {
  if (!(value >= least && value <= most))
    throw InvalidInput(option, formatted("is %g: must be within [%g, %g]", value, least, most));
}

int run_mie(const MieOptions& options) {
  check("--effective-radius-um", options.effective_radius_um, 1, 50);
  check("--effective-variance", options.effective_variance, 0.01, 0.5);
  check("--sun-radius-deg", options.sun_radius_deg, 0, 10);
  check("--angles", options.angles, 2, 1000001);
  bake::PhaseTable table = *bake::mie_phase_table(
      {.effective_radius_um = options.effective_radius_um, .effective_variance = options.effective_variance});
  if (options.sun_radius_deg > 0) table = bake::seen_by_disc(table, options.sun_radius_deg * degree);
  if (!options.plot.empty()) settings::write_text_file(options.plot, plot_of(options, table));
  if (!options.output.empty())
    settings::write_text_file(options.output, csv_of(options, table));
  else if (options.plot.empty())
    std::fputs(csv_of(options, table).c_str(), stdout);
  return 0;
}

}  // namespace

void add_mie(CLI::App& program, Run& run) {
  auto options = std::make_shared<MieOptions>();
  CLI::App* command =
      program.add_subcommand("mie", "Compute the phase function of water droplets (Lorenz-Mie) at 650, 550 and 450 nm");
  const auto add = [&](const char* name, auto& value, const char* about) {
    command->add_option(name, value, about)->capture_default_str();
  };
  add("--effective-radius-um", options->effective_radius_um, "Effective radius of the droplets, um, 1 to 50");
  add("--effective-variance", options->effective_variance,
      "Effective variance of their radii (gamma distribution), 0.01 to 0.5");
  add("--sun-radius-deg", options->sun_radius_deg,
      "Mean over a sun of this radius, degrees, as in pictures; 0: one direction");
  add("--angles", options->angles, "Angles, evenly from 0 to 180 degrees");
  command->add_option("-o,--output", options->output, "CSV file to write (default: standard output)");
  command->add_option("--plot", options->plot, "SVG file to write, logarithmic; without -o nothing is printed");
  command->callback([options, &run] { run = [options] { return run_mie(*options); }; });
}

}  // namespace cloudscape::app
