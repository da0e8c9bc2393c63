// The first settings of a stream.
#include "viewer/hello.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "core/error.h"
#include "settings/cloudscape_json.h"

namespace cloudscape::viewer {

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file) throw Error("The file " + path + " cannot be read: " + std::strerror(errno) + ".");
  return text;
}

wire::Settings first_settings(const Options& options) {
  wire::Settings first;
  first.size_px = options.size_px;
  first.quality = options.quality;
  const std::string& cloudscape = options.cloudscape;
  if (cloudscape.find('/') != std::string::npos || cloudscape.ends_with(".json"))
    first.cloudscape_document = settings::to_json(settings::parse_cloudscape(read_file(cloudscape), cloudscape));
  else
    first.cloudscape = cloudscape;
  return first;
}

}  // namespace cloudscape::viewer
