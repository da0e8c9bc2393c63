// Requests, responses, routes and problems as plain values.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "net/header_list.h"
#include "net/http_request.h"
#include "net/http_response.h"
#include "net/problem.h"
#include "net/router.h"

namespace cloudscape::net {
namespace {

Request with_length(std::string text) {
  Request request;
  request.content_length = std::move(text);
  return request;
}

TEST(Request, content_length_is_one_decimal_number) {
  EXPECT_EQ(content_length(with_length("0")), 0U);
  EXPECT_EQ(content_length(with_length("262144")), 262144U);
  for (const char* bad : {"", "-5", "+5", " 5", "5 ", "5,5", "0x10", "1e3", "five", "99999999999999999999"})
    EXPECT_EQ(content_length(with_length(bad)), std::nullopt) << bad;
}

TEST(Request, a_length_of_zero_is_no_body) {
  EXPECT_FALSE(has_body(Request{}));
  EXPECT_FALSE(has_body(with_length("0")));
  EXPECT_TRUE(has_body(with_length("1")));
  EXPECT_TRUE(has_body(with_length("nonsense")));
  Request chunked;
  chunked.transfer_encoding = "chunked";
  EXPECT_TRUE(has_body(chunked));
}

TEST(Request, a_parameter_splits_at_its_first_equals_sign) {
  using Pair = std::pair<std::string, std::string>;
  EXPECT_EQ(query_parameter("a=b=c"), (Pair{"a", "b=c"}));
  EXPECT_EQ(query_parameter("a"), (Pair{"a", ""}));
  EXPECT_EQ(query_parameter("=b"), (Pair{"", "b"}));
}

TEST(HeaderList, members_are_trimmed_and_empty_ones_left_out) {
  EXPECT_EQ(split_list(" a ,, b\t,"), (std::vector<std::string_view>{"a", "b"}));
  EXPECT_TRUE(split_list(" , ").empty());
  EXPECT_TRUE(has_token("keep-alive, Upgrade", "upgrade"));
  EXPECT_FALSE(has_token("keep-alive, Upgrades", "upgrade"));
}

TEST(Response, head_has_length_type_and_security_headers) {
  const std::string head = head_text(text_response(200, "text/plain", "12345"));
  EXPECT_TRUE(head.starts_with("HTTP/1.1 200 OK\r\n")) << head;
  EXPECT_TRUE(head.ends_with("\r\n\r\n"));
  for (const char* line :
       {"content-type: text/plain\r\n", "content-length: 5\r\n", "x-content-type-options: nosniff\r\n",
        "referrer-policy: no-referrer\r\n", "cross-origin-resource-policy: same-origin\r\n", "default-src 'none'",
        "frame-ancestors 'none'"})
    EXPECT_NE(head.find(line), std::string::npos) << line;
  EXPECT_EQ(head.find("connection:"), std::string::npos);
}

TEST(Response, no_length_where_there_can_be_no_content) {
  EXPECT_EQ(head_text(empty_response(304)).find("content-length"), std::string::npos);
  EXPECT_NE(head_text(empty_response(201)).find("content-length: 0\r\n"), std::string::npos);
}

TEST(Response, a_line_break_in_a_value_makes_no_second_header) {
  const std::string head = head_text(empty_response(204).with("location", "/a\r\nset-cookie: x=1"));
  EXPECT_EQ(head.find("\r\nset-cookie"), std::string::npos);
}

TEST(Response, dates_are_those_of_http) {
  EXPECT_EQ(http_date(784111777), "Sun, 06 Nov 1994 08:49:37 GMT");  // the example of RFC 9110
}

TEST(Etag, matches_lists_stars_and_weak_forms) {
  const std::string etag = quoted_etag("bytes");
  EXPECT_EQ(etag.size(), 34U);
  EXPECT_NE(etag, quoted_etag("other bytes"));
  EXPECT_TRUE(none_match_holds(etag, etag));
  EXPECT_TRUE(none_match_holds("*", etag));
  EXPECT_TRUE(none_match_holds("\"a\", W/" + etag, etag));
  EXPECT_FALSE(none_match_holds("", etag));
  EXPECT_FALSE(none_match_holds(etag.substr(1, 32), etag));  // unquoted
}

nlohmann::json body_of(const Response& response) { return nlohmann::json::parse(response.body.bytes); }

TEST(Problem, says_status_sentence_and_pointer) {
  const Response response = problem_of(InvalidInput("/width", "is 0: must be within [1, 4096]"));
  EXPECT_EQ(response.status, 400);
  EXPECT_EQ(response.content_type, "application/problem+json");
  EXPECT_EQ(body_of(response)["detail"], "/width is 0: must be within [1, 4096]");
  EXPECT_EQ(body_of(response)["pointer"], "/width");
  EXPECT_EQ(body_of(response)["status"], 400);
}

TEST(Problem, status_follows_the_kind_of_error) {
  EXPECT_EQ(problem_of(OverLimit("/width", "is too much")).status, 422);
  EXPECT_EQ(problem_of(NotFound("no such cloudscape")).status, 404);
  EXPECT_EQ(problem_of(Error("disk full")).status, 500);
  const Response inner = problem_of(std::runtime_error("address 0x7fff"));
  EXPECT_EQ(inner.status, 500);
  EXPECT_EQ(inner.body.bytes.find("0x7fff"), std::string_view::npos);
}

TEST(Problem, bytes_that_are_not_utf8_are_replaced) {
  EXPECT_NO_THROW(body_of(problem(400, "name is \"\xff\xfe<script>\"")));
}

TEST(Router, finds_exact_paths_and_names_without_slash) {
  Router router;
  router.add({"/a", true, {{Method::get, [](auto&...) { return empty_response(204); }}}});
  router.add({"/things/{name}", false, {{Method::put, [](auto&...) { return empty_response(204); }}}});
  ASSERT_NE(router.find("/a"), nullptr);
  EXPECT_EQ(router.find("/a/"), nullptr);
  EXPECT_EQ(router.find("/things/"), nullptr);
  EXPECT_EQ(router.find("/things/x/y"), nullptr);
  ASSERT_NE(router.find("/things/x"), nullptr);
  EXPECT_EQ(router.find("/things/x")->name_in("/things/x"), "x");
  EXPECT_EQ(router.find("/a")->allow(), "GET, HEAD, OPTIONS");
  EXPECT_EQ(router.find("/things/x")->allow(), "PUT, OPTIONS");
  EXPECT_EQ(router.find("/things/x")->handler(Method::get), nullptr);
  EXPECT_NE(router.find("/a")->handler(Method::head), nullptr);
}

}  // namespace
}  // namespace cloudscape::net
