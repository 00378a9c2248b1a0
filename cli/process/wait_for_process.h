// Follows a child process to its end and reads its output as it comes.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <limits>
#include <span>
#include <string>

namespace glassbox {

class Descriptor {
public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return number_; }
  // Takes over a descriptor and moves it to a number above those that a child process uses, so that
  // it is not overwritten before the child gets it.
  void set(int number);
  void close();

private:
  int number_;
};

// Both ends of the pipe are closed when a child process starts another program. Reading does not
// block.
struct Pipe {
  Descriptor read, write;
  Pipe();
  bool valid() const { return read.get() >= 0 && write.get() >= 0; }
};

// One stream of a process's output.
struct Stream {
  const Pipe* from;
  std::size_t kept;  // how many bytes of the output are kept
  std::size_t allowed = std::numeric_limits<std::size_t>::max();
  std::string text{};
  std::size_t received = 0;

  bool exceeds_limit() const { return received > allowed; }
};

struct WaitResult {
  bool ended = false;  // by itself, within its time
  int status = 0;      // the exit status that waitpid gives
  double seconds = 0;
};

// Follows the process until it ends, its time is up or it writes more than is allowed. Then kills
// it together with the process group that it leads, so that nothing it started goes on running.
WaitResult wait_for_process(pid_t process, std::span<Stream> streams, double seconds);

}  // namespace glassbox
