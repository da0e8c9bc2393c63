// The cloudscape document: reader, rules between fields, writer, schema and reference.
#include "settings/cloudscape_json.h"

#include <cmath>

#include "core/bake_size.h"
#include "core/sun_position.h"
#include "settings/cloudscape_reader.h"
#include "settings/described_json.h"
#include "settings/described_schema.h"
#include "settings/layer_checks.h"

namespace cloudscape::settings {
namespace {

// The document at its root, where editors keep the schema's address.
struct Root {
  std::string schema;
  Cloudscape cloudscape;

  static void fields(auto& self, auto&& visit) {
    visit("$schema", self.schema, Limits{}, "Address of this schema, for editors; passed over.");
    Cloudscape::fields(self.cloudscape, visit);
  }
};

// Anyone may send a document: it must not reach a file outside the folder of height maps.
void check_height_map(const std::string& name, const std::string& pointer) {
  if (!name.empty() && !is_height_map_name(name))
    refuse(pointer, name, "the bare name of a .png or .exr file in the folder of height maps, or empty");
}

void check_place(const Place& place, const std::string& pointer) {
  if (!place.time_utc.empty() && !julian_day(place.time_utc))
    refuse(pointer + "/time_utc", place.time_utc, "a time from 1901 to 2099 such as 2026-06-21T12:00:00Z, or empty");
  if (place.time_rate != 0 && place.time_utc.empty())
    refuse(pointer + "/time_rate", place.time_rate,
           "0 where time_utc is empty: a sun that is put by its angles stands still");
}

// As with height maps. Which of the two kinds of file it is follows from the volume's kind.
void check_volume_file(const Volume& volume, const std::string& pointer) {
  const std::string& name = volume.grid.file;
  const bool vdb = volume.kind == VolumeKind::vdb;
  const bool bare = vdb ? is_vdb_name(name) : is_grid_name(name);
  const bool unused = !is_from_file(volume.kind) && (name.empty() || is_vdb_name(name));
  if (!bare && !unused)
    refuse(pointer, name,
           std::string("the bare name of a ") + (vdb ? ".vdb" : ".raw or .exr") + " file in the folder of volumes");
}

// What to lower where the textures are too large: key of the volume, and its value.
std::pair<std::string, std::string> size_of_bake(const Cloudscape& cloudscape) {
  const Volume& volume = cloudscape.volume;
  const auto& size = volume.grid.size;
  if (volume.kind == VolumeKind::vdb) return {"grid/resolution", number_text(volume.grid.resolution)};
  if (volume.kind == VolumeKind::grid)
    return {"grid/size", std::to_string(size[0]) + "x" + std::to_string(size[1]) + "x" + std::to_string(size[2])};
  return {"resolution", std::to_string(volume.resolution) + " in " + std::string(name_of(shape_format(cloudscape)))};
}

nlohmann::ordered_json document_schema() { return schema<Root>("urn:cloudscape:document:1", "Cloudscape document"); }

}  // namespace

void check(const Cloudscape& cloudscape, const std::string& pointer) {
  check_height_map(cloudscape.ground.terrain.height_map, pointer + "/ground/terrain/height_map");
  check_place(cloudscape.sun.place, pointer + "/sun/place");
  check_volume_file(cloudscape.volume, pointer + "/volume/grid/file");
  check_layers(cloudscape, pointer);
  if (cloudscape.volume.kind != VolumeKind::noise) return;
  for (std::size_t i = 0; i < cloudscape.noise.channels.size(); ++i) {
    const NoiseChannel& channel = cloudscape.noise.channels[i];
    check_octaves(pointer + "/noise/channels/" + std::to_string(i),
                  channel.frequency * std::pow(channel.lacunarity, channel.octaves - 1),
                  "frequency * lacunarity^(octaves - 1)", cloudscape.volume.resolution, "volume.resolution");
  }
  const Detail& fine = cloudscape.detail;
  check_octaves(pointer + "/detail", fine.frequency * std::exp2(fine.octaves - 1), "frequency * 2^(octaves - 1)",
                fine.resolution, "detail.resolution");
}

void check_bake(const Cloudscape& cloudscape, double max_bake_mib, const std::string& pointer) {
  const double mib = static_cast<double>(bake_bytes(cloudscape)) / (1024.0 * 1024.0);
  if (mib <= max_bake_mib) return;
  const auto [key, value] = size_of_bake(cloudscape);
  const bool noise = cloudscape.volume.kind == VolumeKind::noise;
  throw OverLimit(pointer + "/volume/" + key, "is " + value + ", whose textures take " + number_text(mib) +
                                                  " MiB: this server's limit is " + number_text(max_bake_mib) +
                                                  " (max_bake_mib); lower volume." +
                                                  (is_layered(cloudscape) ? "resolution"
                                                   : noise                ? "resolution or ask for volume.format r16f"
                                                                          : "grid"));
}

Cloudscape read_cloudscape(const nlohmann::json& json, const std::string& pointer) {
  Root root;
  read(json, root, pointer);
  check(root.cloudscape, pointer);
  place_sun_and_moon(root.cloudscape);
  return root.cloudscape;
}

Cloudscape parse_cloudscape(std::string_view text, const std::string& source) {
  return read_cloudscape(parse_json(text, source), "");
}

std::string to_json(const Cloudscape& cloudscape) { return to_text(write(cloudscape), 2) + "\n"; }
std::string cloudscape_schema() { return to_text(document_schema(), 2) + "\n"; }
std::string cloudscape_reference() { return reference(document_schema(), "document"); }

}  // namespace cloudscape::settings
