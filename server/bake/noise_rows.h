// The noises of shaders/lib (worley.glsl, perlin.glsl) along a row of texels. What the texels of a row share, feature
// points and gradients, is found once: a processor takes a twentieth of the time that it takes for the shaders.
#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace cloudscape::bake {

// Octaves of fractional Brownian motion on a lattice that repeats: `cells` of the first across the tile.
struct Fbm {
  glm::ivec3 cells{1};
  int octaves = 1, lacunarity = 2;
  float gain = 0.5F;
};

// Worley fBm in 0..1.
class WorleyRows {
 public:
  // `texels`: of a row.
  WorleyRows(const Fbm& fbm, std::uint32_t seed, int texels);
  // The row at `y` and `z` (tiles), at the middles of its texels.
  void fill(float y, float z, std::span<float> row);

 private:
  struct Octave {
    glm::ivec3 cells;
    float amplitude;
    std::uint32_t seed;
    int cell_y = -1, cell_z = -1;                       // whose neighbours are at hand
    std::array<std::vector<glm::vec3>, 9> points = {};  // of the rows of cells about it, in their cells
    std::vector<int> first_texels = {};                 // of each cell, from the one before the tile to two behind
  };
  static void find_points(Octave& octave, int cell_y, int cell_z);
  void find_nearest(Octave& octave, float y, float z);
  std::vector<Octave> octaves_;
  std::vector<float> nearest2_;  // square of the distance to the nearest point, cells
};

// Perlin fBm in 0..1, 1/2 on average.
class PerlinRows {
 public:
  PerlinRows(const Fbm& fbm, const std::array<std::uint8_t, 256>& permutation);
  void fill(float y, float z, std::span<float> row) const;

 private:
  // Of a lattice point: its gradient's product with an offset (x, y, z) is `slope` x + `rest`, once y and z are known.
  struct Line {
    float slope = 0, rest = 0;
  };
  Line line_at(const glm::ivec3& lattice, float y, float z) const;
  void add_octave(const glm::ivec3& cells, float amplitude, float y, float z, std::span<float> row) const;
  Fbm fbm_;
  std::array<std::uint8_t, 256> permutation_;
};

}  // namespace cloudscape::bake
