#include "net/router.h"

#include <algorithm>

namespace cloudscape::net {
namespace {

// What stands before and after the pattern's {part}; all before and nothing after where it has none.
std::string_view before_part(std::string_view pattern) { return pattern.substr(0, pattern.find('{')); }
std::string_view after_part(std::string_view pattern) {
  const auto end = pattern.find('}');
  return end == std::string_view::npos ? std::string_view() : pattern.substr(end + 1);
}

// What stands in place of the {part} of a pattern that has one.
std::string_view part_in(std::string_view path, std::string_view pattern) {
  const auto before = before_part(pattern), after = after_part(pattern);
  if (path.size() < before.size() + after.size() || !path.starts_with(before) || !path.ends_with(after)) return {};
  return path.substr(before.size(), path.size() - before.size() - after.size());
}

const Handler* find_method(const Route& route, Method method) {
  const auto found = std::ranges::find(route.methods, method, &std::pair<Method, Handler>::first);
  return found == route.methods.end() ? nullptr : &found->second;
}

}  // namespace

bool Route::matches(std::string_view path) const {
  if (before_part(pattern).size() == pattern.size()) return path == pattern;
  const auto part = part_in(path, pattern);
  return !part.empty() && part.find('/') == std::string_view::npos;
}

std::string Route::name_in(std::string_view path) const { return std::string(part_in(path, pattern)); }

const Handler* Route::handler(Method method) const {
  const Handler* own = find_method(*this, method);
  return own || method != Method::head ? own : find_method(*this, Method::get);
}

std::string Route::allow() const {
  std::string text;
  for (const Method method : {Method::get, Method::head, Method::post, Method::put, Method::del})
    if (handler(method)) text.append(name_of(method)).append(", ");
  return text + "OPTIONS";
}

const Route* Router::find(std::string_view path) const {
  const auto found = std::ranges::find_if(routes_, [&](const Route& route) { return route.matches(path); });
  return found == routes_.end() ? nullptr : &*found;
}

}  // namespace cloudscape::net
