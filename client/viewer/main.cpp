// cloudscape-viewer: flies through a server's sky, in a window or along a path.
#include <cstdio>
#include <exception>

#include "core/log.h"
#include "viewer/cockpit.h"
#include "viewer/options.h"
#include "viewer/recording.h"

int main(int argc, char** argv) {
  using namespace cloudscape;
  try {
    const viewer::Options options = viewer::parse_options(argc, argv);
    log::start(options.log_level);
    options.headless ? viewer::record_flight(options) : viewer::fly_in_window(options);
    return 0;
  } catch (const viewer::Exit& exit) {
    return exit.code;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cloudscape-viewer: %s\n", error.what());
    return 1;
  }
}
