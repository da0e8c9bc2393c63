// A stream server in the test's own process: it does what the test tells it, over a real socket.
#pragma once
#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "wire/messages.h"

struct lws;
struct lws_context;

namespace cloudscape::viewer {

// `script` answers each message of the client. One client at a time.
class FakeServer {
 public:
  using Script = std::function<void(FakeServer&, const wire::ClientMessage&)>;
  explicit FakeServer(Script script, std::string token = "");  // with a token, others are answered 401
  ~FakeServer();

  std::string url() const { return "ws://127.0.0.1:" + std::to_string(port_); }

  // From the script.
  void send(const wire::ServerMessage& message);
  void send_frame(std::uint32_t frame_id, std::uint64_t pose_sequence, ImageSize size_px = {32, 16},
                  bool broken = false);
  void hang_up() { hang_up_ = true; }

  // From the test: waits up to 10 s for messages of the client that satisfy the test.
  bool wait(const std::function<bool(const std::vector<wire::ClientMessage>&)>& enough);
  template <class T>
  std::vector<T> received() {
    const std::lock_guard lock(mutex_);
    std::vector<T> found;
    for (const auto& message : messages_)
      if (const T* value = std::get_if<T>(&message)) found.push_back(*value);
    return found;
  }

 private:
  static int on_event(lws* wsi, int reason, void*, void* in, std::size_t length);
  int handle(lws* wsi, int reason, const char* in, std::size_t length);
  int confirm(lws* wsi);
  int receive(lws* wsi, std::string text);
  int write(lws* wsi);

  struct Outgoing {
    bool binary;
    std::vector<std::uint8_t> bytes;
  };
  Script script_;
  std::string token_;
  lws_context* context_ = nullptr;
  int port_ = 0;
  std::atomic<bool> stopping_ = false;
  bool hang_up_ = false;
  std::deque<Outgoing> outgoing_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<wire::ClientMessage> messages_;
  std::thread thread_;
};

}  // namespace cloudscape::viewer
