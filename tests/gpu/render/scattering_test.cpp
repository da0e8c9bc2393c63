// Single scattering of homogeneous media, against closed forms and an independent quadrature in double precision.
#include "fixture.h"

namespace cloudscape::render {
namespace {

constexpr double g = 0.5;
using Scattering = RenderTest;

Cloudscape lit_from(Cloudscape sky, double azimuth_deg, double elevation_deg) {
  sky.medium.phase = {PhaseKind::henyey_greenstein, g};
  sky.sun.azimuth_deg = azimuth_deg;
  sky.sun.elevation_deg = elevation_deg;
  return sky;
}

TEST_F(Scattering, BackFromTheMiddleOfASphere) {
  for (const double t : {0.1, 1.0, 5.0}) {
    const double radiance = red(render(one_beam(lit_from(ball(100, t), 180, 0), {camera_m, 0, 0, 0})));
    const double expected = henyey_greenstein(-1, g) * (1 - std::exp(-4 * t)) / 2;
    EXPECT_NEAR(radiance / expected, 1, 0.01) << "optical radius " << t;
  }
}

TEST_F(Scattering, ForwardThroughTheMiddleOfASphere) {
  for (const double t : {0.1, 1.0, 5.0}) {
    const double radiance = red(render(one_beam(lit_from(ball(100, t), 0, 0), {camera_m, 0, 0, 0})));
    const double expected = 2 * t * henyey_greenstein(1, g) * std::exp(-2 * t);
    EXPECT_NEAR(radiance / expected, 1, 0.01) << "optical radius " << t;
  }
}

// Where a ray of unit direction leaves the unit ball that `p` is in.
double way_out(const glm::dvec3& p, const glm::dvec3& direction) {
  const double b = glm::dot(p, direction);
  return -b + std::sqrt(b * b - glm::dot(p, p) + 1);
}

// Midpoint rule over the chord; the light's way to each point is exact.
double sphere_radiance(double t, const glm::dvec3& direction, const glm::dvec3& sun, const glm::dvec3& closest) {
  const double half = std::sqrt(1 - glm::dot(closest, closest));
  const int parts = 20000;
  double sum = 0;
  for (int i = 0; i < parts; ++i) {
    const double s = 2 * half * (i + 0.5) / parts;
    const glm::dvec3 p = closest + direction * (s - half);
    sum += std::exp(-t * (s + way_out(p, sun)));
  }
  return t * henyey_greenstein(glm::dot(direction, sun), g) * sum * 2 * half / parts;
}

TEST_F(Scattering, OfASphereSeenFromTheSide) {
  const glm::dvec3 north(0, 1, 0);
  for (const double t : {0.2, 1.0, 4.0})
    for (const double beside : {0.0, 0.6}) {
      FrameRequest request = one_beam(lit_from(ball(100, t), 90, 30), {camera_m, 0, 0, 0});
      request.pose.position_m.x += beside * 100;
      const glm::dvec3 sun(std::cos(radians(30)), 0, std::sin(radians(30)));
      const double expected = sphere_radiance(t, north, sun, {beside, 0, 0});
      EXPECT_NEAR(red(render(request)) / expected, 1, 0.01) << "optical radius " << t << ", beside " << beside;
    }
}

// Through the middle of a Gaussian, lit at a right angle: what lies towards the sun of each point is half a Gaussian.
TEST_F(Scattering, OfAGaussianSeenFromTheSide) {
  const double s_m = 50, extinction_per_m = 0.02;
  const Cloudscape sky =
      homogeneous(VolumeKind::gaussian, ball_center_m - 4 * s_m, glm::dvec3(8 * s_m), extinction_per_m);
  const double half_width_m = s_m * std::sqrt(std::numbers::pi / 2) * std::erf(4 / std::sqrt(2.0));
  const int parts = 20000;
  const double part_m = 8 * s_m / parts;
  double optical_depth = 0, sum = 0;
  for (int i = 0; i < parts; ++i) {
    const double y = (i + 0.5) * part_m - 4 * s_m;
    const double local_per_m = extinction_per_m * std::exp(-0.5 * y * y / (s_m * s_m));
    optical_depth += 0.5 * local_per_m * part_m;
    sum += local_per_m * part_m * std::exp(-optical_depth - local_per_m * half_width_m);
    optical_depth += 0.5 * local_per_m * part_m;
  }
  const double radiance = red(render(one_beam(lit_from(sky, 90, 0), {camera_m, 0, 0, 0})));
  EXPECT_NEAR(radiance / (henyey_greenstein(0, g) * sum), 1, 0.01);
}

struct SlabCase {
  double optical_thickness, sun_elevation_deg, view_elevation_deg;
};

TEST_F(Scattering, ReflectedByASlab) {
  for (const SlabCase& slab : {SlabCase{0.3, 90, 90}, SlabCase{2, 90, 40}, SlabCase{2, 35, 60}, SlabCase{4, 20, 25}}) {
    const Cloudscape sky = homogeneous(VolumeKind::slab, {0, 0, 2000}, {1000, 1000, 500}, slab.optical_thickness / 500);
    const double mu = std::sin(radians(slab.view_elevation_deg)), mu_sun = std::sin(radians(slab.sun_elevation_deg));
    // Sun in the east, camera looking down to the north: no azimuth in common.
    const Frame frame =
        render(one_beam(lit_from(sky, 90, slab.sun_elevation_deg), {{0, 0, 5000}, 0, -slab.view_elevation_deg, 0}));
    const double expected = henyey_greenstein(-mu * mu_sun, g) * mu_sun / (mu + mu_sun) *
                            (1 - std::exp(-slab.optical_thickness * (1 / mu + 1 / mu_sun)));
    EXPECT_NEAR(red(frame) / expected, 1, 0.01)
        << slab.optical_thickness << ", " << slab.sun_elevation_deg << ", " << slab.view_elevation_deg;
  }
}

TEST_F(Scattering, TransmittedByASlab) {
  for (const SlabCase& slab : {SlabCase{0.3, 90, 60}, SlabCase{2, 35, 60}, SlabCase{3, 50, 30}}) {
    const Cloudscape sky = homogeneous(VolumeKind::slab, {0, 0, 2000}, {1000, 1000, 500}, slab.optical_thickness / 500);
    const double mu = std::sin(radians(slab.view_elevation_deg)), mu_sun = std::sin(radians(slab.sun_elevation_deg));
    const Frame frame =
        render(one_beam(lit_from(sky, 90, slab.sun_elevation_deg), {camera_m, 0, slab.view_elevation_deg, 0}));
    const double expected = henyey_greenstein(mu * mu_sun, g) * mu_sun / (mu_sun - mu) *
                            (std::exp(-slab.optical_thickness / mu_sun) - std::exp(-slab.optical_thickness / mu));
    EXPECT_NEAR(red(frame) / expected, 1, 0.01)
        << slab.optical_thickness << ", " << slab.sun_elevation_deg << ", " << slab.view_elevation_deg;
  }
}

TEST_F(Scattering, IsProportionalToTheAlbedoAndByColour) {
  Cloudscape sky = lit_from(ball(100, 1), 90, 0);
  sky.sun.irradiance = {1, 2, 4};
  const Frame white = render(one_beam(sky, {camera_m, 0, 0, 0}));
  sky.medium.single_scattering_albedo = 0.5;
  const Frame grey = render(one_beam(sky, {camera_m, 0, 0, 0}));
  EXPECT_NEAR(red(grey) / red(white), 0.5, 1e-5);
  EXPECT_NEAR(white.radiance_rgba[1] / red(white), 2, 1e-5);
  EXPECT_NEAR(white.radiance_rgba[2] / red(white), 4, 1e-5);
  EXPECT_EQ(opacity(grey), opacity(white));
}

// Towards the sun is forward: with g > 0 a thin ball in front of the sun outshines one in the back by p(0) / p(180).
TEST_F(Scattering, IsBrighterTowardsTheSun) {
  const double forward = red(render(one_beam(lit_from(ball(100, 0.001), 0, 0), {camera_m, 0, 0, 0})));
  const double back = red(render(one_beam(lit_from(ball(100, 0.001), 180, 0), {camera_m, 0, 0, 0})));
  EXPECT_GT(forward, back);
  EXPECT_NEAR(forward / back, henyey_greenstein(1, g) / henyey_greenstein(-1, g), 0.01 * forward / back);
}

TEST_F(Scattering, FollowsEachPhaseFunction) {
  const double angle_deg = 50, mu = std::cos(radians(angle_deg)), sphere = 4 * std::numbers::pi;
  const auto radiance_of = [&](const Phase& phase) {
    Cloudscape sky = lit_from(ball(100, 0.001), angle_deg, 0);
    sky.medium.phase = phase;
    return red(render(one_beam(sky, {camera_m, 0, 0, 0}))) / 0.002;  // 2 t p, but for 0.2 %
  };
  EXPECT_NEAR(radiance_of({PhaseKind::isotropic}) * sphere, 1, 0.003);
  EXPECT_NEAR(radiance_of({PhaseKind::rayleigh}) * sphere, 0.75 * (1 + mu * mu), 0.003);
  EXPECT_NEAR(radiance_of({PhaseKind::henyey_greenstein, 0.7}) / henyey_greenstein(mu, 0.7), 1, 0.003);
  EXPECT_NEAR(radiance_of({PhaseKind::two_lobe, 0.7, -0.4, 0.25}) /
                  (0.75 * henyey_greenstein(mu, 0.7) + 0.25 * henyey_greenstein(mu, -0.4)),
              1, 0.003);
}

// Inside a slab and level, everything that is seen lies under one optical depth of medium: what comes back is the light
// function itself.
double light_at(LightModel light, double optical_depth, const auto& render) {
  Cloudscape sky = lit_from(homogeneous(VolumeKind::slab, {0, 0, 1000}, {1000, 1000, 1000}, 0.004), 0, 90);
  sky.medium.light_model = light;
  return red(render(one_beam(sky, {{0, 0, 2000 - optical_depth / 0.004}, 30, 0, 0})));
}

TEST_F(Scattering, LightModelsAreTheirFormulas) {
  const auto ray = [](const FrameRequest& request) { return render(request); };
  for (const double d : {0.1, 1.0, 3.0}) {
    const double first = henyey_greenstein(0, g) * std::exp(-d);
    EXPECT_NEAR(light_at({LightModelKind::single}, d, ray) / first, 1, 2e-3);
    LightModel olajos{LightModelKind::olajos};
    olajos.olajos_dark = glm::dvec3(0);
    olajos.olajos_attenuation = 0.3, olajos.olajos_in_scatter = 1.7, olajos.olajos_gain = 0.8;
    const double in_scattered = std::exp(-0.3 * d) * (1 - std::exp(-1.7 * d));
    EXPECT_NEAR(light_at(olajos, d, ray) / (first + 0.8 / (4 * std::numbers::pi) * in_scattered), 1, 2e-3);
    for (const int octaves : {1, 3, 4, 5, 8}) {
      LightModel beer{LightModelKind::beer_octaves};
      beer.octaves = octaves, beer.octave_scattering = 0.7, beer.octave_extinction = 0.5, beer.octave_asymmetry = 0.6;
      double sum = 0;
      for (int i = 0; i < octaves; ++i)
        sum += std::pow(0.7, i) * henyey_greenstein(0, g * std::pow(0.6, i)) * std::exp(-std::pow(0.5, i) * d);
      EXPECT_NEAR(light_at(beer, d, ray) / sum, 1, 2e-3) << octaves << " octaves at depth " << d;
    }
  }
}

// Under a constant source the radiance is source (1 - T), in one step as in many.
TEST_F(Scattering, ConservesEnergyInEverySizeOfStep) {
  Cloudscape sky = homogeneous(VolumeKind::box, {-500, 900, 950}, {1000, 300, 100}, 0.004);
  sky.sky.kind = SkyKind::uniform;
  sky.sky.radiance = glm::dvec3(2);
  sky.sun.irradiance = glm::dvec3(0);
  sky.medium.ambient = 1;
  double source = 0;
  for (const double extinction_per_m : {0.001, 0.004, 0.016})
    for (const int steps : {1, 8, 64}) {
      sky.medium.extinction_per_m = extinction_per_m;
      FrameRequest request = one_ray(sky, {camera_m, 0, 0, 0});
      request.size_px = {5, 1};  // pixels differ in where in their steps they look
      request.lens = {LensKind::orthographic, 50, 1};
      request.quality.max_steps = steps;
      const Frame frame = render(request);
      for (int pixel = 0; pixel < 5; ++pixel) {
        const double transmittance = std::exp(-extinction_per_m * 300);
        const double here = (red(frame, pixel) - 2 * transmittance) / (1 - transmittance);
        if (source == 0) source = here;
        EXPECT_NEAR(here / source, 1, 1e-3) << extinction_per_m << " 1/m, " << steps << " steps, pixel " << pixel;
      }
    }
  EXPECT_GT(source, 0.2);
  EXPECT_LE(source, 2) << "no more light can come out than the surroundings send";
}

}  // namespace
}  // namespace cloudscape::render
