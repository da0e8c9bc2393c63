// Frames as the files of a ZIP archive, through libarchive.
#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <ctime>
#include <string>

#include "core/error.h"
#include "encode/containers.h"

namespace cloudscape::encode {
namespace {

struct FreeArchive {
  void operator()(archive* written) const { archive_write_free(written); }
};
struct FreeEntry {
  void operator()(archive_entry* entry) const { archive_entry_free(entry); }
};

constexpr std::time_t first_zip_time = 315'532'800;  // 1980-01-01 00:00 UTC (PKWARE APPNOTE 4.4.6)

const char* extension_of(ImageFormat format) {
  constexpr const char* extensions[] = {"jpg", "png", "exr"};
  return extensions[static_cast<std::size_t>(format)];
}

class Zip : public FrameContainer {
 public:
  Zip(const std::filesystem::path& path, const ContainerLayout& layout)
      : path_(path), layout_(layout), next_(layout.first_frame), archive_(archive_write_new()) {
    const int last = layout.first_frame + layout.frames - 1;
    digits_ = std::max<std::size_t>(4, std::to_string(last).size());
    check(archive_ ? archive_write_set_format_zip(archive_.get()) : ARCHIVE_FATAL);
    check(archive_write_set_options(archive_.get(), "zip:compression=store"));
    check(archive_write_set_bytes_in_last_block(archive_.get(), 1));  // no padding at the end
    check(archive_write_open_filename(archive_.get(), path.c_str()));
  }
  ~Zip() override {
    if (finished_) return;
    archive_.reset();  // closes it first: libarchive would not free its buffer after archive_write_fail
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }

  void add(const EncodedFrame& image) override {
    const std::unique_ptr<archive_entry, FreeEntry> entry(archive_entry_new());
    if (!entry) throw Error("There is no memory for a ZIP's entry.");
    const std::size_t bytes = image.bytes.size() - image.front;
    archive_entry_set_pathname(entry.get(), name_of(next_++).c_str());
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(bytes));
    archive_entry_set_mtime(entry.get(), first_zip_time, 0);
    check(archive_write_header(archive_.get(), entry.get()));
    const la_ssize_t written = archive_write_data(archive_.get(), image.bytes.data() + image.front, bytes);
    if (written != static_cast<la_ssize_t>(bytes)) fail();
  }

  void finish() override {
    check(archive_write_close(archive_.get()));
    finished_ = true;
  }

 private:
  std::string name_of(int number) const {
    std::string digits = std::to_string(number);
    digits.insert(0, digits_ - std::min(digits_, digits.size()), '0');
    return "frame_" + digits + "." + extension_of(layout_.format);
  }
  void check(int result) const {
    if (result != ARCHIVE_OK) fail();
  }
  [[noreturn]] void fail() const {
    const char* reason = archive_ ? archive_error_string(archive_.get()) : nullptr;
    throw Error("cannot write " + path_.filename().string() + ": " + (reason ? reason : "the ZIP writer failed"));
  }

  std::filesystem::path path_;
  ContainerLayout layout_;
  int next_;
  std::size_t digits_;
  std::unique_ptr<archive, FreeArchive> archive_;
  bool finished_ = false;
};

}  // namespace

std::unique_ptr<FrameContainer> open_zip(const std::filesystem::path& path, const ContainerLayout& layout) {
  return std::make_unique<Zip>(path, layout);
}

std::unique_ptr<FrameContainer> open_container(const std::filesystem::path& path, const ContainerLayout& layout) {
  return layout.kind == ContainerKind::avi ? open_avi(path, layout) : open_zip(path, layout);
}

}  // namespace cloudscape::encode
