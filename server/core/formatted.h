// Text as printf writes it.
#pragma once
#include <string>

namespace cloudscape {

[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

}  // namespace cloudscape
