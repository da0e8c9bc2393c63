// What a benchmark ran on.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace cloudscape::bench {

struct Machine {
  std::string renderer, driver, execution;  // GL_RENDERER, GL_VERSION, "compute" or "fragment"
  unsigned cores = 0;                       // that this process may use
};
nlohmann::ordered_json json_of(const Machine& machine);

}  // namespace cloudscape::bench
