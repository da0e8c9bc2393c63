// shader_check VALIDATOR SHADERS OUTPUT: the build's check of the folder SHADERS; fails with file:line: message.
#include <iostream>

#include "core/error.h"
#include "gpu/shader_check.h"

int main(int argc, char** argv) try {
  if (argc != 4) throw cloudscape::Error("usage: shader_check VALIDATOR SHADERS OUTPUT");
  const std::string wrong = cloudscape::gpu::check_shaders(cloudscape::gpu::ShaderLibrary(argv[2]), argv[1], argv[3]);
  std::cerr << wrong;
  return wrong.empty() ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
