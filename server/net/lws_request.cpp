#include "net/lws_request.h"

#include <libwebsockets.h>

#include <array>

namespace cloudscape::net {
namespace {

struct MethodToken {
  lws_token_indexes token;
  Method method;
};
constexpr std::array method_tokens{
    MethodToken{WSI_TOKEN_GET_URI, Method::get},     MethodToken{WSI_TOKEN_HEAD_URI, Method::head},
    MethodToken{WSI_TOKEN_POST_URI, Method::post},   MethodToken{WSI_TOKEN_PUT_URI, Method::put},
    MethodToken{WSI_TOKEN_DELETE_URI, Method::del},  MethodToken{WSI_TOKEN_OPTIONS_URI, Method::options},
    MethodToken{WSI_TOKEN_PATCH_URI, Method::other},
};

// By length, not up to the first zero byte: "/%00index.html" must not look like "/".
std::string fragment(lws* wsi, lws_token_indexes token, int index) {
  const int size = lws_hdr_fragment_length(wsi, token, index);
  std::string text(static_cast<std::size_t>(size), '\0');
  std::string copy(text.size() + 1, '\0');
  if (lws_hdr_copy_fragment(wsi, copy.data(), size + 1, token, index) < 0) return {};
  return copy.substr(0, text.size());
}

// lws_hdr_copy stops at a zero byte, which then stands in the result and is refused like any other strange value.
std::string header(lws* wsi, lws_token_indexes token) {
  const int size = lws_hdr_total_length(wsi, token);
  if (size <= 0) return {};
  std::string text(static_cast<std::size_t>(size) + 1, '\0');
  if (lws_hdr_copy(wsi, text.data(), size + 1, token) < 0) return {};
  text.resize(static_cast<std::size_t>(size));
  return text;
}

settings::Parameters query(lws* wsi) {
  settings::Parameters parameters;
  if (lws_hdr_total_length(wsi, WSI_TOKEN_HTTP_URI_ARGS) <= 0) return parameters;
  for (int i = 0; lws_hdr_fragment_length(wsi, WSI_TOKEN_HTTP_URI_ARGS, i) > 0; ++i)
    parameters.push_back(query_parameter(fragment(wsi, WSI_TOKEN_HTTP_URI_ARGS, i)));
  return parameters;
}

void copy_headers(lws* wsi, Request& request) {
  request.version = header(wsi, WSI_TOKEN_HTTP);
  request.host = header(wsi, WSI_TOKEN_HOST);
  request.origin = header(wsi, WSI_TOKEN_ORIGIN);
  request.authorization = header(wsi, WSI_TOKEN_HTTP_AUTHORIZATION);
  request.if_none_match = header(wsi, WSI_TOKEN_HTTP_IF_NONE_MATCH);
  request.range = header(wsi, WSI_TOKEN_HTTP_RANGE);
  request.if_range = header(wsi, WSI_TOKEN_HTTP_IF_RANGE);
  request.connection = header(wsi, WSI_TOKEN_CONNECTION);
  request.expect = header(wsi, WSI_TOKEN_HTTP_EXPECT);
  request.content_type = header(wsi, WSI_TOKEN_HTTP_CONTENT_TYPE);
  request.content_length = header(wsi, WSI_TOKEN_HTTP_CONTENT_LENGTH);
  request.transfer_encoding = header(wsi, WSI_TOKEN_HTTP_TRANSFER_ENCODING);
  request.subprotocols = header(wsi, WSI_TOKEN_PROTOCOL);
  request.websocket_version = header(wsi, WSI_TOKEN_VERSION);
  request.websocket_key = header(wsi, WSI_TOKEN_KEY);
}

}  // namespace

Request copy_request(lws* wsi) {
  Request request;
  request.method = Method::other;
  for (const auto& [token, method] : method_tokens) {
    if (lws_hdr_total_length(wsi, token) <= 0) continue;
    request.method = method;
    request.path = fragment(wsi, token, 0);
  }
  request.query = query(wsi);
  copy_headers(wsi, request);
  request.client = peer_address(wsi);
  return request;
}

std::string peer_address(lws* wsi) {
  char address[64] = "";
  lws_get_peer_simple(wsi, address, sizeof address);
  return address;
}

}  // namespace cloudscape::net
