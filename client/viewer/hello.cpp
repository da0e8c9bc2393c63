// The first settings of a stream.
#include "viewer/hello.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "core/error.h"

namespace cloudscape::viewer {

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file) throw Error("The file " + path + " cannot be read: " + std::strerror(errno) + ".");
  return text;
}

wire::Settings first_settings(const Options& options) {
  wire::Settings settings;
  settings.size_px = options.size_px;
  settings.quality = options.quality;
  const std::string& cloudscape = options.cloudscape;
  if (cloudscape.find('/') != std::string::npos || cloudscape.ends_with(".json"))
    settings.cloudscape_document = read_file(cloudscape);
  else if (!cloudscape.empty())
    settings.cloudscape = cloudscape;
  return settings;
}

}  // namespace cloudscape::viewer
