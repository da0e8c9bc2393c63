#include "vdb/one_grid.h"

#include <cstdint>
#include <cstring>
#include <fstream>
#include <vector>

#include "core/error.h"
#include "vdb/vdb_file.h"

namespace cloudscape::vdb {
namespace {

constexpr std::int64_t magic = 0x56444220;
constexpr std::uint32_t oldest_version = 222;    // of 2013; earlier files are laid out otherwise
constexpr std::uint32_t farthest_version = 255;  // OpenVDB 10 writes 224, and reads later ones as well as it can
constexpr std::size_t uuid_bytes = 36;
constexpr std::uint32_t longest_name = 1 << 16, most_entries = 1 << 16;

[[noreturn]] void refuse_damaged() { throw UnusableFile("is damaged, cut off or no OpenVDB file: write it anew"); }

// Reads forward and remembers what it read; never beyond the end.
class Reader {
 public:
  Reader(std::istream& in, std::uint64_t size) : in_(in), size_(size) {}
  std::string bytes(std::uint64_t count) {
    if (count > size_ - at_) refuse_damaged();
    std::string text(count, '\0');
    if (!in_.read(text.data(), static_cast<std::streamsize>(count))) refuse_damaged();
    at_ += count;
    return text;
  }
  template <class T>
  T number() {
    T value;
    std::memcpy(&value, taken(bytes(sizeof(T))).data(), sizeof(T));
    return value;
  }
  std::string text() {
    const auto length = number<std::uint32_t>();
    if (length > longest_name) refuse_damaged();
    return taken(bytes(length));
  }
  void go_to(std::uint64_t position) {
    if (position > size_ || !in_.seekg(static_cast<std::streamoff>(position))) refuse_damaged();
    at_ = position;
  }
  std::uint64_t at() const { return at_; }
  const std::string& taken(const std::string& bytes) {
    taken_ += bytes;
    return bytes;
  }
  std::string take() { return std::exchange(taken_, {}); }  // what was read since the last time

 private:
  std::istream& in_;
  std::uint64_t size_, at_ = 0;
  std::string taken_;
};

template <class T>
std::string bytes_of(T value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

struct Entry {
  std::string name, type, value, bytes;
};

std::vector<Entry> read_metadata(Reader& reader) {
  const auto count = reader.number<std::uint32_t>();
  if (count > most_entries) refuse_damaged();
  reader.take();
  std::vector<Entry> entries;
  for (std::uint32_t i = 0; i < count; ++i) {
    Entry entry;
    entry.name = reader.text();
    entry.type = reader.text();
    entry.value = reader.bytes(reader.number<std::uint32_t>());
    entry.bytes = reader.take() + entry.value;
    entries.push_back(std::move(entry));
  }
  return entries;
}

struct Descriptor {
  std::string unique_name, type, parent, bytes;
  std::uint64_t begin = 0, end = 0;
  std::string name() const { return unique_name.substr(0, unique_name.find('\x1e')); }  // "name", 1E, number
};

Descriptor read_descriptor(Reader& reader) {
  reader.take();
  Descriptor grid;
  grid.unique_name = reader.text();
  grid.type = reader.text();
  grid.parent = reader.text();
  grid.begin = reader.number<std::uint64_t>();
  reader.number<std::uint64_t>();
  grid.end = reader.number<std::uint64_t>();
  grid.bytes = reader.take();
  if (grid.end < grid.begin || grid.begin < reader.at()) refuse_damaged();
  return grid;
}

// For a message: what is not plain text is left out.
std::string shown(std::string_view name) {
  std::string text;
  for (const char c : name.substr(0, 40))
    if (c >= ' ' && c <= '~') text += c;
  return "'" + text + "'";
}

std::string list_of(const std::vector<Descriptor>& grids) {
  constexpr std::size_t most = 8;
  std::string text;
  for (std::size_t i = 0; i < grids.size() && i < most; ++i) text += (i ? ", " : "") + shown(grids[i].name());
  return text + (grids.size() > most ? ", ..." : "");
}

void check(const Descriptor& grid) {
  std::string type = grid.type;
  if (const auto suffix = type.rfind("_HalfFloat"); suffix != std::string::npos) type.resize(suffix);
  if (type != "Tree_float_5_4_3" && type != "Tree_double_5_4_3")
    throw UnusableFile("holds in its grid " + shown(grid.name()) + " no numbers but " + shown(grid.type) +
                       ": name a grid of floats, such as density");
  if (!grid.parent.empty())
    throw UnusableFile("shares the voxels of its grid " + shown(grid.name()) +
                       " with another one: write it with voxels of its own");
}

Descriptor found(const std::vector<Descriptor>& grids, const std::string& name) {
  for (const Descriptor& grid : grids)
    if (grid.name() == name) return grid;
  if (grids.empty()) throw UnusableFile("is empty: it holds no grid");
  throw UnusableFile("has no grid " + shown(name) + ": it has " + list_of(grids));
}

// Magic number, version, library, offsets, and an identifier.
std::string read_header(Reader& reader) {
  if (reader.number<std::int64_t>() != magic) refuse_damaged();
  const auto file_version = reader.number<std::uint32_t>();
  if (file_version > farthest_version) refuse_damaged();
  if (file_version < oldest_version) throw UnusableFile("was written by an OpenVDB before 3.0: write it anew");
  reader.number<std::uint64_t>();
  if (reader.number<char>() == 0)
    throw UnusableFile("was written as a stream, without a list of its grids: write it as a file");
  return reader.take() + reader.bytes(uuid_bytes);
}

std::vector<Descriptor> read_descriptors(Reader& reader) {
  const auto count = reader.number<std::uint32_t>();
  if (count > most_entries) refuse_damaged();
  std::vector<Descriptor> grids;
  for (std::uint32_t i = 0; i < count; ++i) {
    grids.push_back(read_descriptor(reader));
    reader.go_to(grids.back().end);
  }
  return grids;
}

}  // namespace

OneGrid one_grid(const std::filesystem::path& path, const std::string& name) {
  std::ifstream in(path, std::ios::binary | std::ios::ate);
  if (!in) throw UnusableFile("cannot be opened: give the server the right to read it");
  const auto size = static_cast<std::uint64_t>(in.tellg());
  if (size > max_file_bytes)
    throw UnusableFile("has " + std::to_string(size >> 20) + " MiB: make it smaller than " +
                       std::to_string(max_file_bytes >> 20));
  in.seekg(0);
  Reader reader(in, size);
  const std::string header = read_header(reader);
  read_metadata(reader);
  const Descriptor grid = found(read_descriptors(reader), name);
  check(grid);
  reader.go_to(grid.begin);
  reader.take();
  const std::string compression = bytes_of(reader.number<std::uint32_t>());
  OneGrid one;
  std::string metadata;
  std::uint32_t count = 0;
  for (const Entry& entry : read_metadata(reader)) {
    if (entry.name == "class" && entry.type == "string") one.grid_class = entry.value;
    if (entry.type == "__delayedload") continue;  // of use to a reader that jumps to and fro
    metadata += entry.bytes;
    ++count;
  }
  reader.text();  // the kind of transform
  const std::string transform = reader.take();
  if (grid.end < reader.at()) refuse_damaged();
  one.bytes = header + bytes_of(std::uint32_t{0}) + bytes_of(std::uint32_t{1}) + grid.bytes + compression +
              bytes_of(count) + metadata + transform + reader.bytes(grid.end - reader.at());
  return one;
}

}  // namespace cloudscape::vdb
