// A site with a real scheduler and library, without sockets.
#pragma once
#include <gtest/gtest.h>

#include "net/front_door.h"
#include "net/routes.h"
#include "net/site.h"

namespace cloudscape::net {

class SiteTest : public testing::Test {
 protected:
  SiteTest() { settings_.listen = "127.0.0.1:0"; }

  // Call once, after changing settings_.
  void make(bool ready = true) {
    scheduler_.emplace(stream::SchedulerOptions{50, static_cast<std::size_t>(settings_.still_queue)}, metrics_);
    site_.emplace(Parts{settings_, *scheduler_, library_, metrics_, page_});
    if (ready) site_->renderer = RendererInfo{"test renderer", "test", "4.5", "fragment", true};
    router_.emplace(make_router(*site_));
  }
  static Request request(Method method, std::string path) {
    Request request;
    request.method = method;
    request.path = std::move(path);
    request.version = "HTTP/1.1";
    request.host = "localhost:8080";
    request.client = "127.0.0.1";
    return request;
  }
  Response ask(const Request& request) {
    const Answer given = answer(*site_, *router_, request);
    EXPECT_TRUE(std::holds_alternative<Response>(given)) << request.path;
    return std::holds_alternative<Response>(given) ? std::get<Response>(given) : empty_response(0);
  }
  Response get(std::string path) { return ask(request(Method::get, std::move(path))); }
  static std::string header(const Response& response, std::string_view name) {
    for (const auto& [key, value] : response.headers)
      if (key == name) return value;
    return "";
  }
  static EncodedFrame picture(std::size_t bytes, std::size_t front = 0) {
    return {std::vector<std::uint8_t>(front + bytes, 7), front, ImageFormat::jpeg, 1.5};
  }

  const std::vector<EmbeddedFile> page_{{"index.html", "<!doctype html>"}, {"app.js", "export {};"}};
  settings::ServerSettings settings_;
  Metrics metrics_;
  settings::CloudscapeLibrary library_{""};
  std::optional<stream::FrameScheduler> scheduler_;
  std::optional<Site> site_;
  std::optional<Router> router_;
};

}  // namespace cloudscape::net
