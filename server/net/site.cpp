#include "net/site.h"

#include "net/problem.h"

namespace cloudscape::net {
namespace {

// tuned: a script that walks through a list is not hindered, a loop without pause is.
constexpr double stills_per_s = 50, stills_burst = 200;

constexpr int retry_after_s = 2;  // tuned: a start takes some seconds

}  // namespace

Site::Site(const Parts& given)
    : parts(given),
      endpoint(parse_endpoint(given.settings.listen)),
      authorization(choose_token(given.settings, endpoint), endpoint.loopback, given.settings.allowed_origins),
      stills(given.scheduler, given.metrics),
      jobs(given),
      still_rate(stills_per_s, stills_burst) {}

std::optional<Response> refuse_unready(const Site& site) {
  if (site.draining) return busy(503, "The server is stopping: ask another one, or again later.", retry_after_s);
  if (!site.renderer) return busy(503, "The renderer is still starting: ask again in a moment.", retry_after_s);
  return std::nullopt;
}

}  // namespace cloudscape::net
