// Pixel buffers with fences, and timestamp queries.
#include "gpu/readback.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/error.h"
#include "gpu/format.h"

namespace cloudscape::gpu {
namespace {

bool is_signalled(GLenum state) { return state == GL_ALREADY_SIGNALED || state == GL_CONDITION_SATISFIED; }

GLenum wait_for(void* fence, GLuint64 timeout_ns) {
  return glClientWaitSync(static_cast<GLsync>(fence), GL_SYNC_FLUSH_COMMANDS_BIT, timeout_ns);
}

constexpr std::size_t most_free = 6;  // tuned: streams of a few sizes, some frames of each on their way

GLuint new_buffer(std::size_t bytes) {
  GLuint buffer = 0;
  glCreateBuffers(1, &buffer);
  label_object(GL_BUFFER, buffer, "readback");
  // CLIENT_STORAGE asks for memory that the processor reads fast: it is written once and read once.
  glNamedBufferStorage(buffer, static_cast<GLsizeiptr>(bytes), nullptr, GL_MAP_READ_BIT | GL_CLIENT_STORAGE_BIT);
  return buffer;
}

}  // namespace

ReadbackBuffers::~ReadbackBuffers() {
  for (const Free& each : free_) glDeleteBuffers(1, &each.buffer);
}

unsigned ReadbackBuffers::take(std::size_t bytes) {
  const auto found = std::ranges::find(free_, bytes, &Free::bytes);
  if (found == free_.end()) return new_buffer(bytes);
  const unsigned buffer = found->buffer;
  free_.erase(found);
  return buffer;
}

void ReadbackBuffers::give_back(unsigned buffer, std::size_t bytes) {
  if (buffer == 0) return;
  free_.push_back({buffer, bytes});
  if (free_.size() <= most_free) return;
  glDeleteBuffers(1, &free_.front().buffer);
  free_.erase(free_.begin());
}

Readback::Readback(const Texture& texture, std::shared_ptr<ReadbackBuffers> buffers)
    : buffers_(std::move(buffers)), bytes_(texture.bytes()) {
  const FormatRow& row = row_of(texture.format());
  buffer_ = buffers_ ? buffers_->take(bytes_) : new_buffer(bytes_);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_);
  glGetTextureImage(texture.id(), 0, row.components, row.type, static_cast<GLsizei>(bytes_), nullptr);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  glFlush();
}

Readback::~Readback() {
  glDeleteSync(static_cast<GLsync>(fence_));
  if (buffers_)
    buffers_->give_back(buffer_, bytes_);
  else
    glDeleteBuffers(1, &buffer_);
}

Readback::Readback(Readback&& other) noexcept { *this = std::move(other); }

Readback& Readback::operator=(Readback&& other) noexcept {
  std::swap(buffers_, other.buffers_);
  std::swap(buffer_, other.buffer_);
  std::swap(fence_, other.fence_);
  std::swap(bytes_, other.bytes_);
  return *this;
}

// A lost device counts as ready, so that who polls goes on to take() and hears of it.
bool Readback::ready() const { return fence_ != nullptr && wait_for(fence_, 0) != GL_TIMEOUT_EXPIRED; }

std::vector<std::uint8_t> Readback::take() {
  if (fence_ == nullptr) throw Error("this readback holds no texels: it was taken before, or never started");
  Readback taken = std::move(*this);  // released here, whatever happens below
  GLenum state = GL_TIMEOUT_EXPIRED;
  while (state == GL_TIMEOUT_EXPIRED) state = wait_for(taken.fence_, 1'000'000'000);
  std::vector<std::uint8_t> texels(taken.bytes_);
  const auto size = static_cast<GLsizeiptr>(taken.bytes_);
  const void* mapped = is_signalled(state) ? glMapNamedBufferRange(taken.buffer_, 0, size, GL_MAP_READ_BIT) : nullptr;
  if (mapped == nullptr) throw Error("the device did not finish a readback: it was lost, or is out of memory");
  std::memcpy(texels.data(), mapped, texels.size());
  glUnmapNamedBuffer(taken.buffer_);
  return texels;
}

Timer::Timer() { glCreateQueries(GL_TIMESTAMP, static_cast<GLsizei>(queries_.size()), queries_.data()); }

Timer::~Timer() { glDeleteQueries(static_cast<GLsizei>(queries_.size()), queries_.data()); }

Timer::Timer(Timer&& other) noexcept : queries_(std::exchange(other.queries_, {})), stopped_(other.stopped_) {}

Timer& Timer::operator=(Timer&& other) noexcept {
  std::swap(queries_, other.queries_);
  std::swap(stopped_, other.stopped_);
  return *this;
}

void Timer::start() {
  stopped_ = false;
  glQueryCounter(queries_[0], GL_TIMESTAMP);
}

void Timer::stop() {
  glQueryCounter(queries_[1], GL_TIMESTAMP);
  stopped_ = true;
}

double Timer::milliseconds() const {
  if (!stopped_) return 0.0;
  std::array<GLuint64, 2> time_ns{};
  for (std::size_t i = 0; i < queries_.size(); ++i) glGetQueryObjectui64v(queries_[i], GL_QUERY_RESULT, &time_ns[i]);
  return static_cast<double>(time_ns[1] - time_ns[0]) * 1e-6;
}

}  // namespace cloudscape::gpu
