#include "cli/report/progress.h"

#include <unistd.h>

#include <cstdio>

#include <fmt/format.h>

#include "cli/report/exit_codes.h"

#include <glassbox/base/printable.h>

namespace glassbox {

namespace {

constexpr const char* kWipe = "\r\033[K";
// Longer texts are cut: a text that is wrapped to a second line would not be erased completely.
constexpr std::size_t kLongestPhase = 60;

}  // namespace

Progress::Progress() : on_terminal_(::isatty(2) == 1), start_(std::chrono::steady_clock::now()) {
  if (on_terminal_) watcher_ = std::thread([this] { watch(); });
}

Progress::~Progress() {
  done();
}

void Progress::phase(const std::string& what) {
  const std::lock_guard lock(mutex_);
  what_ = printable(what, kLongestPhase);
}

void Progress::print_line(const std::string& message) {
  const std::lock_guard lock(mutex_);
  fmt::print(stderr, "{}glassbox: {}\n", shown_ ? kWipe : "", printable(message, kLongestMessage));
  shown_ = false;
}

void Progress::done() {
  {
    const std::lock_guard lock(mutex_);
    finished_ = true;
  }
  changed_.notify_all();
  if (watcher_.joinable()) watcher_.join();
  if (shown_) fmt::print(stderr, "{}", kWipe);
  shown_ = false;
}

void Progress::watch() {
  std::unique_lock lock(mutex_);
  for (int seconds = 1;; ++seconds) {
    const auto next = start_ + std::chrono::seconds(seconds);
    if (changed_.wait_until(lock, next, [this] { return finished_; })) return;
    fmt::print(stderr, "{}{}: {} s", kWipe, what_, seconds);
    std::fflush(stderr);
    shown_ = true;
  }
}

}  // namespace glassbox
