// One context for all tests of the program, and a folder of shaders that a test writes itself.
#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "gpu/context.h"

namespace cloudscape::gpu {

class GpuTest : public testing::Test {
 protected:
  static Context& context() {
    static Context shared{ContextOptions{}};
    return shared;
  }
  void SetUp() override { errors_before_ = context().gl_errors(); }
  void TearDown() override {
    context().finish();
    EXPECT_EQ(context().gl_errors(), errors_before_) << "OpenGL reported errors (see the log)";
  }

 private:
  int errors_before_ = 0;
};

// Removed at its end.
class ShaderFolder {
 public:
  ShaderFolder() { std::filesystem::create_directories(path_); }
  ~ShaderFolder() { std::filesystem::remove_all(path_); }
  ShaderFolder(const ShaderFolder&) = delete;
  ShaderFolder& operator=(const ShaderFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  void write(const std::string& file, const std::string& text) const {
    std::filesystem::create_directories((path_ / file).parent_path());
    std::ofstream(path_ / file) << text;
  }

 private:
  static inline int count_ = 0;
  std::filesystem::path path_ = std::filesystem::temp_directory_path() /
                                ("cloudscape-shaders-" + std::to_string(getpid()) + "-" + std::to_string(count_++));
};

template <class Number>
std::vector<Number> as_numbers(const std::vector<std::uint8_t>& bytes) {
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), bytes.size());
  return numbers;
}

}  // namespace cloudscape::gpu
