// For tests of what is baked on the clouds' grid: clouds of known density, and a march that is independent of the
// device's.
#pragma once
#include <cstring>
#include <numeric>

#include "gpu/render/fixture.h"
#include "render/cloud_densities.h"
#include "render/density_export.h"

namespace cloudscape::render {

inline Cloudscape with_sun(Cloudscape sky, double azimuth_deg, double elevation_deg) {
  sky.sun.azimuth_deg = azimuth_deg, sky.sun.elevation_deg = elevation_deg;
  return sky;
}

// Density 1 between 1000 m and 3000 m.
inline Cloudscape full_layer(double sun_deg) {
  Cloudscape sky = with_sun(small_clouds(), 30, sun_deg);
  sky.shape.threshold = -1, sky.detail.strength = 0;
  return sky;
}

// Ten clouds or so, each some cells wide.
inline Cloudscape broken_clouds(double azimuth_deg, double elevation_deg) {
  Cloudscape sky = with_sun(small_clouds(), azimuth_deg, elevation_deg);
  sky.volume.resolution = 64;
  sky.shape.coverage = 0.4;
  return sky;
}

class CloudGridTest : public RenderTest {
 protected:
  static std::shared_ptr<const bake::BakedCloudscape> baked_of(const Cloudscape& sky) {
    const bake::BakeRecipe recipe = stack().bakes.recipe_of(sky);
    while (!stack().bakes.find(recipe)) stack().bakes.advance(recipe);
    return stack().bakes.find(recipe);
  }
  static std::vector<float> values_of(const gpu::Texture& texture) {
    const std::vector<std::uint8_t> bytes = texture.download();
    std::vector<float> values(bytes.size() / sizeof(float));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }
};

// All voxels of a tile, and a march through them by nearest voxels that knows nothing of the device's.
struct Voxels {
  std::vector<float> density;
  glm::ivec3 size;
  double voxel_m;

  double at(const glm::dvec3& p_m) const {  // from the tile's corner
    const int z = static_cast<int>(std::floor(p_m.z / voxel_m));
    if (z < 0 || z >= size.z) return 0;
    const auto wrapped = [&](double m, int n) {
      const int i = static_cast<int>(std::floor(m / voxel_m)) % n;
      return i < 0 ? i + n : i;
    };
    const int index = (z * size.y + wrapped(p_m.y, size.y)) * size.x + wrapped(p_m.x, size.x);
    return density[static_cast<std::size_t>(index)];
  }
  double march_m(const glm::dvec3& from_m, const glm::dvec3& direction) const {
    const double step_m = 0.3 * voxel_m;
    double sum_m = 0;
    for (glm::dvec3 p = from_m + 0.5 * step_m * direction; p.z >= 0 && p.z < size.z * voxel_m; p += step_m * direction)
      sum_m += step_m * at(p);
    return sum_m;
  }
};

inline Voxels voxels_of(DensityExport source) {
  Voxels voxels{{}, source.size(), source.voxel_m()};
  for (int z = 0; z < source.size().z; z += DensityExport::slab) {
    const std::vector<float> slab = source.slices(z);
    voxels.density.insert(voxels.density.end(), slab.begin(), slab.end());
  }
  return voxels;
}

struct Likeness {
  double mean_ratio, correlation;
};

inline Likeness likeness(const std::vector<double>& a, const std::vector<double>& b) {
  const auto mean = [](const std::vector<double>& v) { return std::reduce(v.begin(), v.end()) / double(v.size()); };
  const double mean_a = mean(a), mean_b = mean(b);
  double aa = 0, bb = 0, ab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    aa += (a[i] - mean_a) * (a[i] - mean_a), bb += (b[i] - mean_b) * (b[i] - mean_b);
    ab += (a[i] - mean_a) * (b[i] - mean_b);
  }
  return {mean_a / mean_b, ab / std::sqrt(aa * bb)};
}

}  // namespace cloudscape::render
