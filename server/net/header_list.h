// Comma-separated header values (RFC 9110, 5.6.1).
#pragma once
#include <string_view>
#include <vector>

namespace cloudscape::net {

std::string_view trimmed(std::string_view text);                  // without spaces and tabs at either end
std::vector<std::string_view> split_list(std::string_view list);  // its trimmed members, empty ones left out
bool equal_without_case(std::string_view a, std::string_view b);  // of ASCII letters

}  // namespace cloudscape::net
