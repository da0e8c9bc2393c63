#include "bench/flip_color.h"

#include <cmath>
#include <glm/glm.hpp>

namespace cloudscape::bench {
namespace {

// CIE XYZ of sRGB's primaries, as fractions, in columns (IEC 61966-2-1; the table that NVlabs/flip names). White is
// their sum.
const glm::dmat3 xyz_from_linear_matrix{10135552.0 / 24577794, 2613072.0 / 12288897, 1425312.0 / 73733382,
                                        8788810.0 / 24577794,  8788810.0 / 12288897, 8788810.0 / 73733382,
                                        4435075.0 / 24577794,  887015.0 / 12288897,  70074185.0 / 73733382};
const glm::dmat3 linear_from_xyz_matrix = glm::inverse(xyz_from_linear_matrix);
const glm::dvec3 white = xyz_from_linear_matrix * glm::dvec3(1);

glm::dvec3 each(const glm::dvec3& v, double (*function)(double)) {
  return {function(v.x), function(v.y), function(v.z)};
}

// XYZ over white's.
glm::dvec3 relative_xyz(const glm::dvec3& linear) { return xyz_from_linear_matrix * linear / white; }

// CIE 1976.
double lab_curve(double t) {
  constexpr double delta = 6.0 / 29;
  return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
}

// L*a*b* of the relative XYZ's curve; YyCxCz of the relative XYZ itself.
glm::dvec3 opposed(const glm::dvec3& t) { return {116 * t.y - 16, 500 * (t.x - t.y), 200 * (t.y - t.z)}; }

}  // namespace

glm::dvec3 linear_from_srgb(const glm::dvec3& srgb) {
  return each(srgb, [](double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); });
}

glm::dvec3 srgb_from_linear(const glm::dvec3& linear) {
  return each(linear, [](double x) { return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055; });
}

glm::dvec3 opponent_from_linear(const glm::dvec3& linear) { return opposed(relative_xyz(linear)); }

glm::dvec3 linear_from_opponent(const glm::dvec3& opponent) {
  const double y = (opponent.x + 16) / 116;
  return linear_from_xyz_matrix * (glm::dvec3(y + opponent.y / 500, y, y - opponent.z / 200) * white);
}

glm::dvec3 hunt_lab_from_linear(const glm::dvec3& linear) {
  const glm::dvec3 lab = opposed(each(relative_xyz(linear), lab_curve));
  return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
}

double hyab(const glm::dvec3& a, const glm::dvec3& b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

}  // namespace cloudscape::bench
