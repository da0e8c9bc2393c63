// The colour spaces of FLIP (Andersson et al. 2020, section 4; NVlabs/flip): sRGB's primaries, white point D65.
#pragma once
#include <glm/vec3.hpp>

namespace cloudscape::bench {

glm::dvec3 linear_from_srgb(const glm::dvec3& srgb);
glm::dvec3 srgb_from_linear(const glm::dvec3& linear);
// YyCxCz (Flohr et al. 1993): a linear opponent space, achromatic, red-green, blue-yellow.
glm::dvec3 opponent_from_linear(const glm::dvec3& linear);
glm::dvec3 linear_from_opponent(const glm::dvec3& opponent);
// L*a*b* whose chroma grows with the lightness (Hunt 1952), as a display's does with its luminance.
glm::dvec3 hunt_lab_from_linear(const glm::dvec3& linear);
// City-block in lightness and Euclidean in chroma (Abasi et al. 2020), of two such colours.
double hyab(const glm::dvec3& a, const glm::dvec3& b);

}  // namespace cloudscape::bench
