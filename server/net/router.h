// Which handler answers a method and a path; 404 and 405 for the rest.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "net/http_request.h"
#include "net/http_response.h"

namespace cloudscape::net {

// The answer will come later, by this number (still_desk.h).
struct Pending {
  std::uint64_t waiter = 0;
};
using Answer = std::variant<Response, Pending>;
// `name` is what stood in place of {name} in the route.
using Handler = std::function<Answer(const Request&, const std::string& name)>;

struct Route {
  std::string pattern;  // "/api/v1/cloudscapes/{name}"; a {part}, one at most, holds no '/'
  bool open = false;    // needs no token
  std::vector<std::pair<Method, Handler>> methods;

  bool matches(std::string_view path) const;
  std::string name_in(std::string_view path) const;
  const Handler* handler(Method method) const;  // HEAD is answered by GET's where it has none of its own
  std::string allow() const;                    // "GET, HEAD, OPTIONS"
};

class Router {
 public:
  void add(Route route) { routes_.push_back(std::move(route)); }
  const Route* find(std::string_view path) const;
  const std::vector<Route>& routes() const { return routes_; }

 private:
  std::vector<Route> routes_;
};

}  // namespace cloudscape::net
