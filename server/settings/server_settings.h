// Settings of `cloudscape serve`: one table of fields serves the config file, the environment, the flags and
// config/server.json. Precedence: flag, then environment (CLOUDSCAPE_LISTEN for `listen`, and so on), then file, then
// default.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/fields.h"
#include "core/frame.h"
#include "settings/sequence_request.h"
#include "settings/still_request.h"

namespace cloudscape::settings {

struct ServerSettings {
  std::string listen = "127.0.0.1:8080";
  std::string cache_dir;  // "": $XDG_CACHE_HOME/cloudscape or ~/.cache/cloudscape
  double cache_limit_mib = 2048;
  std::string cloudscapes_dir;  // "": documents that are put live in memory only
  std::string height_map_dir;   // "": no document can name a height map
  std::string volume_dir;       // "": no document can name a volume's file
  std::string token_file;
  bool insecure = false;
  std::vector<std::string> allowed_origins;
  std::string egl_device = "auto";
  bool require_gpu = false;
  std::string pass_execution = "auto";
  std::string shader_dir;
  std::string log_level = "info";
  int max_connections = 256;
  int max_streams = 32;
  int max_stream_side_px = 3840;
  double max_stream_megapixels = 8.3;
  int max_stream_steps = 25600;
  int still_queue = 16;
  int max_still_side_px = 4096;
  double max_still_megapixels = 9.0;
  double max_still_gigasteps = 1500.0;
  double max_bake_mib = 128.0;  // tuned: a volume of 256^3 in either format, not one of 512^3
  int max_jobs = 4;
  int max_job_frames = 1800;
  double max_job_gigasteps = 100000;
  double job_results_mib = 1024;
  double job_kept_s = 3600;
  std::string jobs_dir;  // "": the system's folder for temporary files
  int max_body_kib = 256;
  double header_timeout_s = 5;
  double body_timeout_s = 5;
  double still_timeout_s = 120;
  double idle_ping_s = 10;
  double idle_hangup_s = 20;
  double drain_s = 10;
  double messages_per_s = 240;
  double target_frame_ms = 33;
  bool operator==(const ServerSettings&) const = default;

  static void fields(auto& self, auto&& visit) {
    visit("listen", self.listen, Limits{3, 260}, "HOST:PORT to listen on; port 0 takes a free one.");
    visit("cache_dir", self.cache_dir, path_lengths,
          "Folder of baked textures; empty: cloudscape in $XDG_CACHE_HOME or ~/.cache.");
    visit("cache_limit_mib", self.cache_limit_mib, Limits{0, 1e6},
          "What baked textures may take on disk, MiB; the longest unused go first.");
    visit("cloudscapes_dir", self.cloudscapes_dir, path_lengths,
          "Folder of *.json documents, read at start, where documents that are put are stored; empty: none.");
    visit("height_map_dir", self.height_map_dir, path_lengths,
          "Folder of the height maps (.png, .exr) that a terrain may name; empty: none.");
    visit("volume_dir", self.volume_dir, path_lengths,
          "Folder of the volumes (.vdb, .raw, .exr) that a document may name; empty: none.");
    visit("token_file", self.token_file, path_lengths,
          "File with the token that clients must send; empty: $CLOUDSCAPE_TOKEN, or one is made beyond loopback.");
    visit("insecure", self.insecure, Limits{}, "Listens beyond loopback without a token.");
    visit("allowed_origins", self.allowed_origins, Limits{0, 64},
          "Origins of foreign web pages that may open streams, such as https://example.org.");
    visit("egl_device", self.egl_device, Limits{1, 4096},
          "What renders: auto, software, an index of `cloudscape devices`, or a path such as /dev/dri/renderD128.");
    visit("require_gpu", self.require_gpu, Limits{}, "Refuses to start on a software renderer.");
    visit("pass_execution", self.pass_execution, Limits{}, "How passes run: auto, compute or fragment.");
    visit("shader_dir", self.shader_dir, path_lengths,
          "Folder to read shaders from, again on each change; empty: those in the program.");
    visit("log_level", self.log_level, Limits{}, "Least level that is logged: debug, info, warn, error or off.");
    visit("max_connections", self.max_connections, Limits{1, 65536}, "Open connections.");
    visit("max_streams", self.max_streams, Limits{1, 4096}, "Viewers at the same time.");
    visit("max_stream_side_px", self.max_stream_side_px, Limits{16, 16384}, "Width or height of a stream, pixels.");
    visit("max_stream_megapixels", self.max_stream_megapixels, Limits{0.01, 256}, "Size of a stream, megapixels.");
    visit("max_stream_steps", self.max_stream_steps, Limits{1, 65535},
          "Steps of a ray of a stream: steps * (1 + light steps); 25600: the quality finest.");
    visit("still_queue", self.still_queue, Limits{1, 4096}, "Stills that wait or render; one more gets 503.");
    visit("max_still_side_px", self.max_still_side_px, Limits{16, 16384}, "Width or height of a still, pixels.");
    visit("max_still_megapixels", self.max_still_megapixels, Limits{0.01, 256}, "Size of a still, megapixels.");
    visit("max_still_gigasteps", self.max_still_gigasteps, Limits{0.001, 1e9},
          "Work of a still: pixels * samples * steps * (1 + light steps) / 1e9.");
    visit(
        "max_bake_mib", self.max_bake_mib, Limits{0.1, 1e5},
        "Baked textures of a cloudscape that is rendered or put, MiB; 128: volumes of 256^3 texels, but not of 512^3.");
    visit("max_jobs", self.max_jobs, Limits{1, 4096}, "Jobs that wait or render; one more gets 503.");
    visit("max_job_frames", self.max_job_frames, Limits{1, 1e6}, "Frames of a job.");
    visit("max_job_gigasteps", self.max_job_gigasteps, Limits{0.001, 1e12},
          "Work of a job: frames * pixels * samples * steps * (1 + light steps) / 1e9.");
    visit("job_results_mib", self.job_results_mib, Limits{1, 1e7}, "What the results of jobs may take on disk, MiB.");
    visit("job_kept_s", self.job_kept_s, Limits{1, 1e7}, "Time that a job and its result are kept after its end, s.");
    visit("jobs_dir", self.jobs_dir, path_lengths,
          "Folder in which a private one is made for the results of jobs; empty: $TMPDIR or /tmp.");
    visit("max_body_kib", self.max_body_kib, Limits{1, 16384}, "Body of an HTTP request, KiB.");
    visit("header_timeout_s", self.header_timeout_s, timeouts_s, "Time that a client has to send its header, s.");
    visit("body_timeout_s", self.body_timeout_s, timeouts_s, "Time that a client has to send the whole body, s.");
    visit("still_timeout_s", self.still_timeout_s, timeouts_s, "Time that a still may take, waiting included, s.");
    visit("idle_ping_s", self.idle_ping_s, timeouts_s, "A stream that is silent so long is asked for life, s.");
    visit("idle_hangup_s", self.idle_hangup_s, timeouts_s,
          "A stream that is silent so long is closed, s; more than idle_ping_s.");
    visit("drain_s", self.drain_s, Limits{0, 3600}, "Time that work has to finish after a signal to stop, s.");
    visit("messages_per_s", self.messages_per_s, Limits{1, 1e5}, "Messages a second that a stream may send.");
    visit("target_frame_ms", self.target_frame_ms, Limits{1, 10000},
          "What a frame of a moving view should take, ms; its detail follows.");
  }

 private:
  static constexpr Limits path_lengths{0, 4096};
  static constexpr Limits timeouts_s{0.1, 3600};
};

using TextMap = std::map<std::string, std::string>;

// `environment` may be the whole one: only CLOUDSCAPE_* matters, and of these not CLOUDSCAPE_TOKEN (the token itself)
// and CLOUDSCAPE_CONFIG (the file's path). Another one that is no setting is logged as a warning. `flags` are keyed by
// the settings' names; lists are separated by commas there and in the environment. Throws InvalidInput that names the
// source: "CLOUDSCAPE_MAX_STREAMS is 0: must be within [1, 4096]", "--max-streams ...", "server.json#/max_streams ...".
ServerSettings load_server_settings(const std::optional<std::filesystem::path>& file, const TextMap& environment,
                                    const TextMap& flags);

// The settings for flags and help texts: names as in the file, so the flag is the name with - for _.
std::vector<ParameterInfo> server_parameters();
std::string flag_name(const std::string& setting);         // --max-streams
std::string environment_name(const std::string& setting);  // CLOUDSCAPE_MAX_STREAMS

StillLimits still_limits(const ServerSettings& settings);
SequenceLimits sequence_limits(const ServerSettings& settings);

}  // namespace cloudscape::settings
