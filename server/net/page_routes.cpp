// The web page's files, from the table that the build made of them.
#include <map>

#include "net/routes.h"

namespace cloudscape::net {
namespace {

std::string media_type(std::string_view path) {
  static const std::map<std::string_view, std::string> types{
      {"html", "text/html; charset=utf-8"},
      {"js", "text/javascript; charset=utf-8"},
      {"css", "text/css; charset=utf-8"},
      {"svg", "image/svg+xml"},
      {"png", "image/png"},
      {"jpg", "image/jpeg"},
      {"ico", "image/x-icon"},
      {"json", "application/json"},
      {"webmanifest", "application/manifest+json"},
      {"woff2", "font/woff2"},
      {"wasm", "application/wasm"},
  };
  const auto found = types.find(path.substr(path.rfind('.') + 1));
  return found == types.end() ? "application/octet-stream" : found->second;
}

Handler serve(const EmbeddedFile& file) {
  return [file, type = media_type(file.path), etag = quoted_etag(file.bytes)](const Request& request, auto&) {
    return revalidated(request, {200, type, {}, Body::of_static(file.bytes), false}, etag);
  };
}

}  // namespace

void add_page_routes(Router& router, const Site& site) {
  for (const EmbeddedFile& file : site.parts.page) {
    router.add({"/" + std::string(file.path), true, {{Method::get, serve(file)}}});
    if (file.path == "index.html") router.add({"/", true, {{Method::get, serve(file)}}});
  }
  for (const EmbeddedFile& file : site.parts.pictures)
    router.add({"/pictures/" + std::string(file.path), true, {{Method::get, serve(file)}}});
}

}  // namespace cloudscape::net
