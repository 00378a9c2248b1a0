#include "study/bench/peer_process.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include <fmt/format.h>

#include "study/bench/mesa/renderer.h"

extern char** environ;

namespace glassbox::study {

namespace {

// Request:           Answer:
//   (at the start)     "ready DESCRIPTION" or "failed CAUSE"
//   "frames N"         N lines, milliseconds each
//   "picture"          the colours, then the covered pixels, byte by byte as in memory
constexpr std::string_view kReady = "ready ", kFailed = "failed ", kFrames = "frames ";
constexpr const char* kPicture = "picture";

// The environment variable by which llvmpipe gets its number of threads. It adds that many
// rasterizing threads to the one that calls OpenGL, which then waits for them; with 0, the calling
// thread does everything.
constexpr const char* kThreadsVariable = "LP_NUM_THREADS";

std::string threads_setting(int threads) {
  return fmt::format("{}={}", kThreadsVariable, threads == 1 ? 0 : threads);
}

tl::unexpected<Error> ended() {
  return fail("the peer", "its process has ended unexpectedly",
              "run bench without --against to leave the peer out");
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> all;
  for (std::string& word : words) all.push_back(word.data());
  all.push_back(nullptr);
  return all;
}

std::vector<std::string> environment(int threads) {
  std::vector<std::string> all;
  for (char** at = environ; *at != nullptr; ++at) {
    if (!std::string_view(*at).starts_with(kThreadsVariable)) all.emplace_back(*at);
  }
  all.push_back(threads_setting(threads));
  return all;
}

}  // namespace

Result<std::unique_ptr<PeerProcess>> PeerProcess::start(const PeerCommand& command) {
  // All memory is allocated before the fork: after it, only functions that are safe in a signal
  // handler may be called.
  std::vector<std::string> words{command.program};
  words.insert(words.end(), command.words.begin(), command.words.end());
  std::vector<std::string> settings = environment(command.threads);
  const std::vector<char*> argv = pointers(words), envp = pointers(settings);
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return ended();
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(ends[1], 0);
    ::dup2(::open("/dev/null", O_WRONLY), 1);
    ::execve(argv[0], argv.data(), envp.data());
    ::_exit(127);
  }
  ::close(ends[1]);
  std::unique_ptr<PeerProcess> peer(new PeerProcess(child, ends[0]));
  if (child < 0) return ended();
  const auto line = peer->channel_->receive_line();
  if (!line) return ended();
  if (line->starts_with(kFailed)) {
    return fail("", line->substr(kFailed.size()), "");
  }
  peer->description_ = line->substr(kReady.size());
  return peer;
}

PeerProcess::~PeerProcess() {
  channel_.reset();
  if (child_ > 0) ::waitpid(child_, nullptr, 0);
}

Result<std::vector<double>> PeerProcess::frames(int count) {
  std::vector<double> times;
  channel_->send_line(fmt::format("{}{}", kFrames, count));
  for (int i = 0; i < count; ++i) {
    const auto line = channel_->receive_line();
    if (!line) return ended();
    times.push_back(std::strtod(line->c_str(), nullptr));
  }
  return times;
}

Result<Picture> PeerProcess::picture(int width, int height) {
  Picture read{Image<Rgba8>(width, height), Image<std::uint8_t>(width, height)};
  const bool whole = channel_->send_line(kPicture) &&
                     channel_->receive(std::as_writable_bytes(std::span(read.color.pixels))) &&
                     channel_->receive(std::as_writable_bytes(std::span(read.covered.pixels)));
  if (!whole) return ended();
  return read;
}

bool serve_mesa(const BenchScene& bench) {
  Channel channel(0);
  const auto mesa = MesaRenderer::make(bench);
  if (!mesa) {
    channel.send_line(std::string(kFailed) + mesa.error().message());
    return false;
  }
  channel.send_line(std::string(kReady) + (*mesa)->description());
  while (const auto line = channel.receive_line()) {
    if (*line == kPicture) {
      const Picture picture = (*mesa)->picture();
      channel.send(std::as_bytes(std::span(picture.color.pixels)));
      channel.send(std::as_bytes(std::span(picture.covered.pixels)));
    } else if (line->starts_with(kFrames)) {
      for (int left = std::atoi(line->c_str() + kFrames.size()); left > 0; --left) {
        channel.send_line(fmt::format("{}", (*mesa)->frame_ms()));
      }
    }
  }
  return true;
}

}  // namespace glassbox::study
