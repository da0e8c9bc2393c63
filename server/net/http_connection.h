// One HTTP connection on libwebsockets: reads a request and its body, waits for the answer, writes it; then the next.
//
// Each on_... returns what the callback has to return: -1 closes the connection.
#pragma once
#include <span>
#include <string>

#include "net/front_door.h"

struct lws;

namespace cloudscape::net {

class HttpConnection {
 public:
  HttpConnection(Site& site, const Router& router, lws* wsi) : site_(site), router_(router), wsi_(wsi) {}
  ~HttpConnection();
  HttpConnection(const HttpConnection&) = delete;

  int on_request();
  int on_body(std::string_view bytes);
  int on_body_complete();
  int on_writable();
  int on_timer();
  int on_upgrade();                 // 0: the stream may be opened
  void on_answer(Response answer);  // to the waiter below
  std::uint64_t waiter() const { return stage_ == Stage::waiting ? waiter_ : 0; }
  bool answering() const { return stage_ != Stage::idle && stage_ != Stage::lingering; }

 private:
  enum class Stage { idle, body, waiting, writing, lingering };
  enum class Input { none, more, ended };
  int read_body();
  int ask();
  void wait(std::uint64_t waiter);
  int respond(Response response);
  std::size_t copy_chunk(std::span<char> room) const;
  int finish();
  int linger();
  int on_waiting_timer(bool late);
  Input pending_input() const;  // in the socket
  void set_deadline(double s);
  bool send_now(std::string_view text) const;

  Site& site_;
  const Router& router_;
  lws* wsi_;
  Stage stage_ = Stage::idle;
  Request request_;
  bool body_unread_ = false;  // the answer comes before the whole body has
  std::uint64_t waiter_ = 0;
  Response response_;
  std::string head_;
  std::size_t sent_ = 0, size_ = 0;  // of head and body together
  Instant deadline_{};
};

}  // namespace cloudscape::net
