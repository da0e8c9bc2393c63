// Settings of the server: precedence, sources in errors, and config/server.json held to the struct.
#include "settings/server_settings.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "settings/described_json.h"
#include "settings/text_file.h"
#include "tests/unit/settings/refusal.h"

namespace cloudscape::settings {
namespace {

using testing::HasSubstr;

const std::filesystem::path annotated = CLOUDSCAPE_SOURCE_DIR "/config/server.json";

class ConfigFile {
 public:
  explicit ConfigFile(const std::string& text)
      : path_(std::filesystem::temp_directory_path() / ("cloudscape-config-" + std::to_string(::getpid()) + ".json")) {
    std::ofstream(path_) << text;
  }
  ~ConfigFile() { std::filesystem::remove(path_); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

TEST(ServerSettings, TheAnnotatedFileHasEveryKeyWithItsDefault) {
  EXPECT_EQ(load_server_settings(annotated, {}, {}), ServerSettings{});
  const auto json = parse_json(read_text_file(annotated, 1 << 20), "server.json");
  for (const std::string_view name : field_names<ServerSettings>()) EXPECT_TRUE(json.contains(name)) << name;
}

TEST(ServerSettings, TheAnnotatedFileSaysWhatEachKeyMeans) {
  const std::string text = read_text_file(annotated, 1 << 20);
  for (const ParameterInfo& setting : server_parameters())
    EXPECT_THAT(text, HasSubstr("  // " + setting.description + "\n  \"" + setting.name + "\":"));
}

TEST(ServerSettings, FlagsGoBeforeEnvironmentBeforeFileBeforeDefaults) {
  const ConfigFile file(R"({"max_streams": 1, "still_queue": 1, "drain_s": 1})");
  const TextMap environment{{"CLOUDSCAPE_MAX_STREAMS", "2"}, {"CLOUDSCAPE_STILL_QUEUE", "2"}};
  const TextMap flags{{"max_streams", "3"}};
  const ServerSettings settings = load_server_settings(file.path(), environment, flags);
  EXPECT_EQ(settings.max_streams, 3);
  EXPECT_EQ(settings.still_queue, 2);
  EXPECT_EQ(settings.drain_s, 1);
  EXPECT_EQ(settings.max_connections, ServerSettings{}.max_connections);
}

TEST(ServerSettings, TextsBecomeEveryType) {
  const ServerSettings settings =
      load_server_settings({}, {{"CLOUDSCAPE_ALLOWED_ORIGINS", "https://a.example, https://b.example"}},
                           {{"insecure", "true"},
                            {"require_gpu", "0"},
                            {"listen", "[::1]:0"},
                            {"target_frame_ms", "33.3"},
                            {"pass_execution", "compute"}});
  EXPECT_EQ(settings.allowed_origins, (std::vector<std::string>{"https://a.example", "https://b.example"}));
  EXPECT_TRUE(settings.insecure);
  EXPECT_FALSE(settings.require_gpu);
  EXPECT_EQ(settings.listen, "[::1]:0");
  EXPECT_EQ(settings.target_frame_ms, 33.3);
  EXPECT_EQ(load_server_settings({}, {{"CLOUDSCAPE_ALLOWED_ORIGINS", ""}}, {}).allowed_origins.size(), 0u);
}

TEST(ServerSettings, ErrorsNameTheirSource) {
  const auto from_environment = [](const std::string& name, const std::string& text) {
    return refusal([&] { load_server_settings({}, {{name, text}}, {}); }).sentence;
  };
  const auto from_flag = [](const std::string& name, const std::string& text) {
    return refusal([&] { load_server_settings({}, {}, {{name, text}}); }).sentence;
  };
  EXPECT_EQ(from_environment("CLOUDSCAPE_MAX_STREAMS", "0"), "CLOUDSCAPE_MAX_STREAMS is 0: must be within [1, 4096]");
  EXPECT_EQ(from_environment("CLOUDSCAPE_INSECURE", "yes"), R"(CLOUDSCAPE_INSECURE is "yes": must be true or false)");
  EXPECT_EQ(from_flag("max_streams", "many"), R"(--max-streams is "many": must be a whole number)");
  EXPECT_EQ(from_flag("pass_execution", "gpu"), R"(--pass-execution is "gpu": must be one of auto, compute, fragment)");
  EXPECT_EQ(from_flag("max_stream", "1"), "--max-stream is not a setting: did you mean max_streams?");
  for (const char* listen : {"localhost", ":80", "1.2.3.4:", "1.2.3.4:65536", "1.2.3.4:http"})
    EXPECT_EQ(from_flag("listen", listen),
              "--listen is \"" + std::string(listen) + "\": must be HOST:PORT, such as 127.0.0.1:8080 or [::1]:8080");
  const ConfigFile file(R"({"log_level": "loud"})");
  EXPECT_EQ(refusal([&] { load_server_settings(file.path(), {}, {}); }).sentence,
            file.path().string() + "#/log_level is \"loud\": must be one of debug, info, warn, error, off");
  const ConfigFile unknown(R"({"port": 1})");
  EXPECT_THAT(refusal([&] { load_server_settings(unknown.path(), {}, {}); }).sentence,
              HasSubstr("#/port is not a known key"));
}

TEST(ServerSettings, TimesThatContradictAreRefusedAfterAllSources) {
  EXPECT_EQ(refusal([] {
              load_server_settings({}, {}, {{"idle_ping_s", "20"}});
            }).sentence,
            "idle_hangup_s is 20: must be more than idle_ping_s, 20");
  EXPECT_NO_THROW(load_server_settings({}, {{"CLOUDSCAPE_IDLE_PING_S", "30"}}, {{"idle_hangup_s", "60"}}));
}

TEST(ServerSettings, OtherVariablesChangeNothing) {
  const TextMap environment{{"CLOUDSCAPE_TOKEN", "secret"},
                            {"CLOUDSCAPE_CONFIG", "x.json"},
                            {"CLOUDSCAPE_MAX_STREAM", "0"},
                            {"CLOUDSCAPE_max_streams", "0"},
                            {"HOME", "/root"},
                            {"listen", "nowhere"}};
  EXPECT_EQ(load_server_settings({}, environment, {}), ServerSettings{});
}

TEST(ServerSettings, AMissingFileIsOneSentence) {
  EXPECT_THAT(refusal<Error>([] { load_server_settings("/nowhere/server.json", {}, {}); }).sentence,
              HasSubstr("cannot read /nowhere/server.json"));
}

TEST(ServerSettings, DescribeThemselvesForFlags) {
  std::map<std::string, ParameterInfo> parameters;
  for (const ParameterInfo& parameter : server_parameters()) parameters[parameter.name] = parameter;
  EXPECT_EQ(parameters.size(), field_names<ServerSettings>().size());
  EXPECT_EQ(parameters["listen"].default_text, "127.0.0.1:8080");
  EXPECT_EQ(parameters["insecure"].type, "boolean");
  EXPECT_EQ(parameters["log_level"].values.size(), 5u);
  EXPECT_EQ(parameters["max_streams"].max, 4096);
  EXPECT_EQ(parameters["allowed_origins"].type, "string");
  EXPECT_EQ(flag_name("max_streams"), "--max-streams");
  EXPECT_EQ(environment_name("max_streams"), "CLOUDSCAPE_MAX_STREAMS");
}

// Whatever default a setting shows, its own reader takes it back.
TEST(ServerSettings, DefaultsSurviveTheirText) {
  TextMap flags;
  for (const ParameterInfo& parameter : server_parameters()) flags[parameter.name] = parameter.default_text;
  EXPECT_EQ(load_server_settings({}, {}, flags), ServerSettings{});
}

}  // namespace
}  // namespace cloudscape::settings
