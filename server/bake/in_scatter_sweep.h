// One iteration of the discrete ordinates: what all points scatter goes along every direction through the grid.
#pragma once
#include <span>

#include "bake/in_scatter.h"
#include "bake/ordinates.h"

namespace cloudscape::bake {

inline Colours colours(const glm::vec3& rgb) { return Colours{rgb.x, rgb.y, rgb.z, 0}; }
inline Colours all_of(float value) { return Colours{value, value, value, value}; }

class Sweeper {
 public:
  explicit Sweeper(const InScatterGrid& grid);
  struct Arrived {
    std::vector<Moments> at;  // mean radiance, and mean of radiance times direction
    Colours down{}, up{};     // flux through the lowest and through the highest layer, means over the layer
  };
  // `source`: radiance that a point's medium gives where it is opaque. `around`: radiance that comes from outside, by
  // direction. `crossing`, of `crossing_count`: light that comes in at a side because it left at the other; replaced by
  // what leaves now.
  Arrived sweep(std::span<const Moments> source, const std::vector<Colours>& around, std::span<Colours> crossing);
  std::size_t crossing_count() const;
  const std::vector<Ordinate>& directions() const { return ordinates_; }

 private:
  // Of one direction in the points of a layer.
  struct Plane {
    std::vector<Colours> radiance, source;
  };
  struct Path;
  struct Group;
  std::vector<Group> groups(const std::vector<Colours>& around) const;
  void follow(const Group& group, std::span<const Moments> source, std::span<Colours> crossing, Arrived& arrived);
  void begin(const Group& group, std::span<const Moments> source, std::span<const Colours> crossing);
  void load(const Group& group, std::span<const Moments> source, int layer);
  void cross(const Group& group, std::size_t number);
  void add(const Group& group, int layer, Arrived& arrived);

  const InScatterGrid& grid_;
  std::vector<Ordinate> ordinates_;
  std::vector<Plane> now_, before_;  // by direction of a group
  std::vector<float> extinction_, extinction_before_;
  std::vector<Moments> moments_;  // of the layer: its sources, then what came to it
};

}  // namespace cloudscape::bake
