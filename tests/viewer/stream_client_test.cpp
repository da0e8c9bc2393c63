// The whole client against a server over a real socket.
#include "viewer/stream_client.h"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "fake_server.h"

namespace cloudscape::viewer {
namespace {

using testing::HasSubstr;

wire::Settings first(const std::string& cloudscape = "overcast") {
  wire::Settings settings;
  settings.cloudscape = cloudscape;
  return settings;
}

wire::Welcome welcome_of(const std::string& renderer) {
  wire::Welcome welcome;
  welcome.renderer = renderer;
  return welcome;
}

template <class T>
const T* as(const wire::ClientMessage& message) {
  return std::get_if<T>(&message);
}

std::size_t acks_in(const std::vector<wire::ClientMessage>& messages) {
  return std::count_if(messages.begin(), messages.end(), [](const auto& message) { return as<wire::Ack>(message); });
}

Time in_seconds(int seconds) { return std::chrono::steady_clock::now() + std::chrono::seconds(seconds); }

std::optional<std::string> wait_for_failure(StreamClient& client) {
  for (int i = 0; i < 1000 && !client.failure(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return client.failure();
}

StreamClient connect(const FakeServer& server, const std::string& token = "") {
  Endpoint endpoint = parse_endpoint(server.url());
  endpoint.token = token;
  return StreamClient(endpoint, first(), 0, [] {});
}

TEST(StreamClient, ShowsAFrameAndThenAcknowledgesIt) {
  FakeServer server([](FakeServer& peer, const wire::ClientMessage& message) {
    if (!as<wire::Hello>(message)) return;
    peer.send(welcome_of("llvmpipe"));
    peer.send_frame(200, 0);
  });
  StreamClient client = connect(server);
  const auto picture = client.take_picture(in_seconds(10));
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->frame.header.frame_id, 200u);
  EXPECT_EQ(picture->bgrx.size(), 32u * 16 * 4);
  EXPECT_NEAR(picture->bgrx[5], 200, 2);
  EXPECT_EQ(client.status().welcome->renderer, "llvmpipe");
  EXPECT_TRUE(server.received<wire::Ack>().empty()) << "not before it is on display";
  client.displayed(*picture);
  ASSERT_TRUE(server.wait([](const auto& messages) { return acks_in(messages) == 1; }));
  const wire::Ack ack = server.received<wire::Ack>()[0];
  EXPECT_EQ(ack.frame_id, 200u);
  EXPECT_GT(ack.decode_ms, 0);
}

TEST(StreamClient, DropsTheOlderFramesButAcknowledgesEachOnce) {
  constexpr int sent = 20;
  FakeServer server([](FakeServer& peer, const wire::ClientMessage& message) {
    if (!as<wire::Hello>(message)) return;
    peer.send(wire::Welcome{});
    for (int id = 1; id <= sent; ++id) peer.send_frame(id, 0, {320, 180});
  });
  StreamClient client = connect(server);
  // Nobody takes a picture: at most one stays decoded, the newest waits, and the others are given up.
  ASSERT_TRUE(server.wait([](const auto& messages) { return acks_in(messages) >= sent - 2; }));
  std::vector<std::uint32_t> shown;
  while (shown.empty() || shown.back() != sent) {
    const auto picture = client.take_picture(in_seconds(10));
    ASSERT_TRUE(picture) << "the newest is never dropped";
    shown.push_back(picture->frame.header.frame_id);
    client.displayed(*picture);
  }
  EXPECT_LE(shown.size(), 2u);
  ASSERT_TRUE(server.wait([](const auto& messages) { return acks_in(messages) == sent; }));
  std::vector<std::uint32_t> ids;
  for (const wire::Ack& ack : server.received<wire::Ack>()) ids.push_back(ack.frame_id);
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(std::unique(ids.begin(), ids.end()), ids.end());
  EXPECT_EQ(client.status().frames_skipped, sent - shown.size());
}

TEST(StreamClient, ComesBackWithTheSameView) {
  FakeServer server([connections = 0](FakeServer& peer, const wire::ClientMessage& message) mutable {
    if (as<wire::Hello>(message) && ++connections) return peer.send(wire::Welcome{});
    if (!as<wire::Camera>(message)) return;
    if (connections == 1)
      peer.hang_up();
    else
      peer.send_frame(1, as<wire::Camera>(message)->pose_sequence);
  });
  StreamClient client = connect(server);
  CameraPose pose;
  pose.position_m = {1, 2, 3000};
  const std::uint64_t sequence = client.look(pose, 12.5);
  const auto picture = client.take_picture(in_seconds(10));
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->frame.header.pose_sequence, sequence);
  EXPECT_EQ(client.status().connections, 2u);
  const auto hellos = server.received<wire::Hello>();
  ASSERT_EQ(hellos.size(), 2u);
  EXPECT_EQ(hellos[1].settings.cloudscape, "overcast");
  EXPECT_EQ(hellos[1].settings.pose, pose);
  EXPECT_EQ(hellos[1].settings.time_s, 12.5);
}

TEST(StreamClient, AnErrorInsteadOfAWelcomeIsARefusal) {
  FakeServer server([](FakeServer& peer, const wire::ClientMessage&) {
    peer.send(wire::ErrorMessage{"There is no cloudscape 'overcast'.", "/cloudscape", false});
  });
  StreamClient client = connect(server);
  EXPECT_THAT(wait_for_failure(client).value_or(""), HasSubstr("There is no cloudscape 'overcast'."));
}

TEST(StreamClient, AComplaintAfterTheWelcomeIsANotice) {
  FakeServer server([](FakeServer& peer, const wire::ClientMessage& message) {
    if (as<wire::Hello>(message)) peer.send(wire::Welcome{});
    if (as<wire::Hello>(message)) peer.send(wire::ErrorMessage{"/size_px is too large", "/size_px", false});
  });
  StreamClient client = connect(server);
  for (int i = 0; i < 1000 && client.status().notice.empty(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(client.status().notice, "/size_px is too large");
  EXPECT_FALSE(client.failure());
}

TEST(StreamClient, ADamagedFrameIsCountedAndTheNextOneShown) {
  FakeServer server([](FakeServer& peer, const wire::ClientMessage& message) {
    if (as<wire::Hello>(message)) {
      peer.send(wire::Welcome{});
      peer.send_frame(1, 0, {64, 64}, true);
    } else if (as<wire::Ack>(message) && as<wire::Ack>(message)->frame_id == 1) {
      peer.send_frame(2, 0);
    }
  });
  StreamClient client = connect(server);
  const auto picture = client.take_picture(in_seconds(10));
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->frame.header.frame_id, 2u);
  EXPECT_EQ(client.status().frames_broken, 1u);
}

TEST(StreamClient, ATokenOpensTheDoorAndItsLackSaysSo) {
  FakeServer server(
      [](FakeServer& peer, const wire::ClientMessage& message) {
        if (as<wire::Hello>(message)) peer.send(wire::Welcome{}), peer.send_frame(1, 0);
      },
      "s3cret");
  StreamClient welcome = connect(server, "s3cret");
  EXPECT_TRUE(welcome.take_picture(in_seconds(10)));
  StreamClient stranger = connect(server, "guess");
  EXPECT_THAT(wait_for_failure(stranger).value_or(""), HasSubstr("--token"));
}

// The program, as a person or a script runs it.
int run_viewer(const std::string& arguments) {
  const int status = std::system((std::string(VIEWER_PROGRAM) + " " + arguments + " >/dev/null 2>&1").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Program, TellsUsageErrorsFromFailures) {
  EXPECT_EQ(run_viewer("--help"), 0);
  EXPECT_EQ(run_viewer(""), 2);
  EXPECT_EQ(run_viewer("nonsense"), 2);
  EXPECT_EQ(run_viewer("ws://127.0.0.1:1 --size 12"), 2);
  EXPECT_EQ(run_viewer("ws://127.0.0.1:1 --quality best"), 2);
  EXPECT_EQ(run_viewer("ws://127.0.0.1:1 --headless"), 2);
  EXPECT_EQ(run_viewer("ws://127.0.0.1:1 --headless --frames 1 --out /tmp --path /no/such/file"), 1);
}

TEST(Program, RecordsAFlightWithoutADisplay) {
  FakeServer server([id = 0u](FakeServer& peer, const wire::ClientMessage& message) mutable {
    if (as<wire::Hello>(message)) peer.send(welcome_of("fake")), peer.send_frame(++id, 0);
    if (const auto* camera = as<wire::Camera>(message)) peer.send_frame(++id, camera->pose_sequence);
  });
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / ("flight_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "path.json") << R"({"keys": [{"time_s": 0, "pose": {"position_m": [0, 0, 500]}},
                                            {"time_s": 1, "pose": {"position_m": [0, 300, 500]}}]})";
  ASSERT_EQ(run_viewer(server.url() + " --headless --frames 6 --fps 10 --path " + (folder / "path.json").string() +
                       " --out " + (folder / "out").string()),
            0);
  const auto report = nlohmann::json::parse(std::ifstream(folder / "out" / "report.json"));
  EXPECT_EQ(report["frames"], 6);
  EXPECT_EQ(report["latency_ms"]["count"], 6);
  EXPECT_GT(report["fps"], 0);
  EXPECT_EQ(report["renderer"], "fake");
  EXPECT_GT(std::filesystem::file_size(folder / "out" / "frame_0001.jpg"), 100u);
  EXPECT_TRUE(std::filesystem::exists(folder / "out" / "frame_0006.jpg"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out" / "frame_0007.jpg"));
  const auto cameras = server.received<wire::Camera>();
  ASSERT_EQ(cameras.size(), 6u);
  EXPECT_NEAR(cameras[5].time_s.value_or(-1), 0.5, 1e-9) << "pose n is n / fps along the path";
  EXPECT_NEAR(cameras[0].pose.position_m.y, 0, 1e-9);
  EXPECT_GT(cameras[5].pose.position_m.y, cameras[4].pose.position_m.y);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace cloudscape::viewer
