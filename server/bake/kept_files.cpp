#include "bake/kept_files.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <optional>
#include <vector>

#include "core/content_hash.h"
#include "core/log.h"

namespace cloudscape::bake {
namespace {

namespace fs = std::filesystem;

constexpr const char* unfinished_suffix = ".tmp";  // and the number of the process that writes

constexpr std::array<std::string_view, 5> extensions{".bake", ".phase", ".light", ".distance", ".relief"};

// Whether a file of the folder is one of ours.
bool is_kept(const fs::path& path) {
  const std::string extension = path.extension();
  return std::ranges::find(extensions, extension) != extensions.end();
}

std::string read_file(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  std::string bytes(error ? 0 : size, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

// File: magic, SHA-256 of the payload in hexadecimal, newline, payload.
std::optional<std::string_view> payload_of(std::string_view file, std::string_view magic) {
  constexpr std::size_t digest_size = 64;
  if (file.size() < magic.size() + digest_size + 1 || !file.starts_with(magic)) return std::nullopt;
  const std::string_view payload = file.substr(magic.size() + digest_size + 1);
  if (sha256_hex(payload) != file.substr(magic.size(), digest_size)) return std::nullopt;
  return payload;
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

KeptFiles::KeptFiles(fs::path folder, std::uint64_t limit_bytes)
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

bool KeptFiles::load(const std::string& name, std::string_view magic,
                     const std::function<bool(std::string_view)>& take) const {
  const fs::path path = path_of(name);
  std::error_code error;
  if (folder_.empty() || !fs::exists(path, error)) return false;
  const std::string file = read_file(path);
  const auto payload = payload_of(file, magic);
  if (payload && take(*payload)) {
    fs::last_write_time(path, fs::file_time_type::clock::now(), error);  // the order of eviction
    return true;
  }
  log::warn("the cached file {} is damaged: it is removed and made anew", path.string());
  fs::remove(path, error);
  return false;
}

bool KeptFiles::has(const std::string& name) const {
  std::error_code error;
  return !folder_.empty() && fs::exists(path_of(name), error);
}

void KeptFiles::store(const std::string& name, std::string_view magic, std::string_view payload) const {
  if (folder_.empty()) return;
  const fs::path path = path_of(name);
  const fs::path unfinished = path.string() + unfinished_suffix + std::to_string(getpid());
  std::ofstream out(unfinished, std::ios::binary);
  out << magic << sha256_hex(payload) << '\n' << payload;
  out.close();
  std::error_code error;
  if (out) fs::rename(unfinished, path, error);
  if (!out || error) {
    log::warn("the file {} cannot be kept: is the disk full?", path.string());
    fs::remove(unfinished, error);
    return;
  }
  evict();
}

void KeptFiles::evict() const {
  struct File {
    fs::path path;
    fs::file_time_type used;
    std::uint64_t bytes;
  };
  std::vector<File> files;
  std::uint64_t total = 0;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_, error)) {
    if (!is_kept(entry.path())) continue;
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
