#include "bench/chosen_names.h"

#include <algorithm>

#include "core/error.h"
#include "settings/json_text.h"

namespace cloudscape::bench {

std::vector<std::string_view> chosen_names(const std::string& option, const std::string& text,
                                           const std::vector<std::string_view>& known) {
  if (text == "all") return known;
  std::vector<bool> chosen(known.size());
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string name = text.substr(begin, end - begin);
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end())
      throw InvalidInput(option, "has " + settings::shown(name) + ": " + settings::suggestion(name, known));
    chosen[found - known.begin()] = true;
    begin = end + 1;
  }
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < known.size(); ++i)
    if (chosen[i]) names.push_back(known[i]);
  return names;
}

}  // namespace cloudscape::bench
