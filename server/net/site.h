// What the routes and the sessions of one server share. Used on the network thread only.
#pragma once
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "net/authorization.h"
#include "net/endpoint.h"
#include "net/jobs.h"
#include "net/limits.h"
#include "net/server.h"
#include "net/still_desk.h"
#include "stream/shared_clock.h"

namespace cloudscape::net {

class StreamSession;

struct Site {
  explicit Site(const Parts& given);

  Parts parts;
  Endpoint endpoint;
  Authorization authorization;
  StillDesk stills;
  Jobs jobs;
  RateLimit still_rate;
  std::optional<RendererInfo> renderer;  // nullopt: still starting
  bool draining = false;
  std::set<StreamSession*> sessions;
  std::map<std::string, stream::SharedClock> clocks;  // of the documents that are, or were, looked at, by name

  bool ready() const { return renderer && !draining; }
};

// 503 while starting or draining, else nothing.
std::optional<Response> refuse_unready(const Site& site);

}  // namespace cloudscape::net
