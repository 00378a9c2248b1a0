// A sign of life on standard error while work takes longer than a second; nothing where that is no terminal.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace glassbox::app {

class Progress {
public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // What is being done.
  void phase(const std::string& what);
  // A line of its own on standard error, terminal or not.
  void say(const std::string& message);
  // Stops and wipes the line; nothing is shown after it.
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

}  // namespace glassbox::app
