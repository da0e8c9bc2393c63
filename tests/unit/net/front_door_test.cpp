// The routes as a client sees them, from request to answer.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "net/handshake.h"
#include "site_fixture.h"

namespace cloudscape::net {
namespace {

using Json = nlohmann::json;

class FrontDoor : public SiteTest {
 protected:
  static Json json(const Response& response) { return Json::parse(response.body.bytes); }
  Request stills(settings::Parameters query) {
    Request asked = request(Method::get, "/api/v1/stills");
    asked.query = std::move(query);
    return asked;
  }
  Request with_body(Method method, std::string path, std::string body) {
    Request asked = request(method, std::move(path));
    asked.content_length = std::to_string(body.size());
    asked.body = std::move(body);
    return asked;
  }
};

TEST_F(FrontDoor, unknown_paths_and_methods) {
  make();
  EXPECT_EQ(get("/nothing").status, 404);
  EXPECT_EQ(get("/api/v1/stills/").status, 404);
  const Response wrong = ask(request(Method::del, "/api/v1/cloudscapes"));
  EXPECT_EQ(wrong.status, 405);
  EXPECT_EQ(header(wrong, "allow"), "GET, HEAD, OPTIONS");
  EXPECT_EQ(ask(request(Method::other, "/")).status, 405);
  const Response options = ask(request(Method::options, "/api/v1/stills"));
  EXPECT_EQ(options.status, 204);
  EXPECT_EQ(header(options, "allow"), "GET, HEAD, POST, OPTIONS");
}

TEST_F(FrontDoor, page_files_have_types_and_etags) {
  make();
  const Response index = get("/"), script = get("/app.js");
  EXPECT_EQ(index.body.bytes, "<!doctype html>");
  EXPECT_EQ(index.content_type, "text/html; charset=utf-8");
  EXPECT_EQ(script.content_type, "text/javascript; charset=utf-8");
  Request again = request(Method::get, "/app.js");
  again.if_none_match = header(script, "etag");
  EXPECT_EQ(ask(again).status, 304);
  EXPECT_EQ(ask(again).body.bytes, "");
  again.if_none_match = header(index, "etag");
  EXPECT_EQ(ask(again).status, 200);
}

TEST_F(FrontDoor, readiness_follows_the_renderer_and_the_drain) {
  make(false);
  EXPECT_EQ(get("/healthz").status, 200);
  const Response starting = get("/readyz");
  EXPECT_EQ(starting.status, 503);
  EXPECT_EQ(json(starting)["ready"], false);
  EXPECT_EQ(ask(stills({{"cloudscape", "fair-weather-cumulus"}})).status, 503);
  site_->renderer = RendererInfo{"llvmpipe", "Mesa", "4.5", "fragment", true};
  EXPECT_EQ(get("/readyz").status, 200);
  EXPECT_EQ(json(get("/readyz"))["renderer"], "llvmpipe");
  EXPECT_EQ(json(get("/readyz"))["software"], true);
  site_->draining = true;
  EXPECT_EQ(get("/readyz").status, 503);
  EXPECT_EQ(json(get("/readyz"))["reason"], "stopping");
}

TEST_F(FrontDoor, a_foreign_page_may_not_change_anything) {
  settings_.allowed_origins = {"https://friend.test"};
  make();
  Request put = with_body(Method::put, "/api/v1/cloudscapes/mine", "{}");
  put.origin = "http://evil.example";
  EXPECT_EQ(ask(put).status, 403);
  put.origin = "https://friend.test";
  EXPECT_EQ(ask(put).status, 201);
  const Response cors = finished(*site_, *router_, put, empty_response(204));
  EXPECT_EQ(header(cors, "access-control-allow-origin"), "https://friend.test");
  put.origin = "http://evil.example";
  EXPECT_EQ(header(finished(*site_, *router_, put, empty_response(204)), "access-control-allow-origin"), "");
}

TEST_F(FrontDoor, a_token_guards_all_but_page_and_health) {
  const std::string file = testing::TempDir() + "front_door_token_" + std::to_string(getpid());
  std::ofstream(file) << "0123456789abcdef";
  settings_.token_file = file;
  make();
  for (const char* open : {"/", "/app.js", "/healthz", "/readyz"}) EXPECT_EQ(get(open).status, 200) << open;
  for (const char* closed : {"/metrics", "/api/v1/cloudscapes", "/api/v1/openapi.json", "/api/v1/stills"}) {
    const Response refused = get(closed);
    EXPECT_EQ(refused.status, 401) << closed;
    EXPECT_EQ(header(refused, "www-authenticate"), "Bearer");
  }
  Request asked = request(Method::get, "/metrics");
  asked.authorization = "Bearer 0123456789abcdef";
  EXPECT_EQ(ask(asked).status, 200);
  std::filesystem::remove(file);
}

TEST_F(FrontDoor, malformed_framing_is_refused_and_closes) {
  make();
  const auto post = [&](auto change) {
    Request asked = with_body(Method::post, "/api/v1/stills", "{}");
    change(asked);
    const Response response = ask(asked);
    EXPECT_TRUE(response.close) << response.status;
    return response.status;
  };
  EXPECT_EQ(post([](Request& r) { r.content_length = ""; }), 411);
  EXPECT_EQ(post([](Request& r) { r.content_length = "", r.transfer_encoding = "chunked"; }), 411);
  EXPECT_EQ(post([](Request& r) { r.transfer_encoding = "chunked"; }), 400);
  EXPECT_EQ(post([](Request& r) { r.content_length = "2,2"; }), 400);
  EXPECT_EQ(post([](Request& r) { r.content_length = "262145"; }), 413);
  EXPECT_EQ(post([](Request& r) { r.version = "HTTP/2.0"; }), 505);
  EXPECT_EQ(post([](Request& r) { r.version = ""; }), 400);
  EXPECT_EQ(post([](Request& r) { r.host = ""; }), 400);
  EXPECT_EQ(post([](Request& r) { r.host = "localhost,localhost"; }), 400);
  EXPECT_EQ(post([](Request& r) { r.path = std::string("/\0x", 3); }), 400);
  EXPECT_EQ(post([](Request& r) { r.path = "/" + std::string(5000, 'a'); }), 414);
  EXPECT_EQ(post([](Request& r) { r.method = Method::get; }), 400);  // GET with a body
}

TEST_F(FrontDoor, stills_name_the_wrong_value) {
  make();
  const Response response = ask(stills({{"cloudscape", "fair-weather-cumulus"}, {"width", "0"}}));
  EXPECT_EQ(response.status, 400);
  EXPECT_EQ(json(response)["pointer"], "/width");
  EXPECT_EQ(ask(stills({})).status, 400);
  EXPECT_EQ(ask(stills({{"cloudscape", "no-such-sky"}})).status, 404);
  EXPECT_EQ(ask(stills({{"cloudscape", "fair-weather-cumulus"}, {"width", "5000"}})).status, 422);
  Request post = with_body(Method::post, "/api/v1/stills", R"({"cloudscape": "fair-weather-cumulus"})");
  post.content_type = "text/plain";
  EXPECT_EQ(ask(post).status, 415);
}

TEST_F(FrontDoor, a_still_is_rendered_once_and_then_cached_and_304) {
  make();
  std::map<std::uint64_t, Response> answers;
  site_->stills.on_ready([&](std::uint64_t waiter, Response response) { answers[waiter] = std::move(response); });
  const Request asked = stills({{"cloudscape", "fair-weather-cumulus"}, {"width", "64"}, {"height", "32"}});
  const auto first = std::get<Pending>(answer(*site_, *router_, asked)).waiter;
  const auto second = std::get<Pending>(answer(*site_, *router_, asked)).waiter;
  EXPECT_EQ(scheduler_->stills_waiting(), 1U);  // both wait for one render
  const auto work = scheduler_->take({});
  ASSERT_TRUE(work && work->still);
  site_->stills.deliver(work->request.stream, picture(100, 10));
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[first].body.bytes.size(), 100U);  // without its front
  EXPECT_EQ(answers[first].content_type, "image/jpeg");
  EXPECT_EQ(header(answers[first], "etag"), header(answers[second], "etag"));
  EXPECT_EQ(ask(asked).body.bytes.size(), 100U);  // at once, from the cache
  Request again = asked;
  again.if_none_match = "W/" + header(answers[first], "etag");
  EXPECT_EQ(ask(again).status, 304);
  again.query.back().second = "48";
  EXPECT_TRUE(std::holds_alternative<Pending>(answer(*site_, *router_, again)));  // another picture
}

TEST_F(FrontDoor, one_client_has_four_stills_and_the_queue_has_an_end) {
  settings_.still_queue = 6;
  make();
  const auto order = [&](int number, const char* client) {
    Request asked = stills({{"cloudscape", "fair-weather-cumulus"}, {"azimuth_deg", std::to_string(number)}});
    asked.client = client;
    const Answer given = answer(*site_, *router_, asked);
    return std::holds_alternative<Pending>(given) ? 0 : std::get<Response>(given).status;
  };
  for (int i = 0; i < 4; ++i) EXPECT_EQ(order(i, "10.0.0.1"), 0);
  EXPECT_EQ(order(4, "10.0.0.1"), 429);
  EXPECT_EQ(order(5, "10.0.0.2"), 0);
  EXPECT_EQ(order(6, "10.0.0.2"), 0);
  EXPECT_EQ(order(7, "10.0.0.2"), 503);
  EXPECT_GT(metrics_.value("cloudscape_refused_total{reason=\"queue\"}"), 0);
}

TEST_F(FrontDoor, a_still_that_nobody_waits_for_is_cancelled) {
  make();
  const Request asked = stills({{"cloudscape", "fair-weather-cumulus"}});
  const auto first = std::get<Pending>(answer(*site_, *router_, asked)).waiter;
  const auto second = std::get<Pending>(answer(*site_, *router_, asked)).waiter;
  site_->stills.leave(first);
  EXPECT_EQ(scheduler_->stills_waiting(), 1U);
  site_->stills.leave(second);
  EXPECT_EQ(scheduler_->stills_waiting(), 0U);
}

TEST_F(FrontDoor, documents_are_put_read_and_removed) {
  make();
  const std::string text = R"({"title": "Mine", "seed": 7} // a comment)";
  EXPECT_EQ(ask(with_body(Method::put, "/api/v1/cloudscapes/mine", text)).status, 201);
  EXPECT_EQ(ask(with_body(Method::put, "/api/v1/cloudscapes/mine", text)).status, 204);
  EXPECT_EQ(json(get("/api/v1/cloudscapes/mine"))["seed"], 7);
  Request written = request(Method::get, "/api/v1/cloudscapes/mine");
  written.query = {{"as", "written"}};
  EXPECT_EQ(ask(written).body.bytes, text);
  const Response bad = ask(with_body(Method::put, "/api/v1/cloudscapes/mine", R"({"sun": {"elevation_deg": 100}})"));
  EXPECT_EQ(bad.status, 400);
  EXPECT_EQ(json(bad)["pointer"], "/sun/elevation_deg");
  EXPECT_EQ(ask(with_body(Method::put, "/api/v1/cloudscapes/Bad Name", "{}")).status, 400);
  EXPECT_EQ(ask(with_body(Method::put, "/api/v1/cloudscapes/fair-weather-cumulus", "{}")).status, 403);
  EXPECT_EQ(ask(request(Method::del, "/api/v1/cloudscapes/fair-weather-cumulus")).status, 403);
  EXPECT_EQ(ask(request(Method::del, "/api/v1/cloudscapes/mine")).status, 204);
  EXPECT_EQ(get("/api/v1/cloudscapes/mine").status, 404);
}

TEST_F(FrontDoor, openapi_describes_every_route_of_the_api) {
  make();
  const Json document = json(get("/api/v1/openapi.json"));
  for (const Route& route : router_->routes()) {
    if (route.pattern == "/" || find(page_, route.pattern.substr(1))) continue;
    ASSERT_TRUE(document["paths"].contains(route.pattern)) << route.pattern;
    for (const auto& [method, handler] : route.methods) {
      std::string name(name_of(method));
      std::ranges::transform(name, name.begin(), [](char c) { return static_cast<char>(std::tolower(c)); });
      EXPECT_TRUE(document["paths"][route.pattern].contains(name)) << route.pattern << ' ' << name;
    }
  }
  EXPECT_EQ(document["paths"].size() + page_.size() + 1, router_->routes().size());
}

class Handshake : public FrontDoor {
 protected:
  Request upgrade() {
    Request asked = request(Method::get, "/api/v1/stream");
    asked.connection = "Upgrade";
    asked.websocket_version = "13";
    asked.websocket_key = "dGhlIHNhbXBsZSBub25jZQ==";
    asked.subprotocols = "cloudscape.v1";
    return asked;
  }
  int status(const Request& asked) {
    const auto refused = refuse_upgrade(asked, *site_);
    return refused ? refused->status : 101;
  }
};

TEST_F(Handshake, checks_what_libwebsockets_does_not) {
  make();
  EXPECT_EQ(status(upgrade()), 101);
  const auto changed = [&](auto change) {
    Request asked = upgrade();
    change(asked);
    return status(asked);
  };
  EXPECT_EQ(changed([](Request& r) { r.path = "/"; }), 404);
  EXPECT_EQ(changed([](Request& r) { r.path = "/api/v1/stills"; }), 404);
  EXPECT_EQ(changed([](Request& r) { r.version = "HTTP/1.0"; }), 400);
  EXPECT_EQ(changed([](Request& r) { r.connection = "keep-alive"; }), 400);
  EXPECT_EQ(changed([](Request& r) { r.connection = "keep-alive, Upgrade"; }), 101);
  for (const char* number : {"", "8", "12", "14", "99", "13x", "013"})
    EXPECT_EQ(changed([&](Request& r) { r.websocket_version = number; }), 426) << number;
  for (const char* key :
       {"", "short==", "dGhlIHNhbXBsZSBub25jZQ", "dGhlIHNhbXBsZSBub25jZTEyMw==", "!GhlIHNhbXBsZSBub25jZQ=="})
    EXPECT_EQ(changed([&](Request& r) { r.websocket_key = key; }), 400) << key;
  for (const char* list : {"", "chat", "cloudscape-http", "cloudscape-http, cloudscape.v1", "bearer.x, cloudscape.v1"})
    EXPECT_EQ(changed([&](Request& r) { r.subprotocols = list; }), 400) << list;
  EXPECT_EQ(changed([](Request& r) { r.subprotocols += ", " + std::string(200, 'a'); }), 400);
  EXPECT_EQ(changed([](Request& r) { r.origin = "http://evil.example"; }), 403);
  EXPECT_EQ(changed([](Request& r) { r.origin = "http://localhost:8080"; }), 101);
  EXPECT_EQ(changed([](Request& r) { r.host = "evil.example"; }), 421);
}

TEST_F(Handshake, waits_until_ready_and_not_while_draining) {
  make(false);
  EXPECT_EQ(status(upgrade()), 503);
  site_->renderer = RendererInfo{};
  EXPECT_EQ(status(upgrade()), 101);
  site_->draining = true;
  EXPECT_EQ(status(upgrade()), 503);
}

}  // namespace
}  // namespace cloudscape::net
