// `cloudscape list`, `schema` and `reference`: what the program knows of cloudscape documents.
#include <cstdio>

#include "app/commands.h"
#include "settings/cloudscape_json.h"

namespace cloudscape::app {
namespace {

void list() {
  for (const auto& entry : settings::CloudscapeLibrary({}).list())
    std::printf("%-24s %s\n", entry.name.c_str(), entry.description.c_str());
}

}  // namespace

void add_documents(CLI::App& program, Run& run) {
  const auto add = [&](const char* name, const char* about, void (*print)()) {
    program.add_subcommand(name, about)->callback([&run, print] {
      run = [print] {
        print();
        return 0;
      };
    });
  };
  add("list", "List the cloudscapes that the program brings", list);
  add("schema", "Print the JSON Schema of cloudscape documents",
      [] { std::puts(settings::cloudscape_schema().c_str()); });
  add("reference", "Print the reference of cloudscape documents as Markdown",
      [] { std::puts(settings::cloudscape_reference().c_str()); });
}

}  // namespace cloudscape::app
