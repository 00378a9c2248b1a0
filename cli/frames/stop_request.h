// Ctrl-C stops between two pictures, so that no file is left incomplete.
#pragma once

#include <csignal>

namespace glassbox {

// While such an object exists, the first SIGINT or SIGTERM only sets a flag; a second one ends the
// program as usual.
class StopRequest {
public:
  StopRequest() {
    requested_ = 0;
    struct sigaction note = {};
    note.sa_handler = [](int) { requested_ = 1; };
    note.sa_flags = static_cast<int>(SA_RESETHAND);
    ::sigaction(SIGINT, &note, &interrupt_before_);
    ::sigaction(SIGTERM, &note, &terminate_before_);
  }
  ~StopRequest() {
    ::sigaction(SIGINT, &interrupt_before_, nullptr);
    ::sigaction(SIGTERM, &terminate_before_, nullptr);
  }
  StopRequest(const StopRequest&) = delete;
  StopRequest& operator=(const StopRequest&) = delete;

  bool is_requested() const { return requested_ != 0; }

private:
  static inline volatile std::sig_atomic_t requested_ = 0;
  struct sigaction interrupt_before_ = {}, terminate_before_ = {};
};

}  // namespace glassbox
