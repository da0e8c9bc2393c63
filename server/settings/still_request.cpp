// Stills: query parameters and JSON bodies fill the same described values, and what they ask for is held to the limits.
#include "settings/still_request.h"

#include <algorithm>

#include "core/content_hash.h"
#include "core/march_steps.h"
#include "core/sun_position.h"
#include "settings/cloudscape_reader.h"
#include "settings/described_json.h"
#include "settings/still_body.h"
#include "settings/still_reader.h"

namespace cloudscape::settings {
namespace {

using nlohmann::json;

// A query's name of a member of the body, where it is not the member's own.
std::string parameter_name(const std::string& path) {
  if (path == "/camera/position_m") return "position";
  if (path == "/camera/lens/kind") return "lens";
  if (path == "/medium/phase/kind") return "phase";
  if (path == "/medium/light_model/kind") return "light_model";
  if (path == "/sun/azimuth_deg") return "sun_azimuth_deg";
  if (path == "/sun/elevation_deg") return "sun_elevation_deg";
  return path.substr(path.rfind('/') + 1);
}

// Calls visit(path in the body, member, limits, description) for every parameter.
template <class T>
void each_parameter(T& value, auto&& visit, const std::string& path = "") {
  std::remove_const_t<T>::fields(
      value, [&](std::string_view name, auto& member, const Limits& limits, std::string_view meaning) {
        const std::string inner = path + "/" + std::string(name);
        if constexpr (Described<std::remove_cvref_t<decltype(member)>>)
          each_parameter(member, visit, inner);
        else
          visit(inner, member, limits, meaning);
      });
}

StillBody body_of(const Cloudscape& cloudscape) {
  StillBody body;
  body.camera = {cloudscape.view.pose, cloudscape.view.lens};
  body.image.display = cloudscape.view.display;
  body.image.encoding.chroma = ChromaSubsampling::none;
  body.sun.sun = cloudscape.sun;
  body.march = cloudscape.view.march;
  body.medium = {cloudscape.medium.phase, cloudscape.medium.light_model};
  return body;
}

// tuned: no picture looks better with more, and the work that a request can mean stays bounded.
constexpr int most_samples_by_default = 4096;

// What cannot change the picture's bytes takes its default, so that requests that mean the same are the same.
void settle(StillImage& image) {
  const Encoding defaults;
  if (image.encoding.format != ImageFormat::jpeg) image.encoding.jpeg_quality = defaults.jpeg_quality;
  if (image.encoding.format != ImageFormat::exr) image.encoding.exr_type = defaults.exr_type;
  if (image.encoding.format == ImageFormat::exr) image.display = Display{};
  const RenderQuality quality = render_quality(image.quality);
  if (quality.technique != Technique::path_tracing) image.tracing = Tracing{};
  const bool ends_itself = image.tracing.time_budget_s || image.tracing.noise_target;
  if (!image.samples) image.samples = ends_itself ? most_samples_by_default : quality.samples;
}

void check_side(int side_px, const std::string& pointer, const StillLimits& limits) {
  if (side_px > limits.max_side_px)
    throw OverLimit(pointer, "is " + std::to_string(side_px) + ": this server's limit is " +
                                 std::to_string(limits.max_side_px) + " pixels a side");
}

// `prefix` is where the picture's members stand: "/" in a query, "/image/" in a body.
void check_limits(const FrameRequest& request, const std::string& prefix, const StillLimits& limits) {
  const ImageSize& size_px = request.size_px;
  check_side(size_px.width, prefix + "width", limits);
  check_side(size_px.height, prefix + "height", limits);
  const double megapixels = double(size_px.width) * size_px.height / 1e6;
  if (megapixels > limits.max_megapixels)
    throw OverLimit(prefix + "width", "times height is " + number_text(megapixels) +
                                          " megapixels: this server's limit is " + number_text(limits.max_megapixels));
  const double gigasteps = gigasteps_of(request);
  if (gigasteps > limits.max_gigasteps)
    throw OverLimit(prefix + "quality", "asks for " + number_text(gigasteps) +
                                            " gigasteps (pixels * samples * steps * (1 + light steps) / 1e9): this "
                                            "server's limit is " +
                                            number_text(limits.max_gigasteps) +
                                            " (max_still_gigasteps); lower width, height, samples, quality, max_steps "
                                            "or light_steps");
}

void check_tracing(const FrameRequest& request, const std::string& prefix) {
  if (request.tracing.atmosphere != TracedAtmosphere::traced || request.cloudscape->sky.kind == SkyKind::clear) return;
  throw InvalidInput(prefix + "atmosphere", "is traced, but the cloudscape's sky is " +
                                                std::string(name_of(request.cloudscape->sky.kind)) +
                                                ": only a clear sky has air to trace; ask for tables");
}

// The sun stands by the place and time that the request names, else by its angles, else as the document says.
void place_sun(Cloudscape& changed, StillBody& body, const std::string& where) {
  Sun& sun = body.sun.sun;
  const bool placed = !(sun.place == changed.sun.place);
  if (placed && sun.place.time_utc.empty())
    throw InvalidInput(where, "is missing: a place needs a time, such as 2026-06-21T12:00:00Z");
  if (placed && !julian_day(sun.place.time_utc))
    refuse(where, sun.place.time_utc, "a time from 1901 to 2099 such as 2026-06-21T12:00:00Z");
  const bool turned = sun.azimuth_deg != changed.sun.azimuth_deg || sun.elevation_deg != changed.sun.elevation_deg;
  if (turned && !placed) sun.place.time_utc.clear();
  changed.sun = sun;
  if (placed) place_sun_and_moon(changed);
  sun = changed.sun;
}

// The cloudscape with what the request changes of it; itself where that is nothing. `prefix` as below.
std::shared_ptr<const Cloudscape> as_asked(const std::shared_ptr<const Cloudscape>& cloudscape, StillBody& body,
                                           const std::string& prefix) {
  auto changed = std::make_shared<Cloudscape>(*cloudscape);
  place_sun(*changed, body, prefix == "/" ? "/time_utc" : "/sun/place/time_utc");
  changed->medium.phase = body.medium.phase;
  changed->medium.light_model = body.medium.light_model;
  return *changed == *cloudscape ? cloudscape : changed;
}

std::string canonical_text(const Cloudscape& cloudscape, const StillBody& body) {
  std::string text = "cloudscape=" + content_hash(cloudscape);
  each_parameter(body, [&](const std::string& path, const auto& member, auto&&...) {
    text += "&" + parameter_name(path) + "=" + value_as_text(write(member));
  });
  return text;
}

StillRequest finish(const std::shared_ptr<const Cloudscape>& cloudscape, StillBody body, const std::string& prefix,
                    const StillLimits& limits) {
  settle(body.image);
  check_bake(*cloudscape, limits.max_bake_mib, "/cloudscape");
  StillRequest request;
  request.frame.cloudscape = as_asked(cloudscape, body, prefix);
  request.frame.pose = body.camera.pose;
  request.frame.lens = body.camera.lens;
  request.frame.display = body.image.display;
  request.frame.march = body.march;
  request.frame.size_px = body.image.size_px;
  request.frame.quality = render_quality(body.image.quality);
  request.frame.quality.samples = *body.image.samples;
  request.frame.tracing = body.image.tracing;
  request.frame.time_s = body.image.time_s;
  request.encoding = body.image.encoding;
  request.frame.content = request.encoding.format == ImageFormat::exr ? FrameContent::radiance : FrameContent::display;
  check_limits(request.frame, prefix, limits);
  check_tracing(request.frame, prefix);
  request.canonical = canonical_text(*request.frame.cloudscape, body);
  return request;
}

const char* const cloudscape_missing = "is missing: must name a cloudscape, such as fair-weather-cumulus";

void check_names(const Parameters& parameters, const StillBody& body) {
  std::vector<std::string> names{"cloudscape", "still"};
  each_parameter(body, [&](const std::string& path, auto&&...) { names.push_back(parameter_name(path)); });
  const std::vector<std::string_view> known(names.begin(), names.end());
  std::vector<std::string_view> seen;
  for (const auto& [name, value] : parameters) {
    const std::string pointer = "/" + pointer_part(name);
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw InvalidInput(pointer, "is not a known parameter: " + suggestion(name, known));
    if (std::find(seen.begin(), seen.end(), name) != seen.end())
      throw InvalidInput(pointer, "stands twice: keep one of the two");
    seen.push_back(name);
  }
}

const std::string* find_value(const Parameters& parameters, const std::string& name) {
  for (const auto& [key, value] : parameters)
    if (key == name) return &value;
  return nullptr;
}

// `pointer` is where the cloudscape stands.
std::shared_ptr<const Cloudscape> cloudscape_in(const json& body, const std::string& pointer,
                                                const CloudscapeLibrary& library) {
  const auto cloudscape = body.find("cloudscape");
  if (cloudscape == body.end()) throw InvalidInput(pointer, cloudscape_missing);
  if (cloudscape->is_string()) return library.get(cloudscape->get_ref<const std::string&>());
  if (!cloudscape->is_object()) refuse(pointer, *cloudscape, "a cloudscape's name or a whole document");
  return std::make_shared<const Cloudscape>(read_cloudscape(*cloudscape, pointer));
}

// A still as it was asked for, before it is held to the limits.
struct Asked {
  std::shared_ptr<const Cloudscape> cloudscape;
  StillBody body;
};

// `where` opens the pointers of errors.
Asked read_body(json parsed, const std::string& where, const CloudscapeLibrary& library) {
  auto names = field_names<StillBody>();
  for (const auto name : field_names<StillHeading>()) names.push_back(name);
  names.insert(names.begin(), "cloudscape");
  detail::check_object(parsed, where, names);
  StillHeading heading;
  StillHeading::fields(heading, [&](std::string_view name, auto& member, const Limits& limits, std::string_view) {
    const auto given = parsed.find(name);
    if (given == parsed.end()) return;
    read(*given, member, where + "/" + std::string(name), limits);
    parsed.erase(given);
  });
  Asked asked{cloudscape_in(parsed, where + "/cloudscape", library), {}};
  asked.body = body_of(*asked.cloudscape);
  parsed.erase("cloudscape");
  read(parsed, asked.body, where);
  return asked;
}

void apply(const Parameters& parameters, StillBody& body) {
  each_parameter(body, [&](const std::string& path, auto& member, const Limits& within, std::string_view) {
    const std::string key = parameter_name(path);
    if (const std::string* text = find_value(parameters, key)) read_text(*text, member, "/" + key, within);
  });
}

// Whose value a parameter takes where it is absent.
std::string default_text(const std::string& path, const std::string& own) {
  const auto shown_as = field_names<Display>();
  const std::string name = path.substr(path.rfind('/') + 1);
  if (path.starts_with("/sun/"))
    return path.starts_with("/sun/place/") ? "the cloudscape's place" : "the cloudscape's sun";
  if (path.starts_with("/medium/")) return "the cloudscape's medium";
  if (path.starts_with("/camera/") || path.starts_with("/march/") ||
      std::find(shown_as.begin(), shown_as.end(), name) != shown_as.end())
    return "the cloudscape's view";
  const auto traced = field_names<Tracing>();
  if (own.empty() && std::find(traced.begin(), traced.end(), name) != traced.end()) return "no limit";
  return name == "samples" ? "the quality's" : own;
}

}  // namespace

double gigasteps_of(const FrameRequest& request) {
  const double pixels = double(request.size_px.width) * request.size_px.height;
  return pixels * request.quality.samples * most_steps_of_ray(request.march, request.quality) / 1e9;
}

StillRequest still_from_parameters(const Parameters& parameters, const CloudscapeLibrary& library,
                                   const StillLimits& limits) {
  check_names(parameters, {});
  if (const std::string* still = find_value(parameters, "still"))
    return still_from_document(named_still(*still), parameters, library, limits);
  const std::string* name = find_value(parameters, "cloudscape");
  if (!name) throw InvalidInput("/cloudscape", cloudscape_missing);
  const auto cloudscape = library.get(*name);
  StillBody body = body_of(*cloudscape);
  apply(parameters, body);
  return finish(cloudscape, body, "/", limits);
}

StillRequest still_from_document(const StillDocument& document, const Parameters& parameters,
                                 const CloudscapeLibrary& library, const StillLimits& limits) {
  check_names(parameters, {});
  json parsed = parse_json(document.text, document.source.empty() ? "still" : document.source);
  const std::string* name = find_value(parameters, "cloudscape");
  if (name && parsed.is_object()) parsed["cloudscape"] = *name;
  Asked asked = read_body(std::move(parsed), document.source.empty() ? "" : document.source + "#", library);
  apply(parameters, asked.body);
  return finish(asked.cloudscape, asked.body, "/", limits);
}

StillRequest still_from_json(std::string_view text, const CloudscapeLibrary& library, const StillLimits& limits) {
  return still_from_parsed(parse_json(text, "body"), library, limits);
}

StillRequest still_from_parsed(json parsed, const CloudscapeLibrary& library, const StillLimits& limits) {
  const Asked asked = read_body(std::move(parsed), "", library);
  return finish(asked.cloudscape, asked.body, "/image/", limits);
}

std::vector<ParameterInfo> still_parameters(const StillLimits& limits) {
  std::vector<ParameterInfo> parameters{
      {"cloudscape", "string", "Name of the cloudscape; required without a still.", {}, std::nullopt, std::nullopt, ""},
      {"still",
       "string",
       "Name of a still; it gives what no other parameter does.",
       {},
       std::nullopt,
       std::nullopt,
       ""}};
  const StillBody body = body_of({});
  each_parameter(body,
                 [&](const std::string& path, const auto& member, const Limits& within, std::string_view meaning) {
                   ParameterInfo info = describe(parameter_name(path), member, within, meaning);
                   info.default_text = default_text(path, info.default_text);
                   if (info.name == "width" || info.name == "height") info.max = limits.max_side_px;
                   parameters.push_back(std::move(info));
                 });
  return parameters;
}

}  // namespace cloudscape::settings
