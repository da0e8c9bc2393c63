#include "render/newly_seen.h"

#include <glm/geometric.hpp>

namespace cloudscape::render {
namespace {

// tuned: rays for what is newly seen, in those that the frame marches anyway. More, where one turns so quickly that
// nobody sees how sharp it is, would make the frame late.
constexpr double most_rays = 0.3;
// tuned: of its distance, by how much it moves at most. Within a cloud all is new in each frame, and too near to be
// seen sharply.
constexpr double most_motion_share = 0.1;

// Places of a picture (-1..1 each, y up) in the one before.
class Before {
 public:
  Before(const KeptView& now, const KeptView& before)
      : here_(camera_axes(now.pose)),
        there_(camera_axes(before.pose)),
        moved_m_(now.pose.position_m - before.pose.position_m),
        half_(half_height_of(now.vertical_fov_deg)),
        half_before_(half_height_of(before.vertical_fov_deg)),
        aspect_(now.aspect),
        aspect_before_(before.aspect) {}

  // Whether it shows what lies there, if that is so close.
  bool shows(double x, double y, double closeness_per_m) const {
    const glm::dvec3 ray = here_.forward + x * half_ * aspect_ * here_.right + y * half_ * here_.up;
    const glm::dvec3 seen = glm::normalize(ray) + closeness_per_m * moved_m_;
    const double reach = glm::dot(seen, there_.forward) * half_before_;
    return reach > 0 && std::abs(glm::dot(seen, there_.up)) <= reach &&
           std::abs(glm::dot(seen, there_.right)) <= reach * aspect_before_;
  }

  // Share of what is far away that it does not show.
  double missing_share() const {
    constexpr int columns = 32, rows = 18;
    int missing = 0;
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column)
        missing += shows((2 * column + 1.0) / columns - 1, (2 * row + 1.0) / rows - 1, 0) ? 0 : 1;
    return static_cast<double>(missing) / (columns * rows);
  }

  // Whether it shows all, be it far away or so close.
  bool shows_all(double closeness_per_m) const {
    for (const double x : {-1.0, 0.0, 1.0})
      for (const double y : {-1.0, 0.0, 1.0})
        if (!shows(x, y, 0) || !shows(x, y, closeness_per_m)) return false;
    return true;
  }

 private:
  CameraAxes here_, there_;
  glm::dvec3 moved_m_;
  double half_, half_before_, aspect_, aspect_before_;
};

}  // namespace

double most_newly_seen_closeness_per_m(double moved_m) { return most_motion_share / std::max(moved_m, 1e-6); }

bool marches_newly_seen(const ResolvePlan& plan, const KeptView& now, const std::optional<KeptView>& before) {
  if (plan.stride == 1 || !before || before->pose == now.pose || !same_clouds(*before->cloudscape, *now.cloudscape))
    return false;
  const Before shown(now, *before);
  const bool land = now.cloudscape->ground.kind == GroundKind::terrain;
  if (!land && shown.shows_all(most_newly_seen_closeness_per_m(moved_m(now, *before)))) return false;
  return shown.missing_share() * plan.stride * plan.stride <= most_rays;
}

}  // namespace cloudscape::render
