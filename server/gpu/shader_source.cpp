// Expands includes and keeps the line map; reads from the program or from a folder.
#include "gpu/shader_source.h"

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <utility>

#include "core/embedded.h"
#include "core/error.h"

namespace cloudscape {
extern const EmbeddedFiles embedded_shaders;
}

namespace cloudscape::gpu {
namespace {

namespace fs = std::filesystem;

struct IncludeLine {
  std::string path;       // of #include "path"
  bool cpp_only = false;  // #include <header>, which only C++ can have
};

IncludeLine parse_include(const std::string& line) {
  static const std::regex pattern(R"(^\s*#\s*include\s*(?:"([^"]+)\"|(<)).*)");
  std::smatch match;
  if (!std::regex_match(line, match, pattern)) return {};
  return {match[1].str(), match[2].matched};
}

// Appends files with their includes; `read` gives the text of a file or throws.
template <class Read>
class Expansion {
 public:
  Expansion(ShaderSource& source, Read read) : source_(source), read_(std::move(read)) {}

  void add_text(const std::string& name, const std::string& text) {
    chain_.push_back(name);
    std::istringstream stream(text);
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
      if (!line.empty() && line.back() == '\r') line.pop_back();
      add_line(name, number, line);
    }
    chain_.pop_back();
  }

  void add_file(const std::string& path) {
    if (std::ranges::find(chain_, path) != chain_.end()) throw Error("a shader includes itself: " + chain_to(path));
    if (!done_.insert(path).second) return;
    std::string text;
    if (!read_(path, text))
      throw Error("the shader file '" + path + "' is missing" + (chain_.empty() ? "" : ": " + chain_to(path)));
    add_text(path, text);
  }

 private:
  void add_line(const std::string& name, int number, const std::string& line) {
    const IncludeLine include = parse_include(line);
    if (!include.path.empty()) {
      const std::string path = fs::path(include.path).lexically_normal().generic_string();
      numbers_.push_back(number);
      add_file(path);
      numbers_.pop_back();
      return;
    }
    source_.text += (include.cpp_only ? "" : line) + "\n";
    source_.lines.push_back({name, number});
  }

  std::string chain_to(const std::string& path) const {
    std::string text;
    for (std::size_t i = 0; i < chain_.size(); ++i)
      text += chain_[i] + ":" + std::to_string(numbers_[i]) + " includes ";
    return text + path;
  }

  ShaderSource& source_;
  Read read_;
  std::set<std::string> done_;
  std::vector<std::string> chain_;
  std::vector<int> numbers_;
};

bool read_file(const fs::path& path, std::string& text) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  text = std::move(bytes).str();
  return file.good() && fs::is_regular_file(path);
}

fs::file_time_type newest_in(const fs::path& folder) {
  fs::file_time_type newest = fs::file_time_type::min();  // the epoch of that clock lies ahead, in 2174
  std::error_code ignored;                                // a file may vanish while an editor replaces it
  for (fs::recursive_directory_iterator it(folder, ignored), end; it != end; it.increment(ignored)) {
    const auto time = it->last_write_time(ignored);
    if (!ignored && it->is_regular_file(ignored)) newest = std::max(newest, time);
  }
  return newest;
}

bool inside_root(const std::string& path) { return !path.starts_with("/") && !path.starts_with(".."); }

}  // namespace

std::string ShaderSource::explain(std::string_view driver_log) const {
  // Mesa "0:12(3): error: ...", glslang "ERROR: 0:12: ...", NVIDIA "0(12) : error C1008: ...".
  static const std::regex pattern(R"(^(ERROR: |WARNING: )?\d+(?::(\d+)(?:\(\d+\))?|\((\d+)\) ):(.*)$)");
  std::istringstream stream{std::string(driver_log)};
  std::string explained, line;
  while (std::getline(stream, line)) {
    std::smatch match;
    if (std::regex_match(line, match, pattern) && match[2].length() + match[3].length() < 9) {
      const auto number = static_cast<std::size_t>(std::stoi(match[2].matched ? match[2].str() : match[3].str()));
      if (number >= 1 && number <= lines.size())
        line = match[1].str() + lines[number - 1].file + ":" + std::to_string(lines[number - 1].number) + ":" +
               match[4].str();
    }
    explained += (explained.empty() ? "" : "\n") + line;
  }
  return explained;
}

ShaderLibrary::ShaderLibrary(fs::path folder) : folder_(std::move(folder)) {
  if (folder_.empty()) return;
  if (!fs::is_directory(folder_)) throw InvalidInput("--shader-dir", "is '" + folder_.string() + "': must be a folder");
  newest_ = newest_in(folder_);
}

ShaderSource ShaderLibrary::load(const std::string& path, const std::string& prologue,
                                 const std::string& epilogue) const {
  ShaderSource source;
  Expansion expansion(source, [this](const std::string& file, std::string& text) { return find_text(file, text); });
  expansion.add_text("(version)", "#version 450 core\n");
  expansion.add_text("(prologue)", prologue);
  expansion.add_file(path);
  expansion.add_text("(epilogue)", epilogue);
  return source;
}

std::vector<std::string> ShaderLibrary::paths() const {
  std::vector<std::string> found;
  if (folder_.empty())
    for (const EmbeddedFile& file : embedded_shaders) found.emplace_back(file.path);
  else
    for (const auto& entry : fs::recursive_directory_iterator(folder_))
      if (entry.is_regular_file()) found.push_back(entry.path().lexically_relative(folder_).generic_string());
  std::ranges::sort(found);
  return found;
}

std::string ShaderLibrary::read(const std::string& path) const {
  std::string text;
  if (!find_text(path, text)) throw Error("the shader file '" + path + "' is missing");
  return text;
}

bool ShaderLibrary::changed() {
  if (folder_.empty()) return false;
  const auto newest = newest_in(folder_);
  return std::exchange(newest_, newest) != newest;
}

bool ShaderLibrary::find_text(const std::string& path, std::string& text) const {
  if (!folder_.empty()) return inside_root(path) && read_file(folder_ / path, text);
  const EmbeddedFile* file = find(embedded_shaders, path);
  if (file != nullptr) text = file->bytes;
  return file != nullptr;
}

}  // namespace cloudscape::gpu
