#include "bench/machine.h"

#include <nlohmann/json.hpp>

namespace cloudscape::bench {

nlohmann::ordered_json json_of(const Machine& machine) {
  return {{"renderer", machine.renderer},
          {"driver", machine.driver},
          {"pass_execution", machine.execution},
          {"cores", machine.cores}};
}

}  // namespace cloudscape::bench
