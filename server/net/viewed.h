// What one viewer looks at: a document, where its sun was moved to, and the view. Changed by its settings messages.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "settings/cloudscape_json.h"
#include "settings/server_settings.h"
#include "stream/frame_scheduler.h"
#include "wire/messages.h"

namespace cloudscape::net {

struct Viewed {
  std::shared_ptr<const Cloudscape> document;  // as it was written
  std::string name;                            // "" for a document of the client's own
  std::optional<double> sun_azimuth_deg, sun_elevation_deg, sun_time_rate;
  bool own_time = false;    // view.time_s, and not the document's clock
  stream::StreamView view;  // its cloudscape is the document with the sun moved
};

// The widest picture that a stream may have.
ImageSize max_stream_size_px(const settings::ServerSettings& settings);
// What a hello asks for: it starts from the document's own view.
// `text` is the hello's own, read again: what it gives in part is completed from that view.
Viewed viewed_by(const wire::Hello& hello, std::string_view text, const settings::CloudscapeLibrary& library,
                 const settings::ServerSettings& limits);
// `viewed` after a settings message. Throws InvalidInput, NotFound, OverLimit; then nothing has changed.
Viewed changed(Viewed viewed, const wire::Settings& settings, const settings::CloudscapeLibrary& library,
               const settings::ServerSettings& limits);
// `viewed` with the document that now has its name.
Viewed reloaded(Viewed viewed, const settings::CloudscapeLibrary& library);

}  // namespace cloudscape::net
