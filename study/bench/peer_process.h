// A peer in a process of its own, which draws when it is told to. Mesa reads its number of threads once in a process, and
// its threads and memory are kept out of ours.
#pragma once

#include <sys/types.h>

#include <memory>
#include <string>
#include <vector>

#include <glassbox/base/error.h>

#include "study/bench/channel.h"
#include "study/scenes/picture_match.h"
#include "study/scenes/scenes.h"

namespace glassbox::study {

struct PeerCommand {
  std::string program;             // that calls serve_mesa
  std::vector<std::string> words;  // its arguments
  int threads = 1;
};

class PeerProcess {
public:
  // An error if the peer cannot draw, in its own words.
  static Result<std::unique_ptr<PeerProcess>> start(const PeerCommand& command);
  // Ends it.
  ~PeerProcess();
  PeerProcess(const PeerProcess&) = delete;
  PeerProcess& operator=(const PeerProcess&) = delete;

  const std::string& description() const { return description_; }
  // Draws so many frames; milliseconds of each.
  Result<std::vector<double>> frames(int count);
  // What the last frame drew.
  Result<Picture> picture(int width, int height);

private:
  PeerProcess(pid_t child, int socket)
      : child_(child), channel_(std::make_unique<Channel>(socket)) {}

  pid_t child_;
  std::unique_ptr<Channel> channel_;
  std::string description_;
};

// The other side: draws the scene with Mesa as the program that holds the other end of standard input asks, until it goes.
// False if Mesa cannot.
bool serve_mesa(const BenchScene& bench);

}  // namespace glassbox::study
