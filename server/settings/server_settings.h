// Settings of `cloudscape serve`: one table of fields serves the config file, the environment, the flags and
// config/server.json. Precedence: flag, then environment (CLOUDSCAPE_LISTEN for `listen`, and so on), then file, then
// default.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "core/fields.h"
#include "core/frame.h"
#include "settings/still_request.h"

namespace cloudscape::settings {

struct ServerSettings {
  std::string listen = "127.0.0.1:8080";
  std::string cache_dir;  // "": $XDG_CACHE_HOME/cloudscape or ~/.cache/cloudscape
  double cache_limit_mib = 2048;
  std::string cloudscapes_dir;  // "": documents that are put live in memory only
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
  int still_queue = 16;
  int max_still_side_px = 4096;
  double max_still_megapixels = 9.0;
  double max_still_gigasteps = 60.0;
  int max_body_kib = 256;
  double header_timeout_s = 5;
  double body_timeout_s = 5;
  double still_timeout_s = 120;
  double idle_ping_s = 10;
  double idle_hangup_s = 20;
  double drain_s = 10;
  double messages_per_s = 240;
  double target_frame_ms = 50;
  bool operator==(const ServerSettings&) const = default;
  // static void fields(...): to be written by the settings' author, each with limits and meaning.
};

}  // namespace cloudscape::settings
