// Shader text: embedded in the program or read from a folder, with #include "..." resolved from one root.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cloudscape::gpu {

// A whole shader, includes expanded (each file once), and where each of its lines comes from.
struct ShaderSource {
  struct Line {
    std::string file;
    int number;
  };
  std::string text;
  std::vector<Line> lines;

  // Replaces the line numbers of a driver's log by file:line, Mesa's "0:12(3): error" and NVIDIA's "0(12) : error"
  // alike.
  std::string explain(std::string_view driver_log) const;
};

// Where shaders come from. `folder` empty: those compiled into the program. Throws Error with the chain of includes if
// one is missing or includes itself.
class ShaderLibrary {
 public:
  explicit ShaderLibrary(std::filesystem::path folder = {});
  // The text of `path` ("bake/shape.comp") with its includes; `prologue` goes before it, after the #version line.
  ShaderSource load(const std::string& path, const std::string& prologue = {}, const std::string& epilogue = {}) const;
  std::vector<std::string> paths() const;           // every file, sorted
  std::string read(const std::string& path) const;  // one file as it is; throws Error if it is missing
  // Whether a file of the folder changed since the last call (by the newest time of change); false for embedded
  // shaders.
  bool changed();

 private:
  bool find_text(const std::string& path, std::string& text) const;  // false: there is no such file
  std::filesystem::path folder_;
  std::filesystem::file_time_type newest_{};
};

}  // namespace cloudscape::gpu
