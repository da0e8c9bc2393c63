// The phase function of a cloud of water droplets: Lorenz-Mie scattering integrated over a distribution of radii.
#pragma once
#include <array>
#include <complex>
#include <optional>
#include <stop_token>

#include "bake/phase_table.h"

namespace cloudscape::bake {

// Water at 25 degrees Celsius, n - ik (Hale and Querry 1973), at one wavelength for each colour.
struct WaterAt {
  double wavelength_um;
  std::complex<double> index;
};
constexpr std::array<WaterAt, 3> water{
    {{0.650, {1.331, -1.64e-8}}, {0.550, {1.333, -1.96e-9}}, {0.450, {1.337, -1.02e-9}}}};

struct MieEffort {
  int radii = 0;    // that stand for the distribution; 0: by the droplets
  int threads = 0;  // 0: as many as the machine has
};

// Empty if `stop` was requested. The result depends neither on the number of threads nor on which of them is faster.
std::optional<PhaseTable> mie_phase_table(const PhaseRecipe& recipe, const MieEffort& effort = {},
                                          const std::stop_token& stop = {});

}  // namespace cloudscape::bake
