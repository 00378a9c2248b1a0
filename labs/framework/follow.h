// A child process followed to its end, and its output read as it comes.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <limits>
#include <span>
#include <string>

namespace glassbox::labs {

class Descriptor {
public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return number_; }
  // Above those of a child, so that none is overwritten before it is passed on.
  void set(int number);
  void close();

private:
  int number_;
};

// Both ends are closed in a program that a child becomes. Reading does not wait.
struct Pipe {
  Descriptor read, write;
  Pipe();
  bool valid() const { return read.get() >= 0 && write.get() >= 0; }
};

// One stream of a process's output.
struct Stream {
  const Pipe* from;
  std::size_t kept;  // bytes, of all that is written
  std::size_t allowed = std::numeric_limits<std::size_t>::max();
  std::string text{};
  std::size_t seen = 0;

  bool too_much() const { return seen > allowed; }
};

struct Followed {
  bool ended = false;  // of itself, within its time
  int status = 0;      // as waitpid gives it
  double seconds = 0;
};

// Until the process ends, its time is up or it writes more than it may. It is killed then, with the group that it leads, so
// that nothing it started lives on.
Followed follow(pid_t process, std::span<Stream> streams, double seconds);

}  // namespace glassbox::labs
