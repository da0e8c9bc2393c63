// Getting results and times back without stalling the device.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "gpu/texture.h"

namespace cloudscape::gpu {

// Pixel buffers that are used again: a driver takes longer to make one than to fill it.
class ReadbackBuffers {
 public:
  ReadbackBuffers() = default;
  ~ReadbackBuffers();
  ReadbackBuffers(const ReadbackBuffers&) = delete;
  ReadbackBuffers& operator=(const ReadbackBuffers&) = delete;
  unsigned take(std::size_t bytes);
  void give_back(unsigned buffer, std::size_t bytes);

 private:
  struct Free {
    unsigned buffer;
    std::size_t bytes;
  };
  std::vector<Free> free_;  // the longest unused first
};

// Texels on their way to memory: a pixel buffer and a fence.
class Readback {
 public:
  Readback() = default;
  // Starts the copy of the whole texture, in its own format. Without `buffers` it makes a buffer of its own.
  explicit Readback(const Texture& texture, std::shared_ptr<ReadbackBuffers> buffers = nullptr);
  ~Readback();
  Readback(Readback&& other) noexcept;
  Readback& operator=(Readback&& other) noexcept;
  bool ready() const;
  std::vector<std::uint8_t> take();  // waits if need be; once
  explicit operator bool() const { return buffer_ != 0; }

 private:
  std::shared_ptr<ReadbackBuffers> buffers_;
  unsigned buffer_ = 0;
  void* fence_ = nullptr;
  std::size_t bytes_ = 0;
};

// GPU time between start and stop, by two timestamps, so that timers may nest.
class Timer {
 public:
  Timer();
  ~Timer();
  Timer(Timer&& other) noexcept;
  Timer& operator=(Timer&& other) noexcept;
  void start();
  void stop();
  double milliseconds() const;  // waits for the result; 0 if it was never stopped

 private:
  std::array<unsigned, 2> queries_{};
  bool stopped_ = false;
};

}  // namespace cloudscape::gpu
