// One iteration of the discrete ordinates: what all points scatter goes along every direction through the grid.
#pragma once
#include <stop_token>

#include "bake/in_scatter.h"
#include "bake/ordinates.h"

namespace cloudscape::bake {

// Red, green, blue and nothing, in a register of four (GCC's and Clang's vector extension).
using Colours = float __attribute__((vector_size(16)));
inline Colours colours(const glm::vec3& rgb) { return Colours{rgb.x, rgb.y, rgb.z, 0}; }
inline Colours all_of(float value) { return Colours{value, value, value, value}; }

// A function of direction at a point: even + dot(directed, direction).
struct Moments {
  Colours even{}, east{}, north{}, up{};
};

class Sweeper {
 public:
  explicit Sweeper(const InScatterGrid& grid);
  struct Arrived {
    std::vector<Moments> at;  // mean radiance, and mean of radiance times direction
    Colours down{}, up{};     // flux through the lowest and through the highest layer, means over the layer
  };
  // `source`: radiance that a point's medium gives where it is opaque. `around`: radiance that comes from outside, by
  // direction. Light that leaves the grid at a side and comes in at the other is that of the call before.
  Arrived sweep(const std::vector<Moments>& source, const std::vector<Colours>& around);
  const std::vector<Ordinate>& directions() const { return ordinates_; }

 private:
  struct Plane {
    std::vector<Colours> radiance, source;
    std::vector<float> extinction;
  };
  struct Path;
  void follow(const Path& path, std::vector<Colours>& kept, Arrived& arrived);
  void load(Plane& plane, const Path& path, int layer) const;
  void cross(const Path& path, int layer, Arrived& arrived);

  const InScatterGrid& grid_;
  std::vector<Ordinate> ordinates_;
  std::vector<std::vector<Colours>> kept_;  // radiance that left at the side, by direction
  Plane now_, before_;
};

}  // namespace cloudscape::bake
