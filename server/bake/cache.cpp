#include "bake/cache.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <string>

#include "core/content_hash.h"
#include "core/log.h"

namespace cloudscape::bake {
namespace {

namespace fs = std::filesystem;

constexpr const char* unfinished_suffix = ".tmp";  // and the number of the process that writes
constexpr std::string_view magic = "cloudscape bake 1\n";

std::size_t cube(int side, std::size_t texel_bytes) {
  return static_cast<std::size_t>(side) * side * side * texel_bytes;
}

std::string payload_of(const BakedTexels& texels) {
  std::string payload(texels.shape.begin(), texels.shape.end());
  payload.append(texels.detail.begin(), texels.detail.end());
  payload.append(texels.variation.begin(), texels.variation.end());
  return payload;
}

// Empty if the payload has not the size that the recipe asks for.
std::optional<BakedTexels> texels_of(const BakeRecipe& recipe, std::string_view payload) {
  const std::size_t shape = cube(recipe.resolution, static_cast<std::size_t>(bytes_per_texel(recipe.format)));
  const std::size_t detail = cube(recipe.detail_resolution, 4);
  const std::size_t variation = static_cast<std::size_t>(variation_resolution) * variation_resolution * 8;
  if (payload.size() != shape + detail + variation) return std::nullopt;
  const auto part = [&](std::size_t begin, std::size_t size) {
    return std::vector<std::uint8_t>(payload.begin() + static_cast<std::ptrdiff_t>(begin),
                                     payload.begin() + static_cast<std::ptrdiff_t>(begin + size));
  };
  return BakedTexels{recipe, part(0, shape), part(shape, detail), part(shape + detail, variation)};
}

std::string read_file(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// File: magic, SHA-256 of the payload in hexadecimal, newline, payload.
std::optional<BakedTexels> parse(const BakeRecipe& recipe, std::string_view file) {
  constexpr std::size_t digest_size = 64;
  if (file.size() < magic.size() + digest_size + 1 || !file.starts_with(magic)) return std::nullopt;
  const std::string_view payload = file.substr(magic.size() + digest_size + 1);
  if (sha256_hex(payload) != file.substr(magic.size(), digest_size)) return std::nullopt;
  return texels_of(recipe, payload);
}

// What a process that was killed while it wrote has left behind. An hour is longer than any write.
void remove_unfinished(const fs::path& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const bool unfinished = entry.path().extension().string().starts_with(unfinished_suffix);
    const auto age = fs::file_time_type::clock::now() - entry.last_write_time(error);
    if (unfinished && age > std::chrono::hours(1)) fs::remove(entry.path(), error);
  }
}

}  // namespace

BakeCache::BakeCache(fs::path folder, std::uint64_t limit_bytes)
    : folder_(std::move(folder)), limit_bytes_(limit_bytes) {
  if (folder_.empty()) return;
  std::error_code error;
  fs::create_directories(folder_, error);
  if (!error && access(folder_.c_str(), W_OK) == 0) {
    remove_unfinished(folder_);
    return;
  }
  log::warn("the cache folder {} cannot be written: bakes are not kept; name another with --cache-dir",
            folder_.string());
  folder_.clear();
}

fs::path BakeCache::path_of(const BakeRecipe& recipe) const { return folder_ / (bake_key(recipe) + ".bake"); }

std::optional<BakedTexels> BakeCache::load(const BakeRecipe& recipe) const {
  const fs::path path = path_of(recipe);
  std::error_code error;
  if (folder_.empty() || !fs::exists(path, error)) return std::nullopt;
  std::optional<BakedTexels> texels = parse(recipe, read_file(path));
  if (texels) {
    fs::last_write_time(path, fs::file_time_type::clock::now(), error);  // the order of eviction
  } else {
    log::warn("the cached bake {} is damaged: it is removed and baked anew", path.string());
    fs::remove(path, error);
  }
  return texels;
}

void BakeCache::store(const BakedTexels& texels) const {
  if (folder_.empty()) return;
  const fs::path path = path_of(texels.recipe);
  const fs::path unfinished = path.string() + unfinished_suffix + std::to_string(getpid());
  const std::string payload = payload_of(texels);
  std::ofstream out(unfinished, std::ios::binary);
  out << magic << sha256_hex(payload) << '\n' << payload;
  out.close();
  std::error_code error;
  if (out) fs::rename(unfinished, path, error);
  if (!out || error) {
    log::warn("the bake cannot be kept in {}: is the disk full?", path.string());
    fs::remove(unfinished, error);
    return;
  }
  evict();
}

void BakeCache::evict() const {
  struct File {
    fs::path path;
    fs::file_time_type used;
    std::uint64_t bytes;
  };
  std::vector<File> files;
  std::uint64_t total = 0;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_, error)) {
    if (entry.path().extension() != ".bake") continue;
    files.push_back({entry.path(), entry.last_write_time(error), entry.file_size(error)});
    total += files.back().bytes;
  }
  std::sort(files.begin(), files.end(), [](const File& a, const File& b) { return a.used < b.used; });
  for (const File& file : files) {
    if (total <= limit_bytes_) return;
    if (fs::remove(file.path, error)) total -= file.bytes;
  }
}

}  // namespace cloudscape::bake
