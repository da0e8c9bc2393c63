// The subcommands of `cloudscape`; each adds itself to the command line and says what to run.
#pragma once
#include <CLI/CLI.hpp>
#include <functional>

namespace cloudscape::app {

// Set by the subcommand that was named; the exit code of the program.
using Run = std::function<int()>;

void add_serve(CLI::App& program, Run& run);
void add_still(CLI::App& program, Run& run);
void add_bake(CLI::App& program, Run& run);
void add_bench(CLI::App& program, Run& run);
void add_mie(CLI::App& program, Run& run);
void add_devices(CLI::App& program, Run& run);
void add_documents(CLI::App& program, Run& run);    // list, schema, reference
void add_healthcheck(CLI::App& program, Run& run);  // asks a running server

}  // namespace cloudscape::app
