// Status and close codes in words.
#include "viewer/closing.h"

namespace cloudscape::viewer {
namespace {

// 408, 429 and 5xx pass with time; the rest of 4xx, and an answer that is no upgrade, do not.
bool passes_with_time(int http_status) {
  return http_status == 0 || http_status == 408 || http_status == 429 || http_status >= 500;
}

std::string what_it_means(int http_status) {
  switch (http_status) {
    case 401:
      return "it wants a token: give --token with the one the server printed at its start";
    case 403:
      return "it refuses this token or this client: check --token and the server's allowed origins";
    case 404:
      return "it has no stream at this path: check the address";
    case 426:
      return "it speaks another version of the protocol: use the viewer of the server's version";
    default:
      return http_status < 400 ? "it is no cloudscape server, or something between answers for it: check the address"
                               : "it does not accept the request";
  }
}

}  // namespace

std::optional<std::string> refusal(const Closing& closing, const std::string& authority) {
  const std::string server = "The server at " + authority;
  if (!closing.was_open) {
    if (passes_with_time(closing.http_status)) return std::nullopt;
    return server + " answered " + std::to_string(closing.http_status) + ": " + what_it_means(closing.http_status) +
           ".";
  }
  switch (closing.close_code) {
    case 1002:
    case 1003:
    case 1007:
    case 1008:
    case 1009:
      return server + " closed the stream with code " + std::to_string(closing.close_code) +
             (closing.reason.empty() ? "" : " (" + closing.reason + ")") + ".";
    default:
      return std::nullopt;
  }
}

std::string describe(const Closing& closing, const std::string& authority) {
  if (closing.was_open) {
    const std::string code = closing.close_code == 0 ? "" : " with code " + std::to_string(closing.close_code);
    return "The connection to " + authority + " ended" + code + ".";
  }
  const std::string reason = closing.http_status != 0
                                 ? "it answered " + std::to_string(closing.http_status) + ", which may pass"
                             : closing.reason.empty() ? "it does not answer"
                                                      : closing.reason;
  return "No connection to " + authority + ": " + reason + ".";
}

}  // namespace cloudscape::viewer
