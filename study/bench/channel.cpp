#include "study/bench/channel.h"

#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>

namespace glassbox::study {

Channel::~Channel() {
  ::close(socket_);
}

bool Channel::send(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    bytes = bytes.subspan(std::size_t(sent));
  }
  return true;
}

bool Channel::send_line(const std::string& line) {
  const std::string text = line + "\n";
  return send(std::as_bytes(std::span(text)));
}

bool Channel::receive(std::span<std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t got = ::recv(socket_, bytes.data(), bytes.size(), 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    bytes = bytes.subspan(std::size_t(got));
  }
  return true;
}

// Reads byte by byte, so that nothing after the line is read. Lines are short and few, so this is
// fast enough.
std::optional<std::string> Channel::receive_line() {
  std::string line;
  for (char c = 0; receive(std::as_writable_bytes(std::span(&c, 1)));) {
    if (c == '\n') return line;
    line += c;
  }
  return std::nullopt;
}

}  // namespace glassbox::study
