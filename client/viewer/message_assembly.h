// A WebSocket message put together from its pieces, with a limit that libwebsockets does not have.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace cloudscape::viewer {

class MessageAssembly {
 public:
  // Twice a lossless 3840x2160 picture, far more than any frame of a stream.
  static constexpr std::size_t max_bytes = 64u << 20;

  // false: the message is too long.
  bool append(std::span<const std::uint8_t> piece, bool more) {
    if (piece.size() > max_bytes - bytes_.size()) return false;
    if (bytes_.empty() && more) bytes_.reserve(256 * 1024);
    bytes_.insert(bytes_.end(), piece.begin(), piece.end());
    return true;
  }
  std::vector<std::uint8_t> take() { return std::exchange(bytes_, {}); }

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace cloudscape::viewer
