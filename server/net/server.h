// The network face: HTTP API, web page and streams over libwebsockets, all on the thread that calls run().
#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "core/embedded.h"
#include "core/frame.h"
#include "core/frame_container.h"
#include "core/metrics.h"
#include "settings/cloudscape_json.h"
#include "settings/server_settings.h"
#include "stream/frame_scheduler.h"

namespace cloudscape::net {

// What the server tells of its renderer; set once by the render thread through Server::set_ready.
struct RendererInfo {
  std::string renderer, vendor, gl_version, pass_execution;
  bool software = false;
};

// What writes the results of jobs; without it no job is taken.
struct JobParts {
  // Hands a task to a thread that does one after the other.
  std::function<void(std::function<void()>)> run_on_disk_thread;
  std::function<std::unique_ptr<FrameContainer>(const std::filesystem::path&, const ContainerLayout&)> open_container;
};

// The server's parts that live elsewhere; all must outlive it.
struct Parts {
  settings::ServerSettings settings;
  stream::FrameScheduler& scheduler;
  settings::CloudscapeLibrary& cloudscapes;
  Metrics& metrics;
  EmbeddedFiles page;  // index.html and what it loads
  JobParts jobs = {};
  EmbeddedFiles pictures = {};  // of the gallery: NAME.jpg, of the still of that name
};

class Server {
 public:
  explicit Server(Parts parts);  // binds; throws Error in one sentence (port in use, bad token file, ...)
  ~Server();
  int port() const;
  std::string ready_link() const;  // http://HOST:PORT/ with #token=... where one was made
  // Serves until request_stop(); then closes sockets with 1001, drains for at most drain_s and returns.
  void run();

  // From any thread.
  void request_stop();
  void set_ready(RendererInfo info);  // /readyz answers 200 from now on
  // A stream's frame, front == frame_front() bytes free: the newest one waits for the socket, an older one is dropped
  // and counted.
  void deliver_frame(const stream::Work& work, const FrameTimings& timings, EncodedFrame frame);
  void deliver_still(StreamId still, EncodedFrame image);
  // How far a path-traced still is: 0..1 of its work, and the samples that each pixel has.
  void tell_samples(StreamId still, double share, int samples);
  // `status`: of HTTP, for whoever waits for a still.
  void fail(StreamId stream_or_still, const std::string& message, int status = 500);
  static std::size_t frame_front();  // LWS_PRE + wire::frame_header_bytes

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cloudscape::net
