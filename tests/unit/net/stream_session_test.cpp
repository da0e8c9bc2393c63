// One viewer's conversation, from its messages to what waits for its socket.
#include "net/stream_session.h"

#include <nlohmann/json.hpp>

#include "site_fixture.h"

namespace cloudscape::net {
namespace {

using Json = nlohmann::json;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr auto hello = R"({"type":"hello","version":1,"cloudscape":"fair-weather-cumulus","size_px":[64,32]})";

class Viewer : public SiteTest {
 protected:
  void make() {
    SiteTest::make();
    session_.emplace(*site_, [this] { ++wakes_; });
  }
  void greet() {
    make();
    say(hello);
    ASSERT_EQ(heard().at("type"), "welcome");
  }
  void say(const std::string& text, bool binary = false) { session_->on_message(text, binary, now_); }
  // The next text that waits for the socket; null where there is none.
  Json heard() {
    auto& texts = session_->outbox().texts;
    if (texts.empty()) return Json::object({{"type", nullptr}});
    const Json message = Json::parse(texts.front());
    texts.pop_front();
    return message;
  }
  int close_code() const {
    const auto& close = const_cast<StreamSession&>(*session_).outbox().close;
    return close ? close->code : 0;
  }
  void expect_error(bool fatal, const std::string& pointer = "") {
    const Json message = heard();
    EXPECT_EQ(message["type"], "error") << message;
    EXPECT_EQ(message.value("fatal", false), fatal) << message;
    EXPECT_EQ(message.value("pointer", ""), pointer) << message;
    EXPECT_EQ(close_code(), fatal ? 1008 : 0) << message;
  }
  // What the render thread and the encoder do.
  std::optional<stream::Work> render() {
    const auto work = scheduler_->take({});
    if (work) scheduler_->rendered(*work, {}), scheduler_->encoded(*work, 1000, 1);
    return work;
  }
  void deliver(const stream::Work& work, std::size_t bytes = 1000) {
    session_->offer(work, {1, 2, 3, 4}, picture(bytes, 16 + wire::frame_header_bytes));
  }

  Instant now_ = Instant{} + seconds(1000);
  int wakes_ = 0;
  std::optional<StreamSession> session_;
};

TEST_F(Viewer, is_welcomed_with_the_view_of_the_document) {
  make();
  say(hello);
  const Json welcome = heard();
  EXPECT_EQ(welcome["type"], "welcome");
  EXPECT_EQ(welcome["cloudscape"], "fair-weather-cumulus");
  EXPECT_EQ(welcome["renderer"], "test renderer");
  EXPECT_EQ(welcome["size_px"], Json({64, 32}));
  const View& view = library_.get("fair-weather-cumulus")->view;
  EXPECT_EQ(welcome["pose"]["position_m"],
            Json({view.pose.position_m.x, view.pose.position_m.y, view.pose.position_m.z}));
  EXPECT_GT(wakes_, 0);
}

TEST_F(Viewer, hello_may_give_a_pose_in_part_and_a_whole_document) {
  make();
  say(R"({"type":"hello","cloudscape":{"view":{"pose":{"azimuth_deg":33,"elevation_deg":44}},"sun":{"azimuth_deg":12}},
          "pose":{"elevation_deg":5}})");
  const Json welcome = heard();
  EXPECT_EQ(welcome["pose"]["azimuth_deg"], 33);
  EXPECT_EQ(welcome["pose"]["elevation_deg"], 5);
  EXPECT_EQ(welcome["sun_azimuth_deg"], 12);
  EXPECT_EQ(welcome["cloudscape"], "");
}

TEST_F(Viewer, march_of_too_many_steps_is_refused_and_the_stream_goes_on) {
  greet();
  say(R"({"type":"settings","march":{"max_steps":16384,"light_steps":1}})");
  const Json message = heard();
  EXPECT_EQ(message["pointer"], "/march");
  EXPECT_EQ(message["fatal"], false);
  EXPECT_EQ(message["message"],
            "/march asks for 16384 * (1 + 1) steps of a ray: a stream has at most 25600 (max_stream_steps); lower "
            "max_steps or light_steps");
  say(R"({"type":"settings","march":{"max_steps":3200,"light_steps":7},"quality":"reference"})");
  EXPECT_EQ(heard()["type"], nullptr) << "as much as the limit";
  say(R"({"type":"settings","march":{"max_steps":16384,"lighting":false}})");
  EXPECT_EQ(heard()["type"], nullptr) << "no light is marched";
}

TEST_F(Viewer, hello_with_a_document_of_too_many_steps_is_refused) {
  make();
  say(R"({"type":"hello","cloudscape":{"view":{"march":{"max_steps":500,"light_steps":128}}}})");
  expect_error(false, "/march");
  say(R"({"type":"hello","cloudscape":{"view":{"march":{"max_steps":500,"light_steps":128}}},"march":{"light_steps":6}})");
  EXPECT_EQ(heard()["type"], "welcome");
}

TEST_F(Viewer, must_say_hello_first_and_once) {
  make();
  say(R"({"type":"camera","pose_sequence":1,"pose":{"azimuth_deg":1}})");
  expect_error(true, "/type");
  greet();
  say(hello);
  expect_error(true);
}

TEST_F(Viewer, may_correct_a_hello_that_was_refused) {
  make();
  say(R"({"type":"hello","cloudscape":"no-such-sky"})");
  expect_error(false);
  say(R"({"type":"hello"})");
  expect_error(false, "/cloudscape");
  say(hello);
  EXPECT_EQ(heard()["type"], "welcome");
}

TEST_F(Viewer, is_closed_when_no_hello_comes) {
  make();
  session_->on_hello_deadline();
  expect_error(true);
  greet();
  session_->on_hello_deadline();
  EXPECT_EQ(close_code(), 0);
}

TEST_F(Viewer, bad_values_are_answered_and_the_stream_goes_on) {
  greet();
  for (const char* azimuth : {"1e999", "null", "\"north\"", "36001"}) {
    say(std::string(R"({"type":"camera","pose_sequence":2,"pose":{"azimuth_deg":)") + azimuth + "}}");
    EXPECT_EQ(heard()["type"], "error") << azimuth;
  }
  EXPECT_EQ(close_code(), 0);
  say(R"({"type":"settings","size_px":[5000,16]})");
  expect_error(false, "/size_px");
  say(R"({"type":"settings","cloudscape":{"volume":{"resolution":512}}})");
  expect_error(false, "/cloudscape/volume/resolution");
  say(R"({"type":"settings","size_px":[3840,3840]})");
  const Json message = heard();
  EXPECT_NE(message["message"].get<std::string>().find("8.3 megapixels"), std::string::npos) << message;
  say(R"({"type":"camera","pose_sequence":3,"pose":{"azimuth_deg":90}})");
  const auto work = render();
  ASSERT_TRUE(work);
  EXPECT_EQ(work->request.pose.azimuth_deg, 90);
  EXPECT_EQ(work->request.size_px, (ImageSize{64, 32}));  // the refused sizes changed nothing
}

TEST_F(Viewer, breaches_of_the_protocol_are_fatal) {
  for (const char* text :
       {"", "not json", "{", "\xff\xfe", R"({"type":"camera","pose_sequence":2,"pose":{"azimuth_deg":NaN}})"}) {
    greet();
    say(text);
    expect_error(true);
  }
  greet();
  say(R"({"type":"ack","frame_id":1,"decode_ms":1})", true);
  expect_error(true);
}

TEST_F(Viewer, many_errors_end_it) {
  greet();
  for (int i = 0; i < 20; ++i) {
    say(R"({"type":"settings","quality":"best"})");
    expect_error(false, "/quality");
  }
  say(R"({"type":"settings","quality":"best"})");
  expect_error(true, "/quality");
}

TEST_F(Viewer, may_send_a_burst_but_no_flood) {
  settings_.messages_per_s = 10;
  greet();
  const std::string ack = R"({"type":"ack","frame_id":1,"decode_ms":1})";
  for (int i = 0; i < 19; ++i) say(ack);  // the hello was the first of twenty
  EXPECT_EQ(close_code(), 0);
  now_ += milliseconds(500);
  for (int i = 0; i < 5; ++i) say(ack);
  EXPECT_EQ(close_code(), 0);
  say(ack);
  expect_error(true);
  EXPECT_EQ(metrics_.value("cloudscape_refused_total{reason=\"flood\"}"), 1);
}

TEST_F(Viewer, too_long_a_message_closes_with_1009) {
  greet();
  session_->on_oversize();
  EXPECT_EQ(heard()["fatal"], true);
  EXPECT_EQ(close_code(), 1009);
}

TEST_F(Viewer, drains_with_1001) {
  greet();
  session_->drain();
  EXPECT_EQ(close_code(), 1001);
  EXPECT_EQ(heard()["type"], nullptr);  // no error: nothing is wrong
}

TEST_F(Viewer, frames_carry_their_header_and_only_the_newest_waits) {
  greet();
  const auto first = render();
  ASSERT_TRUE(first);
  deliver(*first);
  say(R"({"type":"camera","pose_sequence":9,"pose":{"azimuth_deg":45}})");
  const auto second = render();
  ASSERT_TRUE(second);
  deliver(*second, 500);
  EXPECT_EQ(metrics_.value("cloudscape_stream_frames_replaced_total"), 1);
  const OutgoingFrame& waiting = *session_->outbox().frame;
  const auto header = wire::read_frame_header(std::span(waiting.frame.bytes).subspan(waiting.first));
  EXPECT_EQ(header.frame_id, second->frame_id);
  EXPECT_EQ(header.pose_sequence, 9U);
  EXPECT_EQ(header.azimuth_deg, 45);
  EXPECT_EQ(header.image_bytes, 500U);
  EXPECT_EQ(waiting.first, 16U);  // the socket's room stays free
}

TEST_F(Viewer, hears_statistics_only_while_frames_flow) {
  greet();
  session_->on_second(now_);
  EXPECT_EQ(heard()["type"], nullptr);
  deliver(*render());
  const OutgoingFrame sent = *session_->outbox().frame;
  session_->on_sent(sent, now_ += milliseconds(500));
  now_ += milliseconds(40);
  say(R"({"type":"ack","frame_id":)" + std::to_string(sent.frame_id) + R"(,"decode_ms":3})");
  session_->on_second(now_ += milliseconds(460));
  const Json stats = heard();
  EXPECT_EQ(stats["type"], "stats");
  EXPECT_NEAR(stats["frames_per_second"], 1.0, 1e-6);
  EXPECT_NEAR(stats["round_trip_ms"], 40, 1e-6);
  EXPECT_NEAR(stats["bits_per_second"], (1000 + 92) * 8, 1e-6);
  EXPECT_EQ(stats["encode_ms"], 1.5);
  session_->on_second(now_ += seconds(1));
  EXPECT_EQ(heard()["type"], nullptr);
}

TEST_F(Viewer, moves_the_sun_and_puts_it_back) {
  greet();
  const Sun original = library_.get("fair-weather-cumulus")->sun;
  say(R"({"type":"settings","sun_elevation_deg":3})");
  auto work = render();
  EXPECT_EQ(work->request.cloudscape->sun.elevation_deg, 3);
  EXPECT_EQ(work->request.cloudscape->sun.azimuth_deg, original.azimuth_deg);
  deliver(*work);
  say(R"({"type":"ack","frame_id":)" + std::to_string(work->frame_id) + R"(,"decode_ms":1})");
  say(R"({"type":"settings","sun_elevation_deg":null})");
  work = render();
  ASSERT_TRUE(work);
  EXPECT_EQ(work->request.cloudscape->sun, original);
}

TEST_F(Viewer, takes_the_sun_from_its_place_by_turning_it) {
  make();
  library_.put("noon", R"({"sun": {"place": {"time_utc": "2026-06-21T12:00:00Z"}}})");
  say(R"({"type":"hello","version":1,"cloudscape":"noon","size_px":[64,36],"sun_elevation_deg":3})");
  const auto work = render();
  ASSERT_TRUE(work);
  EXPECT_EQ(work->request.cloudscape->sun.elevation_deg, 3);
  EXPECT_EQ(work->request.cloudscape->sun.place.time_utc, "");
}

TEST_F(Viewer, sees_a_document_that_is_put_anew) {
  make();
  library_.put("mine", R"({"seed": 1})");
  say(R"({"type":"hello","cloudscape":"mine"})");
  say(R"({"type":"settings","sun_azimuth_deg":77})");
  Request put = request(Method::put, "/api/v1/cloudscapes/mine");
  put.body = R"({"seed": 2})";
  put.content_length = std::to_string(put.body.size());
  EXPECT_EQ(ask(put).status, 204);
  const auto work = render();
  ASSERT_TRUE(work);
  EXPECT_EQ(work->request.cloudscape->seed, 2U);
  EXPECT_EQ(work->request.cloudscape->sun.azimuth_deg, 77);
}

// What the session last wants to tell of the clock; null where that is nothing.
Json told_of_clock(StreamSession& session) {
  const auto text = std::exchange(session.outbox().clock, std::nullopt);
  return text ? Json::parse(*text) : Json();
}

TEST_F(Viewer, hears_of_the_clock_that_all_of_its_document_share) {
  greet();
  StreamSession other(*site_, [] {}), stranger(*site_, [] {});
  other.on_message(hello, false, now_);
  stranger.on_message(R"({"type":"hello","cloudscape":"overcast"})", false, now_);
  for (StreamSession* each : {&*session_, &other, &stranger})
    EXPECT_EQ(told_of_clock(*each), Json({{"type", "clock"}, {"time_s", 0}, {"rate", 1}, {"paused", true}}));
  other.on_message(R"({"type":"clock","time_s":100,"rate":10,"paused":false})", false, now_);
  const Json running{{"type", "clock"}, {"time_s", 100}, {"rate", 10}, {"paused", false}};
  EXPECT_EQ(told_of_clock(*session_), running);
  EXPECT_EQ(told_of_clock(other), running);
  EXPECT_TRUE(told_of_clock(stranger).is_null()) << "another document has another clock";
  now_ += seconds(3);
  say(R"({"type":"clock","paused":true})");
  EXPECT_EQ(told_of_clock(other)["time_s"], 130);
  const auto work = render();
  ASSERT_TRUE(work);
  EXPECT_EQ(work->request.time_s, 130);
}

TEST_F(Viewer, has_a_time_of_its_own_until_it_follows_the_clock) {
  greet();
  say(R"({"type":"clock","time_s":100})");
  say(R"({"type":"camera","pose_sequence":1,"pose":{"azimuth_deg":1},"time_s":7})");
  say(R"({"type":"settings","sun_azimuth_deg":10})");
  auto work = render();
  ASSERT_TRUE(work);
  EXPECT_EQ(work->request.time_s, 7);
  deliver(*work);
  say(R"({"type":"ack","frame_id":)" + std::to_string(work->frame_id) + R"(,"decode_ms":1})");
  say(R"({"type":"settings","time_s":null})");
  work = render();
  ASSERT_TRUE(work);
  EXPECT_EQ(work->request.time_s, 100);
}

TEST_F(Viewer, clocks_of_their_own_documents_are_their_own) {
  make();
  say(R"({"type":"hello","cloudscape":{"seed":1}})");
  StreamSession other(*site_, [] {});
  other.on_message(R"({"type":"hello","cloudscape":{"seed":1}})", false, now_);
  told_of_clock(other);
  say(R"({"type":"clock","time_s":50})");
  EXPECT_EQ(told_of_clock(*session_)["time_s"], 50);
  EXPECT_TRUE(told_of_clock(other).is_null());
}

TEST_F(Viewer, lets_a_sun_run_only_where_it_has_a_place) {
  greet();
  say(R"({"type":"settings","sun_time_rate":60})");
  expect_error(false, "/sun_time_rate");
  library_.put("morning", R"({"sun": {"place": {"latitude_deg": 47, "time_utc": "2026-06-21T05:00:00Z"}}})");
  say(R"({"type":"settings","cloudscape":"morning","sun_time_rate":60})");
  EXPECT_EQ(heard()["type"], nullptr);
  auto work = render();
  ASSERT_TRUE(work);
  EXPECT_EQ(work->request.cloudscape->sun.place.time_rate, 60);
  deliver(*work);
  say(R"({"type":"ack","frame_id":)" + std::to_string(work->frame_id) + R"(,"decode_ms":1})");
  say(R"({"type":"settings","sun_azimuth_deg":10})");
  work = render();
  ASSERT_TRUE(work);
  EXPECT_EQ(work->request.cloudscape->sun.place.time_rate, 0) << "a sun that is put somewhere stands there";
}

TEST_F(Viewer, closes_its_stream_when_it_goes) {
  greet();
  EXPECT_EQ(metrics_.value("cloudscape_sessions"), 1);
  session_.reset();
  EXPECT_EQ(metrics_.value("cloudscape_sessions"), 0);
  EXPECT_FALSE(scheduler_->take({}));
}

}  // namespace
}  // namespace cloudscape::net
