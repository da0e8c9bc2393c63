// Light that a cloud has scattered, and that sky and ground send into it: all that is not the sun's own beam, solved on
// a coarse grid by discrete ordinates (as in Evans 1998, "The Spherical Harmonics Discrete Ordinate Method for
// Three-Dimensional Atmospheric Radiative Transfer", without its adaptive grid). On the CPU: the same on every device.
//
// The forward peak of the phase function is not resolved: light that is scattered into it counts as not scattered
// (Joseph, Wiscombe and Weinman 1976, "The delta-Eddington approximation"), so that the beam of the sun that the grid
// knows is the light of all angles within the peak.
#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <stop_token>
#include <vector>

namespace cloudscape::bake {

// Red, green, blue and nothing, in a register of four (GCC's and Clang's vector extension).
using Colours = float __attribute__((vector_size(16)));
inline float luminance(const Colours& c) { return 0.2126F * c[0] + 0.7152F * c[1] + 0.0722F * c[2]; }  // Rec. 709

// A grid of points, x fastest, then y, then z (upwards); `periodic`: it repeats east and north, else what lies outside
// is empty, as is what is above and below.
struct InScatterGrid {
  glm::ivec3 size{1};
  glm::dvec3 spacing_m{1};
  bool periodic = true;
  std::vector<float> extinction_per_m;
};

// Of a phase function: its mean cosine, and the share of its energy that counts as not scattered.
struct ScatterMoments {
  double asymmetry_g = 0, forward_share = 0;
};
// f = g^2, as of Henyey and Greenstein's function; none for one that scatters backwards.
ScatterMoments scatter_moments(double asymmetry_g);

struct InScatterLight {
  glm::dvec3 sun_direction{0, 0, 1};      // towards it, unit
  std::vector<glm::vec3> sun_irradiance;  // on a plane normal to the beam, by layer of the grid, without cloud
  std::array<glm::vec3, 6>
      surroundings{};  // mean radiance of parts of the sphere, as shaders/render/light_directions.glsl
                       // has them; the last: the ground without the shade of clouds
};

struct InScatterProblem {
  InScatterGrid grid;
  ScatterMoments moments;
  double single_scattering_albedo = 1;
  InScatterLight light;
};

// A function of direction at a point: even + dot(directed, direction).
struct Moments {
  Colours even{}, east{}, north{}, up{};
};

// At each point: mean radiance of all directions, and the mean of radiance times the direction that it comes from,
// without the sun's beam; and the share of the beam that arrives, light in the forward peak included.
struct InScatterSolution {
  std::vector<Moments> light;
  std::vector<float> beam;
  double share_below = 1, share_above = 0;  // of the light from above that leaves below and above, by its luminance
  int iterations = 0;
  double change = 0;  // of the last iteration, relative
};

struct InScatterAccuracy {
  double least_change = 3e-4;  // relative to the mean, per iteration
  int most_iterations = 200;
};

// The same for the same problem, whatever was solved before. nullopt: stopped.
std::optional<InScatterSolution> solve_in_scatter(const InScatterProblem& problem,
                                                  const InScatterAccuracy& accuracy = {}, std::stop_token stop = {});

}  // namespace cloudscape::bake
