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
  GpuTest() {
    if (!shared_) shared_ = std::make_unique<Context>(ContextOptions{});
    errors_before_ = shared_->gl_errors();
  }
  static const Context& context() { return *shared_; }
  void TearDown() override {
    shared_->finish();
    EXPECT_EQ(shared_->gl_errors(), errors_before_) << "OpenGL reported errors (see the log)";
  }

 private:
  friend class OwnContextTest;
  friend class EndOfContext;
  static inline std::unique_ptr<Context> shared_;
  int errors_before_ = 0;
};

// A driver may be gone before what is static is destroyed.
class EndOfContext : public testing::Environment {
 public:
  void TearDown() override { GpuTest::shared_.reset(); }
};
inline testing::Environment* const end_of_context = testing::AddGlobalTestEnvironment(new EndOfContext);

// For tests that make a context themselves: a thread has one at a time.
class OwnContextTest : public testing::Test {
 protected:
  OwnContextTest() { GpuTest::shared_.reset(); }
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
