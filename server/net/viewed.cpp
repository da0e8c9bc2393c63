#include "net/viewed.h"

#include <algorithm>

#include "core/error.h"
#include "core/march_steps.h"

namespace cloudscape::net {
namespace {

std::string number(double value) {
  std::string text = std::to_string(value);
  return text.substr(0, text.find('.') + 2);
}

void check_size(ImageSize size_px, const settings::ServerSettings& limits) {
  const int side = limits.max_stream_side_px;
  const double megapixels = double(size_px.width) * size_px.height / 1e6;
  const std::string is = "is [" + std::to_string(size_px.width) + ", " + std::to_string(size_px.height) + "]: ";
  if (size_px.width < 1 || size_px.height < 1)
    throw InvalidInput("/size_px", is + "must be at least 1 pixel either way");
  if (size_px.width > side || size_px.height > side)
    throw OverLimit("/size_px", is + "a stream has at most " + std::to_string(side) + " pixels a side");
  if (megapixels > limits.max_stream_megapixels)
    throw OverLimit("/size_px", is + "a stream has at most " + number(limits.max_stream_megapixels) + " megapixels");
}

// Before any frame of it is rendered: a ray of 500,000 steps would hold up every other viewer.
void check_march(const stream::StreamView& view, const settings::ServerSettings& limits) {
  RenderQuality quality = render_quality(view.quality);
  const RenderQuality moving = render_quality(Quality::interactive);
  if (most_steps_of_ray(view.march, moving) > most_steps_of_ray(view.march, quality)) quality = moving;
  if (most_steps_of_ray(view.march, quality) <= limits.max_stream_steps) return;
  const MarchSteps each = march_steps(view.march, quality);
  throw OverLimit("/march", "asks for " + std::to_string(each.view) + " * (1 + " + std::to_string(each.light) +
                                ") steps of a ray: a stream has at most " + std::to_string(limits.max_stream_steps) +
                                " (max_stream_steps); lower max_steps or light_steps");
}

void choose_document(Viewed& viewed, const wire::Settings& settings, const settings::CloudscapeLibrary& library) {
  if (settings.cloudscape_document) {
    viewed.document =
        std::make_shared<const Cloudscape>(settings::parse_cloudscape(*settings.cloudscape_document, "cloudscape"));
    viewed.name.clear();
  } else if (settings.cloudscape) {
    viewed.document = library.get(*settings.cloudscape);
    viewed.name = *settings.cloudscape;
  }
}

void move_sun(Viewed& viewed, const wire::Settings& settings) {
  if (settings.reset_sun) viewed.sun_azimuth_deg.reset(), viewed.sun_elevation_deg.reset();
  if (settings.reset_sun || settings.cloudscape || settings.cloudscape_document) viewed.sun_time_rate.reset();
  if (settings.sun_time_rate) viewed.sun_time_rate = settings.sun_time_rate;
  if (settings.sun_azimuth_deg) viewed.sun_azimuth_deg = settings.sun_azimuth_deg;
  if (settings.sun_elevation_deg) viewed.sun_elevation_deg = settings.sun_elevation_deg;
}

// One and the same object as long as nothing in it changes, so that the renderer need not compare documents.
void put_sun_into_view(Viewed& viewed) {
  auto moved = *viewed.document;
  moved.sun.azimuth_deg = viewed.sun_azimuth_deg.value_or(moved.sun.azimuth_deg);
  moved.sun.elevation_deg = viewed.sun_elevation_deg.value_or(moved.sun.elevation_deg);
  const Sun& before = viewed.document->sun;
  moved.sun.place.time_rate = viewed.sun_time_rate.value_or(before.place.time_rate);
  if (moved.sun.azimuth_deg != before.azimuth_deg || moved.sun.elevation_deg != before.elevation_deg)
    moved.sun.place.time_utc.clear(), moved.sun.place.time_rate = 0;
  if (viewed.view.cloudscape && *viewed.view.cloudscape == moved) return;
  viewed.view.cloudscape =
      moved == *viewed.document ? viewed.document : std::make_shared<const Cloudscape>(std::move(moved));
}

template <class T>
void take(T& value, const std::optional<T>& given) {
  if (given) value = *given;
}

void change_view(stream::StreamView& view, const wire::Settings& settings) {
  take(view.size_px, settings.size_px);
  take(view.pose, settings.pose);
  take(view.lens, settings.lens);
  take(view.display, settings.display);
  take(view.march, settings.march);
  take(view.quality, settings.quality);
  take(view.time_s, settings.time_s);
}

void check_sun(const Viewed& viewed, const wire::Settings& settings) {
  if (settings.sun_time_rate.value_or(0) != 0 && viewed.document->sun.place.time_utc.empty())
    throw InvalidInput("/sun_time_rate",
                       "must be 0 or absent: the cloudscape names no place and time (sun.place.time_utc) for its sun");
}

}  // namespace

ImageSize max_stream_size_px(const settings::ServerSettings& settings) {
  const int side = settings.max_stream_side_px;
  return {side, std::min(side, static_cast<int>(settings.max_stream_megapixels * 1e6 / side))};
}

Viewed viewed_by(const wire::Hello& hello, std::string_view text, const settings::CloudscapeLibrary& library,
                 const settings::ServerSettings& limits) {
  Viewed viewed;
  choose_document(viewed, hello.settings, library);
  if (!viewed.document)
    throw InvalidInput("/cloudscape", "is missing: a hello names a cloudscape or holds a whole document");
  const View& view = viewed.document->view;
  viewed.view.pose = view.pose;
  viewed.view.lens = view.lens;
  viewed.view.display = view.display;
  viewed.view.march = view.march;
  wire::Settings wanted = std::get<wire::Hello>(wire::parse_client_message(text, view)).settings;
  wanted.cloudscape.reset();  // chosen already, and it may be long
  wanted.cloudscape_document.reset();
  return changed(std::move(viewed), wanted, library, limits);
}

Viewed changed(Viewed viewed, const wire::Settings& settings, const settings::CloudscapeLibrary& library,
               const settings::ServerSettings& limits) {
  choose_document(viewed, settings, library);
  settings::check_bake(*viewed.document, limits.max_bake_mib, "/cloudscape");
  check_sun(viewed, settings);
  move_sun(viewed, settings);
  put_sun_into_view(viewed);
  change_view(viewed.view, settings);
  viewed.own_time = (viewed.own_time && !settings.follow_clock) || settings.time_s;
  check_size(viewed.view.size_px, limits);
  check_march(viewed.view, limits);
  return viewed;
}

Viewed reloaded(Viewed viewed, const settings::CloudscapeLibrary& library) {
  viewed.document = library.get(viewed.name);
  put_sun_into_view(viewed);
  return viewed;
}

}  // namespace cloudscape::net
