// The comparison with the truth for people and for programs.
#pragma once
#include <string>

#include "bench/machine.h"
#include "bench/truth_results.h"

namespace cloudscape::bench {

std::string truth_tables(const TruthResults& results);
std::string truth_json(const TruthResults& results, const Machine& machine);
// A page that shows the pictures which lie beside it.
std::string truth_html(const TruthResults& results, const Machine& machine);

}  // namespace cloudscape::bench
