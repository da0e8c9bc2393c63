// `cloudscape healthcheck`: asks the server of this machine whether it lives; for containers, which have no curl.
#include <netdb.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "app/commands.h"

namespace cloudscape::app {
namespace {

std::string default_port() {
  const char* listen = std::getenv("CLOUDSCAPE_LISTEN");
  const std::string text = listen ? listen : "";
  const std::size_t colon = text.rfind(':');
  return colon == std::string::npos ? "8080" : text.substr(colon + 1);
}

class Socket {
 public:
  explicit Socket(const std::string& port) {
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_flags = AI_NUMERICHOST;
    addrinfo* found = nullptr;
    if (getaddrinfo("127.0.0.1", port.c_str(), &hints, &found) != 0) return;
    fd_ = socket(found->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const timeval limit{2, 0};
    setsockopt(fd_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
    setsockopt(fd_, SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof limit);
    connected_ = fd_ >= 0 && connect(fd_, found->ai_addr, found->ai_addrlen) == 0;
    freeaddrinfo(found);
  }
  ~Socket() {
    if (fd_ >= 0) close(fd_);
  }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  // The first line of the answer, or "".
  std::string ask(const std::string& request) const {
    if (!connected_ || send(fd_, request.data(), request.size(), MSG_NOSIGNAL) < 0) return "";
    char answer[64] = {};
    const ssize_t size = recv(fd_, answer, sizeof answer - 1, MSG_WAITALL);
    return size > 0 ? std::string(answer, static_cast<std::size_t>(size)) : "";
  }

 private:
  int fd_ = -1;
  bool connected_ = false;
};

int check(const std::string& port) {
  const std::string answer = Socket(port).ask("GET /healthz HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n");
  if (answer.starts_with("HTTP/1.1 200") || answer.starts_with("HTTP/1.0 200")) return 0;
  std::fprintf(stderr, "cloudscape: the server on port %s does not answer /healthz with 200\n", port.c_str());
  return 1;
}

}  // namespace

void add_healthcheck(CLI::App& program, Run& run) {
  auto port = std::make_shared<std::string>(default_port());
  CLI::App* command = program.add_subcommand("healthcheck", "Ask the server on this machine whether it lives");
  command->add_option("--port", *port, "Its port (default: that of CLOUDSCAPE_LISTEN, else 8080)");
  command->callback([port, &run] { run = [port] { return check(*port); }; });
}

}  // namespace cloudscape::app
