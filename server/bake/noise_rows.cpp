#include "bake/noise_rows.h"

#include <algorithm>
#include <cmath>

namespace cloudscape::bake {
namespace {

float sum_of_amplitudes(const Fbm& fbm) {
  float sum = 0, amplitude = 1;
  for (int octave = 0; octave < fbm.octaves; ++octave, amplitude *= fbm.gain) sum += amplitude;
  return sum;
}

int around_edges(int index, int period) {
  return index < 0 ? index + period : index >= period ? index - period : index;
}

// Three numbers in [0, 1): shaders/lib/hash.glsl.
glm::vec3 hash_unit(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  const auto mix = [&] { x += y * z, y += z * x, z += x * y; };
  constexpr std::uint32_t factor = 1664525, addend = 1013904223;
  x = x * factor + addend, y = y * factor + addend, z = z * factor + addend;
  mix();
  x ^= x >> 16, y ^= y >> 16, z ^= z >> 16;
  mix();
  constexpr float unit = 1.0F / 16777216.0F;
  return {static_cast<float>(x >> 8) * unit, static_cast<float>(y >> 8) * unit, static_cast<float>(z >> 8) * unit};
}

float fade(float t) { return t * t * t * (t * (t * 6 - 15) + 10); }

// The first texel whose middle lies in the cell or behind it.
int first_texel_of(int cell, int cells, int texels) {
  return std::clamp(static_cast<int>(std::ceil(cell * (1.0 * texels / cells) - 0.5)), 0, texels);
}

// What the texels of three cells see of the points of one: their places along the row, and the squares of their
// distances from it (cells).
struct Seen {
  std::array<float, 9> along, across2;
};

void add_nearest(const Seen& seen, float step, int first, int last, float* nearest2) {
  for (int texel = first; texel < last; ++texel) {
    const float x = static_cast<float>(texel) * step;
    float least = nearest2[texel];
    for (std::size_t i = 0; i < 9; ++i) {
      const float along = seen.along[i] - x, square = along * along + seen.across2[i];
      least = square < least ? square : least;
    }
    nearest2[texel] = least;
  }
}

}  // namespace

WorleyRows::WorleyRows(const Fbm& fbm, std::uint32_t seed, int texels) : nearest2_(static_cast<std::size_t>(texels)) {
  float amplitude = 1 / sum_of_amplitudes(fbm);
  glm::ivec3 cells = fbm.cells;
  for (int i = 0; i < fbm.octaves; ++i, amplitude *= fbm.gain, cells *= fbm.lacunarity)
    octaves_.push_back({cells, amplitude, seed + static_cast<std::uint32_t>(i) * 101});
  for (Octave& octave : octaves_)
    for (int cell = -1; cell <= octave.cells.x + 2; ++cell)
      octave.first_texels.push_back(first_texel_of(cell, octave.cells.x, texels));
}

void WorleyRows::find_points(Octave& octave, int cell_y, int cell_z) {
  if (octave.cell_y == cell_y && octave.cell_z == cell_z) return;
  octave.cell_y = cell_y, octave.cell_z = cell_z;
  const std::uint32_t salt = octave.seed * 747796405U + 2891336453U;
  for (std::size_t i = 0; i < 9; ++i) {
    const int y = around_edges(cell_y + static_cast<int>(i % 3) - 1, octave.cells.y);
    const int z = around_edges(cell_z + static_cast<int>(i / 3) - 1, octave.cells.z);
    octave.points[i].clear();
    for (int x = 0; x < octave.cells.x; ++x)
      octave.points[i].push_back(hash_unit(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                                           static_cast<std::uint32_t>(z) ^ salt));
  }
}

// A cell's point is among those that the texels of it and of its two neighbours look at.
void WorleyRows::find_nearest(Octave& octave, float y, float z) {
  const int cells = octave.cells.x, cell_y = static_cast<int>(y), cell_z = static_cast<int>(z);
  find_points(octave, cell_y % octave.cells.y, cell_z % octave.cells.z);
  const float step = static_cast<float>(cells) / static_cast<float>(nearest2_.size());
  std::ranges::fill(nearest2_, 3.0F);
  for (int cell = -1; cell <= cells; ++cell) {
    Seen seen;
    for (std::size_t i = 0; i < 9; ++i) {
      const glm::vec3& point = octave.points[i][static_cast<std::size_t>(around_edges(cell, cells))];
      const float beside = static_cast<float>(cell_y + static_cast<int>(i % 3) - 1) - y + point.y;
      const float above = static_cast<float>(cell_z + static_cast<int>(i / 3) - 1) - z + point.z;
      seen.along[i] = static_cast<float>(cell) + point.x - 0.5F * step;
      seen.across2[i] = beside * beside + above * above;
    }
    const int* first = &octave.first_texels[static_cast<std::size_t>(std::max(cell, 0))];
    add_nearest(seen, step, *first, first[cell < 0 ? 2 : 3], nearest2_.data());
  }
}

void WorleyRows::fill(float y, float z, std::span<float> row) {
  std::ranges::fill(row, 0.0F);
  for (Octave& octave : octaves_) {
    find_nearest(octave, y * static_cast<float>(octave.cells.y), z * static_cast<float>(octave.cells.z));
    for (std::size_t i = 0; i < row.size(); ++i)
      row[i] += octave.amplitude * (1 - std::sqrt(nearest2_[i] * (1.0F / 3)));
  }
}

PerlinRows::PerlinRows(const Fbm& fbm, const std::array<std::uint8_t, 256>& permutation)
    : fbm_(fbm), permutation_(permutation) {}

// One of the 12 edge gradients (perlin_gradient of shaders/lib/perlin.glsl).
PerlinRows::Line PerlinRows::line_at(const glm::ivec3& lattice, float y, float z) const {
  const auto permuted = [&](int index) { return int{permutation_[static_cast<std::size_t>(index & 255)]}; };
  const int h = permuted(permuted(permuted(lattice.x) + lattice.y) + lattice.z) & 15;
  const float u = (h & 1) == 0 ? 1.0F : -1.0F, v = (h & 2) == 0 ? 1.0F : -1.0F;
  const bool second_is_x = h == 12 || h == 14;
  Line line{h < 8 ? u : 0, h < 8 ? 0 : u * y};
  if (h < 4)
    line.rest += v * y;
  else if (second_is_x)
    line.slope += v;
  else
    line.rest += v * z;
  return line;
}

void PerlinRows::add_octave(const glm::ivec3& cells, float amplitude, float y, float z, std::span<float> row) const {
  const int cell_y = static_cast<int>(y), cell_z = static_cast<int>(z), texels = static_cast<int>(row.size());
  const float fy = y - static_cast<float>(cell_y), fz = z - static_cast<float>(cell_z);
  const float step = static_cast<float>(cells.x) / static_cast<float>(texels), v = fade(fy), w = fade(fz);
  // The four lattice points at x, mixed: what is left to do along x is linear.
  const auto mixed_at = [&](int x) {
    Line sum;
    for (int corner = 0; corner < 4; ++corner) {
      const int up_y = corner & 1, up_z = corner >> 1;
      const glm::ivec3 lattice(x % cells.x, (cell_y + up_y) % cells.y, (cell_z + up_z) % cells.z);
      const Line line = line_at(lattice, fy - static_cast<float>(up_y), fz - static_cast<float>(up_z));
      const float share = (up_y ? v : 1 - v) * (up_z ? w : 1 - w);
      sum.slope += share * line.slope, sum.rest += share * line.rest;
    }
    return sum;
  };
  Line left = mixed_at(0);
  for (int cell = 0; cell < cells.x; ++cell) {
    const Line right = mixed_at(cell + 1);
    const int last = first_texel_of(cell + 1, cells.x, texels);
    for (int texel = first_texel_of(cell, cells.x, texels); texel < last; ++texel) {
      const float fx = (static_cast<float>(texel) + 0.5F) * step - static_cast<float>(cell);
      const float from_left = fx * left.slope + left.rest, from_right = (fx - 1) * right.slope + right.rest;
      row[static_cast<std::size_t>(texel)] += amplitude * (from_left + (from_right - from_left) * fade(fx));
    }
    left = right;
  }
}

void PerlinRows::fill(float y, float z, std::span<float> row) const {
  std::ranges::fill(row, 0.5F);
  float amplitude = 0.5F / sum_of_amplitudes(fbm_);
  glm::ivec3 cells = fbm_.cells;
  for (int octave = 0; octave < fbm_.octaves; ++octave, amplitude *= fbm_.gain, cells *= fbm_.lacunarity)
    add_octave(cells, amplitude, y * static_cast<float>(cells.y), z * static_cast<float>(cells.z), row);
  for (float& value : row) value = std::clamp(value, 0.0F, 1.0F);
}

}  // namespace cloudscape::bake
