#include "net/single_file.h"

#include <fstream>

#include "core/error.h"

namespace cloudscape::net {
namespace {

class SingleFile : public FrameContainer {
 public:
  explicit SingleFile(std::filesystem::path path) : path_(std::move(path)), file_(path_, std::ios::binary) {}
  ~SingleFile() override {
    if (finished_) return;
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  void add(const EncodedFrame& image) override {
    file_.write(reinterpret_cast<const char*>(image.bytes.data() + image.front),
                static_cast<std::streamsize>(image.bytes.size() - image.front));
  }
  void finish() override {
    file_.close();
    if (file_.fail()) throw Error("the picture's file could not be written whole");
    finished_ = true;
  }

 private:
  std::filesystem::path path_;
  std::ofstream file_;
  bool finished_ = false;
};

}  // namespace

std::unique_ptr<FrameContainer> open_single_file(const std::filesystem::path& path) {
  return std::make_unique<SingleFile>(path);
}

}  // namespace cloudscape::net
