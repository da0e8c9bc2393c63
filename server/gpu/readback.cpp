// Pixel buffers with fences, and timestamp queries.
#include "gpu/readback.h"

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

}  // namespace

Readback::Readback(const Texture& texture) : bytes_(texture.bytes()) {
  const FormatRow& row = row_of(texture.format());
  glCreateBuffers(1, &buffer_);
  label_object(GL_BUFFER, buffer_, "readback");
  // CLIENT_STORAGE asks for memory that the processor reads fast: it is written once and read once.
  glNamedBufferStorage(buffer_, static_cast<GLsizeiptr>(bytes_), nullptr, GL_MAP_READ_BIT | GL_CLIENT_STORAGE_BIT);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_);
  glGetTextureImage(texture.id(), 0, row.components, row.type, static_cast<GLsizei>(bytes_), nullptr);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  glFlush();
}

Readback::~Readback() {
  glDeleteSync(static_cast<GLsync>(fence_));
  glDeleteBuffers(1, &buffer_);
}

Readback::Readback(Readback&& other) noexcept { *this = std::move(other); }

Readback& Readback::operator=(Readback&& other) noexcept {
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
