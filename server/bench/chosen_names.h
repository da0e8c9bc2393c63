// Options that take all of a set, or some of it by name.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace cloudscape::bench {

// "all" or names with commas, each once, in the order of `known`. Throws InvalidInput that begins with `option` and
// names the nearest: "--models has 'beer': did you mean beer-powder?".
std::vector<std::string_view> chosen_names(const std::string& option, const std::string& text,
                                           const std::vector<std::string_view>& known);

}  // namespace cloudscape::bench
