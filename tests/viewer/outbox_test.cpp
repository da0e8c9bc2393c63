// Latest-wins sending and the same view after a reconnection.
#include "viewer/outbox.h"

#include <gtest/gtest.h>

namespace cloudscape::viewer {
namespace {

wire::Settings named(const std::string& cloudscape) {
  wire::Settings settings;
  settings.cloudscape = cloudscape;
  settings.size_px = {640, 360};
  return settings;
}

wire::Camera camera(std::uint64_t sequence, double east_m) {
  CameraPose pose;
  pose.position_m.x = east_m;
  return {sequence, pose, 1.5};
}

template <class T>
T next_as(Outbox& outbox) {
  const auto message = outbox.next();
  EXPECT_TRUE(message && std::holds_alternative<T>(*message));
  return message && std::holds_alternative<T>(*message) ? std::get<T>(*message) : T{};
}

TEST(Outbox, SaysNothingBeforeTheConnection) {
  Outbox outbox(named("a"));
  outbox.look(camera(1, 5));
  EXPECT_FALSE(outbox.next());
}

TEST(Outbox, HelloComesFirstAndOnce) {
  Outbox outbox(named("a"));
  outbox.connected();
  outbox.acknowledge({9, 1.0});
  EXPECT_EQ(next_as<wire::Hello>(outbox).settings.cloudscape, "a");
  EXPECT_EQ(next_as<wire::Ack>(outbox).frame_id, 9u);
  EXPECT_FALSE(outbox.next());
}

TEST(Outbox, OnlyTheNewestPoseIsSent) {
  Outbox outbox(named("a"));
  outbox.connected();
  outbox.next();
  for (int i = 1; i <= 5; ++i) outbox.look(camera(i, i));
  EXPECT_EQ(next_as<wire::Camera>(outbox).pose_sequence, 5u);
  EXPECT_FALSE(outbox.next());
}

TEST(Outbox, SettingsOfDifferentKindsAreSentTogether) {
  Outbox outbox(named("a"));
  outbox.connected();
  outbox.next();
  wire::Settings sun, size, later_sun;
  sun.sun_azimuth_deg = 10;
  size.size_px = {800, 600};
  later_sun.sun_azimuth_deg = 20;
  for (const auto& settings : {sun, size, later_sun}) outbox.change(settings);
  const auto sent = next_as<wire::Settings>(outbox);
  EXPECT_EQ(sent.sun_azimuth_deg, 20);
  EXPECT_EQ(sent.size_px, (ImageSize{800, 600}));
  EXPECT_FALSE(sent.cloudscape);
  EXPECT_FALSE(outbox.next());
}

TEST(Outbox, AReconnectionAsksForTheSameView) {
  Outbox outbox(named("a"));
  outbox.connected();
  outbox.next();
  wire::Settings changes;
  changes.sun_elevation_deg = 3;
  changes.size_px = {320, 180};
  outbox.change(changes);
  outbox.look(camera(7, 1234));
  while (outbox.next()) {
  }
  outbox.disconnected();
  outbox.connected();
  const wire::Settings again = next_as<wire::Hello>(outbox).settings;
  EXPECT_EQ(again.cloudscape, "a");
  EXPECT_EQ(again.size_px, (ImageSize{320, 180}));
  EXPECT_EQ(again.sun_elevation_deg, 3);
  EXPECT_EQ(again.time_s, 1.5);
  ASSERT_TRUE(again.pose);
  EXPECT_EQ(again.pose->position_m.x, 1234);
  EXPECT_EQ(next_as<wire::Camera>(outbox).pose_sequence, 7u) << "frames must carry the sequence that is waited for";
  EXPECT_FALSE(outbox.next());
}

TEST(Outbox, AcknowledgementsDieWithTheirConnection) {
  Outbox outbox(named("a"));
  outbox.connected();
  outbox.next();
  outbox.acknowledge({1, 1.0});
  outbox.disconnected();
  outbox.acknowledge({2, 1.0});
  outbox.connected();
  next_as<wire::Hello>(outbox);
  EXPECT_FALSE(outbox.next());
}

TEST(Outbox, ADocumentReplacesANameAndTheOtherWayRound) {
  wire::Settings settings = named("a"), document;
  document.cloudscape_document = "{}";
  merge(settings, document);
  EXPECT_FALSE(settings.cloudscape);
  merge(settings, named("b"));
  EXPECT_FALSE(settings.cloudscape_document);
  EXPECT_EQ(settings.cloudscape, "b");
}

TEST(Outbox, AResetSunForgetsTheAnglesBeforeIt) {
  wire::Settings settings, reset;
  settings.sun_azimuth_deg = 5;
  reset.reset_sun = true;
  merge(settings, reset);
  EXPECT_FALSE(settings.sun_azimuth_deg);
  EXPECT_TRUE(settings.reset_sun);
}

TEST(Outbox, TurnsTheClockAfterTheSettingsAndNotAgainAfterAReconnection) {
  Outbox outbox{wire::Settings{}};
  outbox.connected();
  EXPECT_TRUE(outbox.next());  // the hello
  outbox.turn({100, {}, {}});
  outbox.turn({200, {}, false});
  outbox.change(wire::Settings{});
  EXPECT_TRUE(std::holds_alternative<wire::Settings>(*outbox.next()));
  EXPECT_EQ(std::get<ClockChange>(*outbox.next()), (ClockChange{200, {}, false}));
  EXPECT_FALSE(outbox.next());
  outbox.turn({300, {}, {}});
  outbox.disconnected();
  outbox.connected();
  EXPECT_TRUE(std::holds_alternative<wire::Hello>(*outbox.next()));
  EXPECT_FALSE(outbox.next()) << "others may have turned it since";
}

}  // namespace
}  // namespace cloudscape::viewer
