// Tokens, origins, hosts and the place to listen.
#include "net/authorization.h"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/error.h"

namespace cloudscape::net {
namespace {

const std::string token_text = "0123456789abcdef";

class TokenTest : public testing::Test {
 protected:
  void SetUp() override { unsetenv("CLOUDSCAPE_TOKEN"); }
  void TearDown() override {
    unsetenv("CLOUDSCAPE_TOKEN");
    std::filesystem::remove(file_);
  }
  Token token_of_file(const std::string& content) {
    std::ofstream(file_) << content;
    settings_.token_file = file_;
    return choose_token(settings_, loopback_);
  }
  const std::filesystem::path file_ =
      std::filesystem::temp_directory_path() / ("token_test_" + std::to_string(getpid()));
  settings::ServerSettings settings_;
  const Endpoint loopback_ = parse_endpoint("127.0.0.1:0"), everywhere_ = parse_endpoint("0.0.0.0:0");
};

TEST_F(TokenTest, loopback_needs_none_and_beyond_one_is_made) {
  EXPECT_EQ(choose_token(settings_, loopback_).text, "");
  const Token first = choose_token(settings_, everywhere_), second = choose_token(settings_, everywhere_);
  EXPECT_EQ(first.text.size(), 32U);
  EXPECT_TRUE(first.made);
  EXPECT_NE(first.text, second.text);
  settings_.insecure = true;
  EXPECT_EQ(choose_token(settings_, everywhere_).text, "");
}

TEST_F(TokenTest, environment_and_file_hold_on_loopback_too) {
  setenv("CLOUDSCAPE_TOKEN", token_text.c_str(), 1);
  EXPECT_EQ(choose_token(settings_, loopback_).text, token_text);
  const Token of_file = token_of_file(" from-the-file-0123 \n");
  EXPECT_EQ(of_file.text, "from-the-file-0123");
  EXPECT_FALSE(of_file.made);
}

TEST_F(TokenTest, a_bad_file_is_refused) {
  EXPECT_THROW(token_of_file(""), InvalidInput);
  EXPECT_THROW(token_of_file("short"), InvalidInput);
  EXPECT_THROW(token_of_file("sixteen characters"), InvalidInput);  // a blank cannot be a subprotocol
  EXPECT_THROW(token_of_file(std::string(97, 'a')), InvalidInput);
  settings_.token_file = "/nonexistent/token";
  EXPECT_THROW(choose_token(settings_, loopback_), InvalidInput);
}

Request with(std::string Request::*header, std::string value) {
  Request request;
  request.*header = std::move(value);
  return request;
}

TEST(Authorization, token_comes_as_bearer_or_subprotocol) {
  const Authorization guarded({token_text, false}, true, {});
  EXPECT_TRUE(guarded.accepts(with(&Request::authorization, "Bearer " + token_text)));
  EXPECT_TRUE(guarded.accepts(with(&Request::authorization, "bearer  " + token_text)));
  EXPECT_TRUE(guarded.accepts(with(&Request::subprotocols, "cloudscape.v1, bearer." + token_text)));
  EXPECT_FALSE(guarded.accepts(Request{}));
  EXPECT_FALSE(guarded.accepts(with(&Request::authorization, "Bearer ")));
  EXPECT_FALSE(guarded.accepts(with(&Request::authorization, "Basic " + token_text)));
  EXPECT_FALSE(guarded.accepts(with(&Request::authorization, "Bearer " + token_text + "0")));
  EXPECT_FALSE(guarded.accepts(with(&Request::authorization, "Bearer 0123456789abcdeF")));
  EXPECT_FALSE(guarded.accepts(with(&Request::subprotocols, "bearer." + token_text.substr(1))));
  EXPECT_TRUE(Authorization({}, true, {}).accepts(Request{}));
}

TEST(Authorization, origin_is_that_of_the_host_or_listed) {
  const Authorization guarded({}, true, {"https://example.org"});
  Request request;
  request.host = "localhost:8080";
  EXPECT_TRUE(guarded.accepts_origin(request));  // none: a native client
  for (const char* ours : {"http://localhost:8080", "https://LOCALHOST:8080", "https://example.org"}) {
    request.origin = ours;
    EXPECT_TRUE(guarded.accepts_origin(request)) << ours;
  }
  for (const char* foreign : {"null", "http://localhost", "http://localhost:8081", "http://evil.example",
                              "https://example.org.evil.example", "http://example.org", "localhost:8080"}) {
    request.origin = foreign;
    EXPECT_FALSE(guarded.accepts_origin(request)) << foreign;
  }
}

TEST(Authorization, without_a_token_loopback_answers_to_loopback_names) {
  const Authorization open({}, true, {"http://sky.test:8080"});
  for (const char* host : {"localhost", "localhost:1", "127.0.0.1:8080", "[::1]:8080", "LocalHost:80", "sky.test:8080"})
    EXPECT_TRUE(open.accepts_host(host)) << host;
  for (const char* host : {"", "evil.example", "evil.example:8080", "localhost.evil.example", "127.0.0.1.evil.example"})
    EXPECT_FALSE(open.accepts_host(host)) << host;
  EXPECT_TRUE(Authorization({token_text, false}, true, {}).accepts_host("evil.example"));
  EXPECT_TRUE(Authorization({}, false, {}).accepts_host("evil.example"));
}

TEST(Endpoint, reads_host_and_port) {
  const Endpoint v4 = parse_endpoint("127.0.0.1:8080");
  EXPECT_EQ(v4.address, "127.0.0.1");
  EXPECT_EQ(v4.port, 8080);
  EXPECT_TRUE(v4.loopback);
  EXPECT_FALSE(v4.ipv6);
  const Endpoint v6 = parse_endpoint("[::1]:0");
  EXPECT_EQ(v6.address, "::1");
  EXPECT_TRUE(v6.loopback && v6.ipv6);
  EXPECT_EQ(local_url(v6, 99), "http://[::1]:99/");
  EXPECT_TRUE(parse_endpoint("127.8.8.8:0").loopback);
  const Endpoint any = parse_endpoint("0.0.0.0:80");
  EXPECT_TRUE(any.any && !any.loopback);
  EXPECT_EQ(local_url(any, 80), "http://127.0.0.1:80/");
}

TEST(Endpoint, refuses_what_is_no_place) {
  for (const char* bad : {"", "8080", "127.0.0.1", ":8080", "127.0.0.1:", "127.0.0.1:65536", "127.0.0.1:-1",
                          "127.0.0.1:80x", "::1:8080", "no.such.host.invalid:80"})
    EXPECT_THROW(parse_endpoint(bad), InvalidInput) << bad;
}

TEST(Endpoint, a_port_in_use_is_one_sentence) {
  const int descriptor = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in place{.sin_family = AF_INET, .sin_port = 0, .sin_addr = {htonl(INADDR_LOOPBACK)}, .sin_zero = {}};
  socklen_t size = sizeof place;
  ASSERT_EQ(bind(descriptor, reinterpret_cast<sockaddr*>(&place), size), 0);
  ASSERT_EQ(listen(descriptor, 1), 0);
  getsockname(descriptor, reinterpret_cast<sockaddr*>(&place), &size);
  const std::string port = std::to_string(ntohs(place.sin_port));
  try {
    check_free(parse_endpoint("127.0.0.1:" + port));
    FAIL() << "a port in use was taken for free";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()), "Another program listens on 127.0.0.1:" + port +
                                             " already: stop it, or give another place with --listen HOST:PORT.");
  }
  close(descriptor);
  EXPECT_NO_THROW(check_free(parse_endpoint("127.0.0.1:" + port)));
}

}  // namespace
}  // namespace cloudscape::net
