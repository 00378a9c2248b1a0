// Runs a peer in its own process, which draws on request. Mesa reads its number of threads only
// once in a process; a separate process also keeps its threads and its memory apart from ours.
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
  std::string program;             // must call serve_mesa
  std::vector<std::string> words;  // its arguments
  int threads = 1;
};

class PeerProcess {
public:
  // Returns an error, in the peer's own words, if the peer cannot draw.
  static Result<std::unique_ptr<PeerProcess>> start(const PeerCommand& command);
  // Ends the process.
  ~PeerProcess();
  PeerProcess(const PeerProcess&) = delete;
  PeerProcess& operator=(const PeerProcess&) = delete;

  const std::string& description() const { return description_; }
  // Draws this many frames; returns the milliseconds of each.
  Result<std::vector<double>> frames(int count);
  // The picture of the last frame.
  Result<Picture> picture(int width, int height);

private:
  PeerProcess(pid_t child, int socket)
      : child_(child), channel_(std::make_unique<Channel>(socket)) {}

  pid_t child_;
  std::unique_ptr<Channel> channel_;
  std::string description_;
};

// The function for the child process: draws the scene with Mesa whenever the program at the other
// end of standard input asks for it, until that program closes it. Returns false if Mesa cannot
// draw the scene.
bool serve_mesa(const BenchScene& bench);

}  // namespace glassbox::study
