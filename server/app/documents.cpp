// `cloudscape list`, `schema` and `reference`: what the program knows of cloudscape documents.
#include <cstdio>

#include "app/commands.h"
#include "settings/cloudscape_json.h"
#include "settings/still_documents.h"

namespace cloudscape::app {
namespace {

void print(const std::string& name, const std::string& description) {
  std::printf("%-32s %s\n", name.c_str(), description.c_str());
}

int list(bool stills) {
  if (stills)
    for (const auto& still : settings::named_stills()) print(still.name, still.description);
  else
    for (const auto& entry : settings::CloudscapeLibrary({}).list()) print(entry.name, entry.description);
  return 0;
}

void add_list(CLI::App& program, Run& run) {
  auto stills = std::make_shared<bool>(false);
  CLI::App* command = program.add_subcommand("list", "List the cloudscapes that the program brings");
  command->add_flag("--stills", *stills, "List the stills instead, for `cloudscape still --config NAME`");
  command->callback([stills, &run] { run = [stills] { return list(*stills); }; });
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
  add_list(program, run);
  add("schema", "Print the JSON Schema of cloudscape documents",
      [] { std::puts(settings::cloudscape_schema().c_str()); });
  add("reference", "Print the reference of cloudscape documents as Markdown",
      [] { std::puts(settings::cloudscape_reference().c_str()); });
}

}  // namespace cloudscape::app
