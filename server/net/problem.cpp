#include "net/problem.h"

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/log.h"

namespace cloudscape::net {

Response problem(int status, const std::string& detail, const std::string& pointer) {
  nlohmann::ordered_json body{
      {"type", "about:blank"}, {"title", reason_phrase(status)}, {"status", status}, {"detail", detail}};
  if (!pointer.empty()) body["pointer"] = pointer;
  // What a client sent may be quoted in `detail` and need not be UTF-8.
  std::string text = body.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  return text_response(status, "application/problem+json", std::move(text)).with("cache-control", "no-store");
}

Response busy(int status, const std::string& detail, int retry_after_s) {
  return problem(status, detail).with("retry-after", std::to_string(retry_after_s));
}

Response problem_of(const std::exception& error) {
  if (const auto* over = dynamic_cast<const OverLimit*>(&error)) return problem(422, over->what(), over->pointer);
  if (const auto* invalid = dynamic_cast<const InvalidInput*>(&error))
    return problem(400, invalid->what(), invalid->pointer);
  if (dynamic_cast<const NotFound*>(&error)) return problem(404, error.what());
  log::error("a request failed: {}", error.what());
  if (dynamic_cast<const Error*>(&error)) return problem(500, error.what());
  return problem(500, "The server failed at this request; its log says more.");
}

}  // namespace cloudscape::net
