// Lists the programs that the shader files make, and runs the validator on each.
#include "gpu/shader_check.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <regex>
#include <sstream>

#include "core/error.h"
#include "gpu/pass_wrapper.h"

namespace cloudscape::gpu {
namespace {

namespace fs = std::filesystem;

std::vector<Format> announced_targets(const std::string& path, const std::string& text) {
  const std::string announcement = "// targets: ";
  std::vector<Format> targets;
  if (text.starts_with(announcement)) {
    std::istringstream names(text.substr(announcement.size(), text.find('\n') - announcement.size()));
    for (std::string name; names >> name;) targets.push_back(format_from(name));
  }
  if (targets.empty())
    throw Error(path + ":1: a screen pass must open with its targets, such as '" + announcement + "rgba16f r32f'");
  return targets;
}

ShaderUnit unit(const ShaderLibrary& shaders, const std::string& path, const Wrapper& wrapper, const char* stage) {
  return {path, stage, shaders.load(path, wrapper.prologue, wrapper.epilogue)};
}

// What the command prints if it fails, "" if it succeeds.
std::string failure_of(const std::string& command) {
  std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) throw Error("cannot run " + command);
  std::string output;
  std::array<char, 4096> part{};
  while (const std::size_t size = std::fread(part.data(), 1, part.size(), pipe)) output.append(part.data(), size);
  return pclose(pipe) == 0 ? "" : output + "\n";
}

// The lines that blame the shader; the validator also prints the file's name and how it gave up.
std::string complaints(const std::string& output) {
  std::istringstream lines(output);
  std::string kept;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("ERROR: ") && !std::regex_search(line, std::regex("compilation (errors|terminated)")))
      kept += line + "\n";
  return kept.empty() ? output : kept;
}

std::string check(const ShaderUnit& shader, const std::string& validator, const fs::path& folder) {
  std::string name = shader.name + "." + shader.stage;
  std::ranges::replace(name, '/', '_');
  const fs::path file = folder / name;
  if (!(std::ofstream(file) << shader.source.text)) throw Error("cannot write " + file.string());
  const std::string command = "'" + validator + "' -S " + shader.stage + " '" + file.string() + "'";
  return shader.source.explain(complaints(failure_of(command)));
}

}  // namespace

std::vector<ShaderUnit> shader_units(const ShaderLibrary& shaders) {
  std::vector<ShaderUnit> units;
  for (const std::string& path : shaders.paths()) {
    const std::string text = shaders.read(path);
    if (path.ends_with(".comp")) {
      units.push_back(unit(shaders, path, volume_wrapper(), "comp"));
    } else if (text.find("PassOutput shade(") != std::string::npos) {
      const std::vector<Format> targets = announced_targets(path, text);
      units.push_back(unit(shaders, path, screen_wrapper(PassExecution::compute, targets), "comp"));
      units.push_back(unit(shaders, path, screen_wrapper(PassExecution::fragment, targets), "frag"));
    }
  }
  return units;
}

std::string check_shaders(const ShaderLibrary& shaders, const std::string& validator, const fs::path& folder) {
  fs::create_directories(folder);
  std::string found;
  for (const ShaderUnit& shader : shader_units(shaders)) {
    const std::string wrong = check(shader, validator, folder);
    if (found.find(wrong) == std::string::npos) found += wrong + "\n";
  }
  return found;
}

}  // namespace cloudscape::gpu
