// The program `cloudscape`. Exit codes: 0 done, 1 failed, 2 wrong usage.
#include <cstdio>
#include <exception>

#include "app/commands.h"
#include "core/error.h"
#include "core/version.h"

int main(int argc, char** argv) {
  CLI::App program("Renders volumetric cloudscapes and streams them to viewers.", "cloudscape");
  program.set_version_flag("--version", std::string("cloudscape ") + cloudscape::version);
  program.require_subcommand(1);
  program.get_formatter()->column_width(34);
  cloudscape::app::Run run;
  for (const auto& add : {cloudscape::app::add_serve, cloudscape::app::add_still, cloudscape::app::add_bake,
                          cloudscape::app::add_bench, cloudscape::app::add_mie, cloudscape::app::add_devices,
                          cloudscape::app::add_documents, cloudscape::app::add_healthcheck})
    add(program, run);
  try {
    program.parse(argc, argv);
    return run();
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  } catch (const cloudscape::InvalidInput& error) {
    std::fprintf(stderr, "cloudscape: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cloudscape: %s\n", error.what());
    return 1;
  }
}
