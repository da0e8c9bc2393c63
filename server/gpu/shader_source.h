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
  // Files of the folder that changed since the last call; always empty for embedded shaders.
  bool changed();

 private:
  std::string read(const std::string& path) const;
  std::filesystem::path folder_;
  std::filesystem::file_time_type newest_{};
};

}  // namespace cloudscape::gpu
