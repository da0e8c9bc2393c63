#include "net/request_checks.h"

#include "net/metric_names.h"
#include "net/problem.h"

namespace cloudscape::net {
namespace {

// libwebsockets holds 8 KiB of headers; half for the URI leaves room for the rest.
constexpr std::size_t max_uri_bytes = 4096;

std::size_t uri_bytes(const Request& request) {
  std::size_t bytes = request.path.size();
  for (const auto& [name, value] : request.query) bytes += name.size() + value.size() + 2;
  return bytes;
}

bool takes_body(Method method) { return method == Method::post || method == Method::put; }

// RFC 9112, 6: a length that two readers may understand differently is how requests are smuggled.
std::optional<Response> refuse_framing(const Request& request, std::uint64_t max_body_bytes) {
  const bool measured = !request.content_length.empty();
  if (measured && !request.transfer_encoding.empty())
    return problem(400, "A request has either Content-Length or Transfer-Encoding, not both.");
  if (measured && !content_length(request)) return problem(400, "Content-Length must be one decimal number.");
  if (!takes_body(request.method)) {
    if (has_body(request)) return problem(400, std::string(name_of(request.method)) + " must not have a body.");
    return std::nullopt;
  }
  if (!measured) return problem(411, "Send the body in one piece with Content-Length; chunked bodies are not read.");
  if (*content_length(request) > max_body_bytes)
    return problem(413, "The body has " + request.content_length + " bytes: at most " + std::to_string(max_body_bytes) +
                            " are read (max_body_kib).");
  return std::nullopt;
}

std::optional<Response> find_malformed(const Request& request, std::uint64_t max_body_bytes) {
  if (request.version.empty()) return problem(400, "The request line must end with HTTP/1.1.");
  if (request.version != "HTTP/1.1" && request.version != "HTTP/1.0")
    return problem(505, "This server speaks HTTP/1.1.");
  if (request.host.empty() && request.version == "HTTP/1.1") return problem(400, "The Host header is missing.");
  if (request.host.find(',') != std::string::npos) return problem(400, "There must be one Host header.");
  if (request.path.find('\0') != std::string::npos) return problem(400, "The path must not hold a zero byte.");
  if (uri_bytes(request) > max_uri_bytes)
    return problem(414, "The path and query must have at most " + std::to_string(max_uri_bytes) + " bytes.");
  return refuse_framing(request, max_body_bytes);
}

Response refusal(const Site& site, std::string_view reason, Response response) {
  site.parts.metrics.count(metric::refused(reason));
  return response;
}

bool may_change_something(Method method) { return method != Method::get && method != Method::head; }

}  // namespace

std::optional<Response> refuse_malformed(const Request& request, std::uint64_t max_body_bytes) {
  auto refused = find_malformed(request, max_body_bytes);
  if (refused) refused->close = true;
  return refused;
}

std::optional<Response> refuse_stranger(const Request& request, const Site& site, bool open) {
  if (!site.authorization.accepts_host(request.host))
    return refusal(site, "host",
                   problem(421,
                           "Without a token this server answers to localhost only; add an origin to "
                           "allowed_origins to reach it by another name."));
  if (request.method == Method::options) return std::nullopt;  // a preflight carries no token and changes nothing
  if (may_change_something(request.method) && !site.authorization.accepts_origin(request))
    return refusal(site, "origin", problem(403, "Pages of other sites may not do this; see allowed_origins."));
  if (!open && !site.authorization.accepts(request))
    return refusal(site, "token",
                   problem(401, "This needs the server's token: send it as \"Authorization: Bearer TOKEN\".")
                       .with("www-authenticate", "Bearer"));
  return std::nullopt;
}

}  // namespace cloudscape::net
