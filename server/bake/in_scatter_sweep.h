// One iteration of the discrete ordinates: what all points scatter goes along every direction through the grid. On two
// threads: opposite directions do not meet.
#pragma once
#include <array>
#include <memory>
#include <span>

#include "bake/in_scatter.h"
#include "bake/ordinates.h"

namespace cloudscape::bake {

inline Colours colours(const glm::vec3& rgb) { return Colours{rgb.x, rgb.y, rgb.z, 0}; }
inline Colours all_of(float value) { return Colours{value, value, value, value}; }

class Sweeper {
 public:
  explicit Sweeper(const InScatterGrid& grid);
  ~Sweeper();
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
  struct Path;
  struct Group;
  class Hand;
  std::vector<Group> groups(const std::vector<Colours>& around) const;

  const InScatterGrid& grid_;
  std::vector<Ordinate> ordinates_;
  std::array<std::unique_ptr<Hand>, 2> hands_;  // for light that rises, or goes back, and for light that falls
};

}  // namespace cloudscape::bake
