// Moving pictures that are put together from parts: nothing of them may show how.
#include <algorithm>
#include <set>

#include "gpu/render/fixture.h"
#include "render/newly_seen.h"
#include "render/resolve_plan.h"

namespace cloudscape::render {
namespace {

// Clouds above a plain, from below.
FrameRequest moving(int reuse, int divisor, StreamId stream) {
  FrameRequest request;
  auto sky = std::make_shared<Cloudscape>(small_clouds());
  sky->sun.elevation_deg = 50;
  request.cloudscape = sky;
  request.pose.position_m = {0, 0, 200};
  request.pose.elevation_deg = 20;
  request.size_px = {192, 108};
  request.quality = render_quality(Quality::interactive);
  request.quality.reuse = reuse, request.quality.resolution_divisor = divisor;
  request.display.dither = false;
  request.display.bloom_strength = 0;
  request.stream = stream;
  return request;
}

// The same, marched whole: the mean of some samples.
FrameRequest whole(FrameRequest request, int samples) {
  request.quality.reuse = request.quality.resolution_divisor = 1;
  request.quality.smooth = false;
  request.quality.samples = samples;
  request.stream = next_stream();
  return request;
}

// Root of the mean squared difference, in display steps; of the columns from `first` on.
double difference(const Frame& a, const Frame& b, int first = 0) {
  const ImageSize size = a.request.size_px;
  double sum = 0;
  for (int y = 0; y < size.height; ++y)
    for (int i = 4 * first; i < 4 * size.width; ++i) {
      const auto at = static_cast<std::size_t>(4 * size.width * y + i);
      const double d = static_cast<double>(a.display_rgba[at]) - b.display_rgba[at];
      sum += d * d;
    }
  return std::sqrt(sum / (3 * (size.width - first) * size.height));
}

class Resolver : public RenderTest {
 protected:
  // From within a cloud without end.
  FrameRequest within_fog() const {
    FrameRequest request = moving(16, 2, next_stream());
    auto fog = std::make_shared<Cloudscape>(*request.cloudscape);
    fog->shape.coverage = 1, fog->medium.extinction_per_m = 0.08;
    request.cloudscape = fog;
    request.pose.position_m.z = fog->volume.origin_m.z + 0.1 * fog->volume.size_m.z;
    return request;
  }
  // Four channels of a kept picture, 32 bits each without a GPU.
  static std::size_t kept_pixel_bytes() { return stack().context.device().software ? 16 : 8; }
  static Frame last_of(FrameRequest request, int frames, double turn_deg = 0, double climb_m = 0) {
    Frame frame;
    for (int i = 0; i < frames; ++i) {
      frame = renderer().render(request);
      request.pose.azimuth_deg += turn_deg;
      request.pose.position_m.z += climb_m;
    }
    renderer().forget(request.stream);
    return frame;
  }
};

TEST(ResolvePlanTest, every_pixel_of_a_block_is_marched_once_in_a_round) {
  for (const int stride : {1, 2, 4}) {
    std::set<std::pair<int, int>> seen;
    const auto all = static_cast<std::uint64_t>(stride * stride);
    for (std::uint64_t frame = 7 * all; frame < 8 * all; ++frame) {
      const glm::ivec2 at = marched_pixel(stride, frame);
      ASSERT_TRUE(at.x >= 0 && at.x < stride && at.y >= 0 && at.y < stride);
      seen.insert({at.x, at.y});
    }
    EXPECT_EQ(seen.size(), all);
  }
}

TEST(ResolvePlanTest, four_pixels_in_a_row_lie_in_four_quarters_of_a_block) {
  std::set<std::pair<int, int>> quarters;
  for (std::uint64_t frame = 0; frame < 4; ++frame) {
    const glm::ivec2 at = marched_pixel(4, frame);
    quarters.insert({at.x / 2, at.y / 2});
  }
  EXPECT_EQ(quarters.size(), 4u);
}

TEST(ResolvePlanTest, whole_blocks_hold_the_picture_in_their_middle) {
  FrameRequest request;
  request.size_px = {1278, 715};
  request.quality.reuse = 16, request.quality.resolution_divisor = 2;
  const ResolvePlan plan = resolve_plan(request);
  EXPECT_EQ(plan.kept.width % 4, 0);
  EXPECT_EQ(plan.kept.height % 4, 0);
  EXPECT_GE(plan.kept.width * 2, 1278);
  EXPECT_GE(plan.kept.height * 2, 715);
  EXPECT_DOUBLE_EQ(plan.margin_px.x, 0.5 * (plan.kept.width - 639.0));
  EXPECT_DOUBLE_EQ(plan.margin_px.y, 0.5 * (plan.kept.height - 357.5));
  // A kept pixel is as wide as it is high, and as wide as two of the shown ones.
  const KeptView view = kept_view(request, plan);
  const double half = std::tan(radians(view.vertical_fov_deg) / 2);
  EXPECT_NEAR(half / plan.kept.height, 2 * std::tan(radians(request.lens.vertical_fov_deg) / 2) / 715, 1e-12);
}

// What is newly seen gets rays of its own where it is there, and not more than a frame has time for.
TEST(NewlySeenTest, is_marched_at_the_edges_of_a_turn_that_is_not_quick) {
  const FrameRequest request = moving(16, 1, 1);
  const ResolvePlan plan = resolve_plan(request);
  const KeptView before = kept_view(request, plan);
  const auto marches = [&](const glm::dvec3& moved_m, double turned_deg, const ResolvePlan& by,
                           GroundKind ground = GroundKind::plain) {
    KeptView now = before, then = before;
    auto sky = std::make_shared<Cloudscape>(*request.cloudscape);
    sky->ground.kind = ground;
    now.cloudscape = then.cloudscape = sky;
    now.pose.position_m += moved_m, now.pose.azimuth_deg += turned_deg;
    return marches_newly_seen(by, now, then);
  };
  const glm::dvec3 nowhere(0), forward(0, 3, 1), sideways(5, 0, 0);
  EXPECT_FALSE(marches(nowhere, 0, plan)) << "it stands still";
  EXPECT_TRUE(marches(nowhere, 0.8, plan));
  EXPECT_FALSE(marches(nowhere, 20, plan)) << "nobody sees how sharp that is";
  EXPECT_FALSE(marches(forward, 0, plan)) << "all was in the picture before";
  EXPECT_TRUE(marches(forward, 0, plan, GroundKind::terrain)) << "but what land hid";
  EXPECT_TRUE(marches(sideways, 0, plan)) << "what is near comes in";
  EXPECT_FALSE(marches(nowhere, 0.8, resolve_plan(moving(1, 2, 1)))) << "every pixel is marched";
  EXPECT_FALSE(marches_newly_seen(plan, before, std::nullopt));
}

// Of the tone curve at each kept pixel, enlarged, against that of each shown pixel; in steps of 8 bits.
TEST_F(Resolver, developed_picture_is_the_tone_mapped_one_where_it_is_smooth) {
  for (const ToneCurve curve : {ToneCurve::agx, ToneCurve::aces, ToneCurve::reinhard, ToneCurve::none}) {
    FrameRequest request = moving(1, 2, next_stream());
    request.cloudscape = std::make_shared<Cloudscape>(clear_world(30));
    request.pose.azimuth_deg = 120, request.pose.elevation_deg = 50;
    request.display.tone_curve = curve, request.display.exposure_ev = 4;
    const Frame developed = last_of(request, 1), exact = render(whole(request, 1));
    int most = 0, least = 255, farthest = 0;
    double sum = 0;
    for (std::size_t i = 0; i < exact.display_rgba.size(); ++i) {
      if (i % 4 == 3) continue;
      const int off = std::abs(int{developed.display_rgba[i]} - int{exact.display_rgba[i]});
      farthest = std::max(farthest, off), sum += off;
      most = std::max(most, int{exact.display_rgba[i]}), least = std::min(least, int{exact.display_rgba[i]});
    }
    EXPECT_GT(most, least + 20) << "nothing to see";
    EXPECT_LE(farthest, 2) << static_cast<int>(curve);  // it is rounded thrice
    EXPECT_LT(sum / (0.75 * static_cast<double>(exact.display_rgba.size())), 0.25) << static_cast<int>(curve);
  }
}

// A resting picture becomes the one that is marched whole. Four whole samples differ from it by 2.3 steps, eight
// by 1.4; half the resolution costs the edges.
TEST_F(Resolver, resting_picture_is_the_whole_one) {
  const FrameRequest request = moving(16, 1, next_stream());
  const Frame truth = render(whole(request, 32));
  EXPECT_LT(difference(last_of(request, 64), truth), 3);
  EXPECT_LT(difference(last_of(moving(4, 1, next_stream()), 32), truth), 2);
  EXPECT_LT(difference(last_of(moving(4, 2, next_stream()), 32), truth), 9);
}

// Without what is kept a frame of a sixteenth of the pixels is far off.
TEST_F(Resolver, turning_picture_is_nearer_to_the_whole_one_than_its_samples_alone) {
  FrameRequest request = moving(16, 1, next_stream());
  FrameRequest there = request;
  there.pose.azimuth_deg += 11 * 0.5;
  const Frame truth = render(whole(there, 32));
  const double turned = difference(last_of(request, 12, 0.5), truth);
  there.stream = next_stream();
  const double alone = difference(last_of(there, 1), truth);
  EXPECT_LT(turned, 0.9 * alone);
}

// What a turn brings in is marched at once, pixel by pixel: the last columns are as sharp as the others.
TEST_F(Resolver, edge_that_is_newly_seen_is_sharp) {
  constexpr double turn_deg = 0.8;  // some 3 columns
  const auto error_of_edge = [&](int divisor) {
    FrameRequest there = moving(16, divisor, next_stream());
    there.pose.azimuth_deg += 11 * turn_deg;
    const Frame turned = last_of(moving(16, divisor, next_stream()), 12, turn_deg);
    return difference(turned, render(whole(there, 32)), turned.request.size_px.width - 3);
  };
  EXPECT_LT(error_of_edge(1), 8.0);   // 10.5 if it begins as what lies between the rays of the frame, 5.2 here
  EXPECT_LT(error_of_edge(2), 12.5);  // 17.0, and 10.2
}

TEST_F(Resolver, climbing_picture_keeps_its_clouds_in_place) {
  FrameRequest request = moving(4, 1, next_stream());
  FrameRequest there = request;
  there.pose.position_m.z += 11 * 3;
  EXPECT_LT(difference(last_of(request, 12, 0, 3), render(whole(there, 32))), 9);
}

// Within a cloud a frame's rays differ by where their steps begin, and what is kept has gone by before it is a picture.
TEST_F(Resolver, fog_has_no_dots) {
  FrameRequest request = within_fog();
  FrameRequest there = request;
  there.pose.azimuth_deg += 11 * 2.0, there.pose.position_m.z += 11 * 4.0;
  EXPECT_LT(difference(last_of(request, 12, 2, 4), render(whole(there, 32))), 1.6);  // 2.4 if they are not evened
}

// Out of a cloud at once: what one sees then hardly moves, and is bounded all the same.
TEST_F(Resolver, cloud_that_one_has_left_does_not_stay) {
  FrameRequest request = within_fog();
  for (int i = 0; i < 8; ++i) renderer().render(request);
  const Volume& fog = request.cloudscape->volume;
  request.pose.position_m.z = fog.origin_m.z + 2 * fog.size_m.z;  // and sees the sky
  FrameRequest there = request;
  there.pose.position_m.z += 2 * 0.1;
  EXPECT_LT(difference(last_of(request, 3, 0, 0.1), render(whole(there, 32))),
            25);  // 32 without the bound: 24x14 rays of sky differ much
}

// Ridges before land far behind them, from a climb: of four rays about an outline some see the one, some the other.
TEST_F(Resolver, land_keeps_its_outline) {
  FrameRequest request = moving(16, 2, next_stream());
  auto land = std::make_shared<Cloudscape>(*request.cloudscape);
  land->ground.kind = GroundKind::terrain;
  land->ground.terrain.resolution = 128;
  land->ground.terrain.size_m = 6000, land->ground.terrain.height_m = 1200;
  land->medium.extinction_per_m = 0;
  request.cloudscape = land;
  request.pose = {{0, 0, 700}, 0, 0, 0};
  FrameRequest there = request;
  there.pose.position_m.z += 11 * 20;
  EXPECT_LT(difference(last_of(request, 12, 0, 20), render(whole(there, 8))), 8.2);  // 10.1 without, 7.1 here
}

// A ray that begins within the ground sees it at no distance, and not nothing.
TEST_F(Resolver, below_the_ground_is_as_dark_as_the_whole_picture) {
  FrameRequest request = moving(16, 2, next_stream());
  request.pose.position_m.z = -5;
  FrameRequest there = request;
  there.pose.position_m.z -= 3;
  EXPECT_LT(difference(last_of(request, 4, 0, -1), render(whole(there, 4))), 2);
}

TEST_F(Resolver, equal_flights_give_equal_bytes) {
  EXPECT_EQ(last_of(moving(16, 2, next_stream()), 5, 1).display_rgba,
            last_of(moving(16, 2, next_stream()), 5, 1).display_rgba);
}

// Nothing of another sky, and after some frames nothing of another light, is left.
TEST_F(Resolver, other_skies_and_other_suns_leave_no_ghost) {
  FrameRequest request = moving(4, 1, next_stream());
  FrameRequest other = request;
  auto sky = std::make_shared<Cloudscape>(*request.cloudscape);
  sky->seed = 9;
  other.cloudscape = sky;
  const Frame truth = render(whole(request, 32));
  const double fresh = difference(last_of(moving(4, 1, next_stream()), 1), truth);
  for (int i = 0; i < 8; ++i) renderer().render(other);
  EXPECT_LT(difference(renderer().render(request), truth), 1.1 * fresh);
  auto dusk = std::make_shared<Cloudscape>(*request.cloudscape);
  dusk->sun.elevation_deg = 8;
  request.cloudscape = dusk;
  const Frame changed = last_of(request, 8);
  EXPECT_LT(difference(changed, render(whole(request, 32))), 6);
}

// A picture that was kept before the stream showed another view, marched whole, is not continued.
TEST_F(Resolver, picture_of_an_earlier_view_is_dropped) {
  FrameRequest request = moving(4, 1, next_stream());
  renderer().render(request);
  FrameRequest other = whole(request, 1);
  other.stream = request.stream;
  renderer().render(other);
  const std::size_t both = renderer().history_bytes(request.stream);
  other.pose.azimuth_deg += 40;
  renderer().render(other);
  EXPECT_EQ(both - renderer().history_bytes(request.stream), 192u * 108u * kept_pixel_bytes());
  renderer().forget(request.stream);
}

// Its average may not stay on the device for streams that have gone.
TEST_F(Resolver, forgets_streams) {
  const std::size_t before = renderer().history_bytes();
  const FrameRequest request = moving(4, 2, next_stream());
  renderer().render(request);
  EXPECT_EQ(renderer().history_bytes() - before, 96u * 54u * kept_pixel_bytes());
  renderer().forget(request.stream);
  EXPECT_EQ(renderer().history_bytes(), before);
}

}  // namespace
}  // namespace cloudscape::render
