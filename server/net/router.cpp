#include "net/router.h"

#include <algorithm>

namespace cloudscape::net {
namespace {

// The pattern up to its {part}; the whole of it where it has none.
std::string_view fixed_part(std::string_view pattern) { return pattern.substr(0, pattern.find('{')); }

const Handler* find_method(const Route& route, Method method) {
  const auto found = std::ranges::find(route.methods, method, &std::pair<Method, Handler>::first);
  return found == route.methods.end() ? nullptr : &found->second;
}

}  // namespace

bool Route::matches(std::string_view path) const {
  const auto fixed = fixed_part(pattern);
  if (fixed.size() == pattern.size()) return path == pattern;
  if (!path.starts_with(fixed)) return false;
  const auto rest = path.substr(fixed.size());
  return !rest.empty() && rest.find('/') == std::string_view::npos;
}

std::string Route::name_in(std::string_view path) const {
  return std::string(path.substr(std::min(fixed_part(pattern).size(), path.size())));
}

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
