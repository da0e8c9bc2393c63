// An OpenEXR file in memory.
#pragma once
#include <OpenEXR/ImfIO.h>

#include <cstdint>
#include <cstring>
#include <vector>

namespace cloudscape::encode {

// The file stands behind `front` bytes. OpenEXR seeks back to fill in its table of line offsets.
class MemoryFile : public Imf::OStream {
 public:
  explicit MemoryFile(std::size_t front) : OStream("memory"), bytes(front), front_(front) {}
  void write(const char data[], int size) override {
    const std::size_t end = front_ + position_ + size;
    if (end > bytes.size()) bytes.resize(end);
    std::memcpy(bytes.data() + front_ + position_, data, size);
    position_ += size;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }
  std::vector<std::uint8_t> bytes;

 private:
  std::size_t front_;
  std::uint64_t position_ = 0;
};

}  // namespace cloudscape::encode
