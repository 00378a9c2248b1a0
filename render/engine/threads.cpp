#include <glassbox/render/engine/threads.h>

#include <atomic>
#include <cstddef>
#include <mutex>
#include <optional>

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>

#include <glassbox/render/engine/preferred_threads.h>

namespace glassbox {

namespace {

constexpr int kNoPreference = 0;
std::atomic<int> preferred = kNoPreference;

}  // namespace

int default_threads() {
  if (const int preference = preferred; preference != kNoPreference) return preference;
  return tbb::info::default_concurrency();
}

void prefer_threads(std::optional<int> threads) {
  preferred = threads.value_or(kNoPreference);
}

// oneTBB uses the smallest limit in force. So there is one limit for the whole program, the size of
// the largest arena so far, and not one for each arena. A larger limit would do harm: if many
// arenas are made one after the other, each wakes threads of its own, and oneTBB would start as
// many threads as the limit allows.
void allow_threads(int threads) {
  using Control = tbb::global_control;
  static std::mutex one_at_a_time;
  // The limit is never destroyed: ending it when the process exits would wake a thread.
  static auto& limit = *new std::optional<Control>;
  static int allowed = tbb::info::default_concurrency();
  const std::lock_guard lock(one_at_a_time);
  if (threads <= allowed) return;
  allowed = threads;
  limit.emplace(Control::max_allowed_parallelism, std::size_t(threads));
}

}  // namespace glassbox
