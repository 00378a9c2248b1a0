#include "cli/process/wait_for_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <vector>

namespace glassbox {

namespace {

using Clock = std::chrono::steady_clock;

// Reads one block of the available output. Returns its length, 0 at the stream's end, and a
// negative number if no output is available yet.
ssize_t read_block(Stream& stream) {
  char block[65536];
  ssize_t got = -1;
  do {
    got = ::read(stream.from->read.get(), block, sizeof block);
  } while (got < 0 && errno == EINTR);
  if (got < 0) return errno == EAGAIN ? -1 : 0;
  stream.received += static_cast<std::size_t>(got);
  stream.text.append(block,
                     std::min(static_cast<std::size_t>(got), stream.kept - stream.text.size()));
  return got;
}

// Returns true if the process has ended by itself; false if its time was up or it wrote too much.
bool reaches_end(pid_t process, std::span<Stream> streams, Clock::time_point deadline) {
  const Descriptor ended(static_cast<int>(::syscall(SYS_pidfd_open, process, 0)));
  std::vector<pollfd> waited{{ended.get(), POLLIN, 0}};
  for (const Stream& stream : streams) waited.push_back({stream.from->read.get(), POLLIN, 0});
  while (true) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return false;
    // Linux before 5.3 has no descriptor for a process; there it is checked every 10 ms.
    ::poll(waited.data(), waited.size(),
           static_cast<int>(std::min<decltype(left)>(left, ended.get() >= 0 ? 1000 : 10)));
    for (std::size_t i = 0; i < streams.size(); ++i) {
      if (waited[i + 1].fd >= 0 && read_block(streams[i]) == 0) waited[i + 1].fd = -1;
      if (streams[i].exceeds_limit()) return false;
    }
    siginfo_t info{};
    if (::waitid(P_PID, static_cast<id_t>(process), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
        info.si_pid == process)
      return true;
  }
}

}  // namespace

void Descriptor::set(int number) {
  close();
  number_ = ::fcntl(number, F_DUPFD_CLOEXEC, 10);
  ::close(number);
}

void Descriptor::close() {
  if (number_ >= 0) ::close(number_);
  number_ = -1;
}

Pipe::Pipe() {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return;
  read.set(ends[0]);
  write.set(ends[1]);
  ::fcntl(read.get(), F_SETFL, O_NONBLOCK);
}

WaitResult wait_for_process(pid_t process, std::span<Stream> streams, double seconds) {
  const auto start = Clock::now();
  const auto time =
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  WaitResult result;
  result.ended = reaches_end(process, streams, start + time);
  // The process group is killed before waitpid: until then, no other process can get this number.
  ::kill(-process, SIGKILL);
  if (!result.ended) ::kill(process, SIGKILL);
  while (::waitpid(process, &result.status, 0) < 0 && errno == EINTR) {
  }
  // Reads the rest of the output. A pipe holds at most 1 MiB, which is 16 blocks. A process that
  // left the group and still writes is not waited for.
  for (Stream& stream : streams) {
    for (int block = 0; block < 16 && read_block(stream) > 0; ++block) {
    }
  }
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return result;
}

}  // namespace glassbox
