// Shows progress on standard error while work takes longer than a second; nothing if standard error
// is not a terminal.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace glassbox {

class Progress {
public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Sets the text that says what is being done.
  void phase(const std::string& what);
  // Prints a line of its own on standard error, even if it is not a terminal.
  void print_line(const std::string& message);
  // Stops and erases the line. Nothing is shown afterwards.
  void done();

private:
  void watch();

  const bool on_terminal_;
  const std::chrono::steady_clock::time_point start_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string what_;
  bool shown_ = false;
  bool finished_ = false;
  std::thread watcher_;
};

}  // namespace glassbox
