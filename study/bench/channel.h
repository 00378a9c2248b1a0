// Sends lines and bytes between two processes.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace glassbox::study {

// One end of a connected pair of sockets, which this object owns. The functions return false or
// nothing after the process at the other end has closed its socket.
class Channel {
public:
  explicit Channel(int socket) : socket_(socket) {}
  ~Channel();
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;

  bool send(std::span<const std::byte> bytes);
  bool send_line(const std::string& line);
  bool receive(std::span<std::byte> bytes);
  std::optional<std::string> receive_line();

private:
  int socket_;
};

}  // namespace glassbox::study
