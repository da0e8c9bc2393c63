#include "bake/mie_phase.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <thread>

#include "bake/droplet_sizes.h"
#include "bake/mie_intensity.h"
#include "bake/mie_sphere.h"

namespace cloudscape::bake {
namespace {

// tuned: angles at which the spheres are summed. A mean over radii has no finer structure: with 384 cells the texels
// between are interpolated within 0.3 % (rms) of what they would be.
constexpr std::size_t angle_cells = 384;
constexpr std::size_t batch_size = 16;  // spheres that share their angular functions

// What some of the spheres add; per cross-section of all droplets.
struct Part {
  std::vector<double> intensity = std::vector<double>(angle_cells + 1);
  double extinction = 0, scattering = 0, cosine = 0;
  void add(const Part& part) {
    for (std::size_t i = 0; i < intensity.size(); ++i) intensity[i] += part.intensity[i];
    extinction += part.extinction, scattering += part.scattering, cosine += part.cosine;
  }
};

const std::vector<double>& cosines() {
  static const std::vector<double> cosines = [] {
    std::vector<double> mu;
    for (std::size_t i = 0; i <= angle_cells / 2; ++i)
      mu.push_back(std::cos(phase_angle_rad(static_cast<double>(i) / angle_cells)));
    return mu;
  }();
  return cosines;
}

// p = |S|^2 / (k^2 C_sca), summed before it is divided (Hansen and Travis 1974, equation 2.47).
Part part_of(const WaterAt& medium, std::span<const Droplets> sizes) {
  Part part;
  std::vector<SphereWaves> spheres;
  for (const Droplets& size : sizes) {
    const double x = 2 * std::numbers::pi * size.radius_um / medium.wavelength_um;
    const MieCoefficients coefficients = mie_coefficients(x, medium.index);
    const MieEfficiencies efficiencies = mie_efficiencies(coefficients);
    part.extinction += size.area * efficiencies.extinction;
    part.scattering += size.area * efficiencies.scattering;
    part.cosine += size.area * efficiencies.scattering * efficiencies.asymmetry_g;
    spheres.emplace_back(coefficients, size.area / (std::numbers::pi * x * x));
  }
  std::vector<double> front(cosines().size()), back(cosines().size());
  add_intensities(spheres, cosines(), front, back);
  for (std::size_t i = 0; i < front.size(); ++i) {
    part.intensity[angle_cells - i] = back[i];
    part.intensity[i] = front[i];
  }
  return part;
}

// Catmull-Rom through the logarithms of equally spaced values, `share` (0..1) of the way from values[i] to
// values[i + 1]. Beyond both ends they repeat backwards, as a phase function does.
double between(std::span<const double> values, std::size_t i, double share) {
  const double a = std::log(values[i == 0 ? 1 : i - 1]), b = std::log(values[i]), c = std::log(values[i + 1]);
  const double d = std::log(values[i + 2 < values.size() ? i + 2 : i]);
  const double slope_b = (c - a) / 2, slope_c = (d - b) / 2;
  const double cubic = 2 * (b - c) + slope_b + slope_c, square = 3 * (c - b) - 2 * slope_b - slope_c;
  return std::exp(b + share * (slope_b + share * (square + share * cubic)));
}

std::vector<double> texels_of(const Part& sum) {
  std::vector<double> texels;
  for (std::size_t i = 0; i < phase_table_texels; ++i) {
    const std::size_t cell = std::min(i * angle_cells / phase_table_cells, angle_cells - 1);
    const double share = static_cast<double>(i * angle_cells) / phase_table_cells - static_cast<double>(cell);
    texels.push_back(between(sum.intensity, cell, share) / sum.scattering);
  }
  return texels;
}

// Runs `task(0)` to `task(count - 1)` on some threads, this one among them.
void run_all(int threads, std::size_t count, const std::stop_token& stop,
             const std::function<void(std::size_t)>& task) {
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < count && !stop.stop_requested(); i = next++) task(i);
  };
  if (threads <= 0) threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  std::vector<std::jthread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(work);
  work();
}

}  // namespace

std::optional<PhaseTable> mie_phase_table(const PhaseRecipe& recipe, const MieEffort& effort,
                                          const std::stop_token& stop) {
  const std::vector<Droplets> sizes = droplet_sizes(recipe, effort.radii);
  const std::size_t batches = (sizes.size() + batch_size - 1) / batch_size;
  std::vector<Part> parts(3 * batches);
  run_all(effort.threads, parts.size(), stop, [&](std::size_t task) {
    const std::size_t i = parts.size() - 1 - task;  // the largest spheres, which take longest, first
    const std::size_t first = i / 3 * batch_size;
    parts[i] = part_of(water[i % 3], std::span(sizes).subspan(first, std::min(batch_size, sizes.size() - first)));
  });
  if (stop.stop_requested()) return std::nullopt;
  PhaseTable table{recipe, {}, {}};
  for (std::size_t colour = 0; colour < 3; ++colour) {
    Part sum;
    for (std::size_t i = colour; i < parts.size(); i += 3) sum.add(parts[i]);
    table.optics[colour] = {sum.extinction, sum.scattering / sum.extinction, sum.cosine / sum.scattering};
    table.phase_per_sr[colour] = texels_of(sum);
  }
  return table;
}

}  // namespace cloudscape::bake
