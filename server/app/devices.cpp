// `cloudscape devices`: what could render here.
#include <cstdio>

#include "app/commands.h"
#include "gpu/context.h"

namespace cloudscape::app {

void add_devices(CLI::App& program, Run& run) {
  program.add_subcommand("devices", "List the EGL devices and what is wrong with those that do not work")
      ->callback([&run] {
        run = [] {
          std::printf("%s", gpu::describe(gpu::enumerate_devices()).c_str());
          return 0;
        };
      });
}

}  // namespace cloudscape::app
