#include "net/server.h"

#include <libwebsockets.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "core/log.h"
#include "net/callbacks.h"
#include "net/lws_log.h"
#include "net/mailbox.h"
#include "net/open_files.h"
#include "net/problem.h"

namespace cloudscape::net {
namespace {

unsigned whole_seconds(double s) { return static_cast<unsigned>(std::max(1.0, std::ceil(s))); }

}  // namespace

struct Server::State {
  explicit State(const Parts& parts);
  ~State() {
    site.jobs.close();  // its news need the mailbox
    close();
  }

  void open();
  void close();
  void wake();
  void read_mail();
  void serve();
  void drain();

  void read(RendererInfo& info) { site.renderer = std::move(info); }
  void read(FrameArrived& mail);
  void read(StillArrived& mail);
  void read(JobNews& news) { site.jobs.read(news); }
  void read(RenderFailed& mail);
  void read(SamplesTaken& mail) { site.jobs.note_samples(mail.still, mail.share, mail.samples); }
  StreamSession* session(StreamId stream);

  Site site;
  Connections connections{site};
  lws_retry_bo_t idle{};
  Mailbox mailbox;
  std::atomic<bool> stopping = false;
  std::mutex context_mutex;  // between wake() of any thread and close()
  lws_context* context = nullptr;
  lws_vhost* vhost = nullptr;
};

Server::State::State(const Parts& parts) : site(parts) {
  check_free(site.endpoint);
  connections.open_files_limit = bound_open_files();
  connections.on_mail = [this] { read_mail(); };
  site.stills.on_ready([this](std::uint64_t waiter, Response response) {
    if (HttpConnection* connection = connections.waiter(waiter)) connection->on_answer(std::move(response));
  });
  site.jobs.on_news([this](JobNews news) {
    mailbox.put(std::move(news));
    wake();
  });
  open();
}

void Server::State::open() {
  redirect_lws_log();
  const auto& settings = site.parts.settings;
  idle.secs_since_valid_ping = static_cast<std::uint16_t>(whole_seconds(settings.idle_ping_s));
  idle.secs_since_valid_hangup = static_cast<std::uint16_t>(
      std::max(whole_seconds(settings.idle_hangup_s), whole_seconds(settings.idle_ping_s) + 1));
  lws_context_creation_info info{};
  info.port = site.endpoint.port;
  info.iface = site.endpoint.any ? nullptr : site.endpoint.address.c_str();
  info.protocols = protocols();
  info.options = LWS_SERVER_OPTION_EXPLICIT_VHOSTS | LWS_SERVER_OPTION_VALIDATE_UTF8 |
                 LWS_SERVER_OPTION_FAIL_UPON_UNABLE_TO_BIND |
                 (site.endpoint.ipv6 ? 0U : LWS_SERVER_OPTION_DISABLE_IPV6);
  info.user = &connections;
  info.retry_and_idle_policy = &idle;
  info.max_http_header_data = 8192;
  info.timeout_secs_ah_idle = whole_seconds(settings.header_timeout_s);
  // Ours come first (http_connection.h); this one catches what they do not see.
  info.timeout_secs = whole_seconds(settings.body_timeout_s) + 1;
  info.keepalive_timeout = 15;  // tuned: longer than most clients' pause between two stills
  info.vhost_name = "cloudscape";
  context = lws_create_context(&info);
  if (context) vhost = lws_create_vhost(context, &info);
  if (!vhost) {
    close();
    throw Error("Cannot listen on " + settings.listen + "; the log says more.");
  }
}

void Server::State::close() {
  const std::lock_guard lock(context_mutex);
  if (context) lws_context_destroy(std::exchange(context, nullptr));
}

void Server::State::wake() {
  const std::lock_guard lock(context_mutex);
  if (context) lws_cancel_service(context);
}

void Server::State::read_mail() {
  for (Mail& mail : mailbox.take_all()) std::visit([this](auto& content) { read(content); }, mail);
}

StreamSession* Server::State::session(StreamId stream) {
  const auto found = std::ranges::find_if(site.sessions, [&](const auto* each) { return each->stream() == stream; });
  return found == site.sessions.end() ? nullptr : *found;
}

void Server::State::read(FrameArrived& mail) {
  if (StreamSession* viewer = session(mail.work.request.stream))
    viewer->offer(mail.work, mail.timings, std::move(mail.frame));
}

void Server::State::read(StillArrived& mail) {
  if (site.jobs.owns(mail.still))
    site.jobs.deliver(mail.still, std::move(mail.image));
  else
    site.stills.deliver(mail.still, std::move(mail.image));
}

void Server::State::read(RenderFailed& mail) {
  if (StreamSession* viewer = session(mail.stream_or_still)) return viewer->fail(mail.message);
  site.stills.fail(mail.stream_or_still, mail.message, mail.status);
  site.jobs.fail(mail.stream_or_still, mail.message);
}

void Server::State::serve() {
  struct Timer {
    lws_sorted_usec_list_t list{};
    State* state = nullptr;
    static void look(lws_sorted_usec_list_t* list) {
      auto* timer = reinterpret_cast<Timer*>(list);
      timer->state->site.jobs.forget_expired();
      lws_sul_schedule(timer->state->context, 0, &timer->list, look, LWS_USEC_PER_SEC);
    }
  } expiry{{}, this};
  Timer::look(&expiry.list);
  while (!stopping) lws_service(context, 0);
  lws_sul_cancel(&expiry.list);
}

// libwebsockets would end the connections without a close frame. So viewers are told first, stills finish, and only
// then, or when the time is over, the context goes.
void Server::State::drain() {
  site.draining = true;
  site.jobs.stop();
  for (StreamSession* viewer : site.sessions) viewer->drain();
  struct Timer {
    lws_sorted_usec_list_t list{};
    bool over = false;
  } timer;
  lws_sul_schedule(
      context, 0, &timer.list, [](lws_sorted_usec_list_t* list) { reinterpret_cast<Timer*>(list)->over = true; },
      std::max<lws_usec_t>(1, static_cast<lws_usec_t>(site.parts.settings.drain_s * LWS_USEC_PER_SEC)));
  while (connections.busy() && !timer.over) lws_service(context, 0);
  lws_sul_cancel(&timer.list);
}

Server::Server(Parts parts) : state_(std::make_unique<State>(parts)) {}
Server::~Server() = default;

int Server::port() const { return lws_get_vhost_listen_port(state_->vhost); }

std::string Server::ready_link() const {
  const Token& token = state_->site.authorization.token();
  return local_url(state_->site.endpoint, port()) + (token.made ? "#token=" + token.text : "");
}

void Server::run() {
  state_->serve();
  state_->drain();
  state_->close();
}

void Server::request_stop() {
  state_->stopping = true;
  state_->wake();
}

void Server::set_ready(RendererInfo info) {
  state_->mailbox.put(std::move(info));
  state_->wake();
}

void Server::deliver_frame(const stream::Work& work, const FrameTimings& timings, EncodedFrame frame) {
  state_->mailbox.put(FrameArrived{work, timings, std::move(frame)});
  state_->wake();
}

void Server::deliver_still(StreamId still, EncodedFrame image) {
  state_->mailbox.put(StillArrived{still, std::move(image)});
  state_->wake();
}

void Server::tell_samples(StreamId still, double share, int samples) {
  state_->mailbox.put(SamplesTaken{still, share, samples});
  state_->wake();
}

void Server::fail(StreamId stream_or_still, const std::string& message, int status) {
  state_->mailbox.put(RenderFailed{stream_or_still, message, status});
  state_->wake();
}

std::size_t Server::frame_front() { return LWS_PRE + wire::frame_header_bytes; }

}  // namespace cloudscape::net
