// Addresses, refusals and sizes.
#include "viewer/endpoint.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "viewer/closing.h"
#include "viewer/fit.h"
#include "viewer/sight.h"

namespace cloudscape::viewer {
namespace {

using testing::HasSubstr;

TEST(Endpoint, UnderstandsWhatAServerPrintsAndAPersonTypes) {
  EXPECT_EQ(parse_endpoint("ws://127.0.0.1:8080"), (Endpoint{"127.0.0.1", 8080, false, "/api/v1/stream", ""}));
  EXPECT_EQ(parse_endpoint("http://sky.example:81/#token=a1b2"),
            (Endpoint{"sky.example", 81, false, "/api/v1/stream", "a1b2"}));
  EXPECT_EQ(parse_endpoint("wss://sky.example"), (Endpoint{"sky.example", 443, true, "/api/v1/stream", ""}));
  EXPECT_EQ(parse_endpoint("ws://[::1]:9000/clouds/"), (Endpoint{"::1", 9000, false, "/clouds/api/v1/stream", ""}));
  EXPECT_EQ(parse_endpoint("ws://h:1/api/v1/stream").path, "/api/v1/stream");
}

TEST(Endpoint, RefusesWhatIsNoAddress) {
  for (const char* url : {"", "sky", "127.0.0.1:8080", "ftp://h:1", "ws://", "ws://:80", "ws://h:0", "ws://h:70000"})
    EXPECT_THAT([&] { parse_endpoint(url); }, testing::ThrowsMessage<InvalidInput>(HasSubstr("ws://HOST:PORT"))) << url;
}

TEST(Endpoint, AuthorityBracketsAddressesWithColons) {
  EXPECT_EQ(authority({"::1", 80, false, "", ""}), "[::1]:80");
  EXPECT_EQ(authority({"h", 80, false, "", ""}), "h:80");
}

Closing answered(int status) {
  Closing closing;
  closing.http_status = status;
  return closing;
}
Closing closed_with(int code) {
  Closing closing;
  closing.close_code = code;
  closing.was_open = true;
  return closing;
}

TEST(Closing, RefusalsEndItAndSayWhatToDo) {
  EXPECT_THAT(*refusal(answered(401), "h:1"), HasSubstr("--token"));
  EXPECT_THAT(*refusal(answered(403), "h:1"), HasSubstr("403"));
  EXPECT_THAT(*refusal(answered(426), "h:1"), HasSubstr("version"));
  EXPECT_THAT(*refusal(answered(200), "h:1"), HasSubstr("no cloudscape server"));
  EXPECT_TRUE(refusal(closed_with(1008), "h:1"));
}

TEST(Closing, WhatPassesWithTimeIsTriedAgain) {
  for (const int status : {0, 408, 429, 500, 502, 503}) EXPECT_FALSE(refusal(answered(status), "h:1")) << status;
  for (const int code : {0, 1000, 1001, 1006, 1011, 1012, 1013})
    EXPECT_FALSE(refusal(closed_with(code), "h:1")) << code;
  EXPECT_THAT(describe(answered(503), "h:1"), HasSubstr("503"));
}

TEST(Fit, KeepsThePicturesShapeInTheMiddle) {
  EXPECT_EQ(fit({640, 360}, {1280, 720}), (Rectangle{0, 0, 1280, 720}));
  EXPECT_EQ(fit({100, 100}, {300, 100}), (Rectangle{100, 0, 100, 100}));
  EXPECT_EQ(fit({100, 50}, {100, 100}), (Rectangle{0, 25, 100, 50}));
}

TEST(Fit, AsksForNoMoreThanTheServerGives) {
  EXPECT_EQ(within({800, 600}, {3840, 3840}), (ImageSize{800, 600}));
  EXPECT_EQ(within({4000, 2000}, {2000, 2000}), (ImageSize{2000, 1000}));
  EXPECT_EQ(within({5, 100000}, {100, 100}), (ImageSize{1, 100}));
}

TEST(Sight, HeldKeysTellTheServerOnlyWhatChanged) {
  Sight sight = sight_of(wire::Welcome{});
  EXPECT_FALSE(adjust(sight, {}, 1.0));
  EXPECT_FALSE(adjust(sight, {.time_s = 60}, 0.5)) << "the time is the clock's";
  EXPECT_EQ(turned(100, {.time_s = 60}, 0.5), (ClockChange{130, {}, {}}));
  EXPECT_EQ(turned(10, {.time_s = -60}, 0.5), (ClockChange{0, {}, {}}));
  EXPECT_FALSE(turned(100, {.sun_azimuth_deg = 1}, 0.5));
  const auto settings = adjust(sight, {.sun_elevation_deg = 10}, 0.5);
  ASSERT_TRUE(settings);
  EXPECT_EQ(settings->sun_elevation_deg, 5);
  EXPECT_FALSE(settings->sun_azimuth_deg);
  EXPECT_FALSE(settings->display);
}

TEST(Sight, StaysWithinWhatTheServerTakes) {
  Sight sight;
  for (int i = 0; i < 100; ++i) adjust(sight, {100, 100, 100, -100}, 1.0);
  EXPECT_LE(sight.sun_azimuth_deg, 360);
  EXPECT_EQ(sight.sun_elevation_deg, 90);
  EXPECT_EQ(sight.display.exposure_ev, 20);
}

}  // namespace
}  // namespace cloudscape::viewer
