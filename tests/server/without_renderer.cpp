// A server without a renderer, small enough for valgrind: what comes over the sockets is real, pictures never come.
#include <csignal>
#include <cstdio>
#include <thread>

#include "core/log.h"
#include "net/server.h"

int main() {
  using namespace cloudscape;
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  log::start("warn");
  settings::ServerSettings settings;
  settings.listen = "127.0.0.1:0";
  Metrics metrics;
  settings::CloudscapeLibrary library("");
  stream::FrameScheduler scheduler({}, metrics);
  net::Server server({settings, scheduler, library, metrics, {}});
  std::thread stop([&] {
    int signal = 0;
    sigwait(&signals, &signal);
    server.request_stop();
  });
  server.set_ready({"none", "none", "none", "none", true});
  std::printf("ready: %s\n", server.ready_link().c_str());
  std::fflush(stdout);
  server.run();
  stop.join();
}
