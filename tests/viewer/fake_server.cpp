// The test's server, on libwebsockets.
#include "fake_server.h"

#include <libwebsockets.h>
#include <turbojpeg.h>

#include <chrono>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace cloudscape::viewer {
namespace {

// A grey picture whose level is the frame's id.
std::vector<std::uint8_t> grey_jpeg(ImageSize size_px, std::uint32_t frame_id) {
  const std::vector<unsigned char> grey(std::size_t{1} * size_px.width * size_px.height,
                                        static_cast<unsigned char>(frame_id));
  unsigned char* image = nullptr;
  unsigned long size = 0;
  tjhandle compressor = tjInitCompress();
  tjCompress2(compressor, grey.data(), size_px.width, 0, size_px.height, TJPF_GRAY, &image, &size, TJSAMP_GRAY, 95, 0);
  std::vector<std::uint8_t> bytes(image, image + size);
  tjFree(image);
  tjDestroy(compressor);
  return bytes;
}

}  // namespace

FakeServer::FakeServer(Script script, std::string token) : script_(std::move(script)), token_(std::move(token)) {
  static const lws_protocols protocols[] = {{"cloudscape.v1",
                                             [](lws* wsi, lws_callback_reasons reason, void* user, void* in,
                                                std::size_t length) { return on_event(wsi, reason, user, in, length); },
                                             0, 65536, 0, nullptr, 0},
                                            {}};
  lws_set_log_level(0, nullptr);
  lws_context_creation_info info{};
  info.port = 0;
  info.iface = "127.0.0.1";
  info.protocols = protocols;
  info.user = this;
  info.vhost_name = "test";
  context_ = lws_create_context(&info);
  if (!context_) throw std::runtime_error("the test's server did not start");
  port_ = lws_get_vhost_listen_port(lws_get_vhost_by_name(context_, "test"));
  thread_ = std::thread([this] {
    while (!stopping_) lws_service(context_, 0);
  });
}

FakeServer::~FakeServer() {
  stopping_ = true;
  lws_cancel_service(context_);
  thread_.join();
  lws_context_destroy(context_);
}

void FakeServer::send(const wire::ServerMessage& message) {
  const std::string text = wire::to_text(message);
  outgoing_.push_back({false, {text.begin(), text.end()}});
}

void FakeServer::send_frame(std::uint32_t frame_id, std::uint64_t pose_sequence, ImageSize size_px, bool broken) {
  std::vector<std::uint8_t> image = grey_jpeg(size_px, frame_id);
  if (broken) image.resize(image.size() / 2);
  wire::FrameHeader header;
  header.frame_id = frame_id;
  header.pose_sequence = pose_sequence;
  header.width_px = static_cast<std::uint16_t>(size_px.width);
  header.height_px = static_cast<std::uint16_t>(size_px.height);
  header.image_bytes = static_cast<std::uint32_t>(image.size());
  std::vector<std::uint8_t> bytes(wire::frame_header_bytes);
  wire::write(header, std::span<std::uint8_t, wire::frame_header_bytes>(bytes));
  bytes.insert(bytes.end(), image.begin(), image.end());
  outgoing_.push_back({true, std::move(bytes)});
}

bool FakeServer::wait(const std::function<bool(const std::vector<wire::ClientMessage>&)>& enough) {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, std::chrono::seconds(10), [&] { return enough(messages_); });
}

int FakeServer::on_event(lws* wsi, int reason, void*, void* in, std::size_t length) {
  auto* server = static_cast<FakeServer*>(lws_context_user(lws_get_context(wsi)));
  return server ? server->handle(wsi, reason, static_cast<const char*>(in), length) : 0;
}

int FakeServer::handle(lws* wsi, int reason, const char* in, std::size_t length) {
  switch (reason) {
    case LWS_CALLBACK_HTTP_CONFIRM_UPGRADE:
      return confirm(wsi);
    case LWS_CALLBACK_RECEIVE:
      return receive(wsi, std::string(in, length));
    case LWS_CALLBACK_SERVER_WRITEABLE:
      return write(wsi);
    default:
      return 0;
  }
}

int FakeServer::confirm(lws* wsi) {
  char authorization[128] = "";
  lws_hdr_copy(wsi, authorization, sizeof authorization, WSI_TOKEN_HTTP_AUTHORIZATION);
  if (token_.empty() || authorization == "Bearer " + token_) return 0;
  lws_return_http_status(wsi, 401, nullptr);
  return 1;
}

int FakeServer::receive(lws* wsi, std::string text) {
  const wire::ClientMessage message = wire::parse_client_message(text);
  if (std::holds_alternative<wire::Hello>(message)) outgoing_.clear();
  {
    const std::lock_guard lock(mutex_);
    messages_.push_back(message);
  }
  script_(*this, message);
  changed_.notify_all();
  if (std::exchange(hang_up_, false)) return -1;
  lws_callback_on_writable(wsi);
  return 0;
}

int FakeServer::write(lws* wsi) {
  if (outgoing_.empty()) return 0;
  const Outgoing next = std::move(outgoing_.front());
  outgoing_.pop_front();
  std::vector<unsigned char> buffer(LWS_PRE + next.bytes.size());
  std::memcpy(buffer.data() + LWS_PRE, next.bytes.data(), next.bytes.size());
  lws_write(wsi, buffer.data() + LWS_PRE, next.bytes.size(), next.binary ? LWS_WRITE_BINARY : LWS_WRITE_TEXT);
  lws_callback_on_writable(wsi);
  return 0;
}

}  // namespace cloudscape::viewer
