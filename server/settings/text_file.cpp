// Small text files over POSIX calls, because the standard library cannot flush to the disk.
#include "settings/text_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "core/error.h"

namespace cloudscape::settings {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& what, const fs::path& file) {
  throw Error(what + " " + file.string() + ": " + std::strerror(errno));
}

// An open file descriptor.
class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags) : path_(path), number_(::open(path.c_str(), flags | O_CLOEXEC, 0644)) {
    if (number_ < 0) fail("cannot open", path_);
  }
  ~Descriptor() { ::close(number_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  void write(std::string_view text) {
    while (!text.empty()) {
      const ssize_t written = ::write(number_, text.data(), text.size());
      if (written < 0 && errno != EINTR) fail("cannot write", path_);
      if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
    }
  }
  void flush() {
    if (::fsync(number_) != 0) fail("cannot flush", path_);
  }

 private:
  fs::path path_;
  int number_;
};

fs::path partial_of(const fs::path& file) { return file.parent_path() / ("." + file.filename().string() + ".partial"); }

}  // namespace

std::string read_text_file(const fs::path& file, std::size_t max_bytes) {
  std::error_code error;
  if (fs::is_directory(file, error)) throw Error("cannot read " + file.string() + ": it is a folder");
  std::ifstream in(file, std::ios::binary);
  if (!in) fail("cannot read", file);
  std::string text(max_bytes + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() > max_bytes)
    throw Error(file.string() + " is too long: at most " + std::to_string(max_bytes / 1024) + " KiB");
  return text;
}

void write_text_file(const fs::path& file, std::string_view text) {
  const fs::path partial = partial_of(file);
  try {
    Descriptor out(partial, O_WRONLY | O_CREAT | O_TRUNC);
    out.write(text);
    out.flush();
    if (::rename(partial.c_str(), file.c_str()) != 0) fail("cannot rename to", file);
  } catch (const Error&) {
    ::unlink(partial.c_str());
    throw;
  }
  Descriptor(file.has_parent_path() ? file.parent_path() : ".", O_RDONLY | O_DIRECTORY).flush();
}

void write_whole_file(const fs::path& file, std::span<const std::uint8_t> bytes) {
  write_text_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

void check_writable(const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) throw Error("cannot write " + file.string() + ": it is a folder");
  const fs::path partial = partial_of(file);
  const int number = ::open(partial.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
  if (number < 0) throw Error("cannot write " + file.string() + ": " + std::strerror(errno));
  ::close(number);
  ::unlink(partial.c_str());
}

}  // namespace cloudscape::settings
