#include <glassbox/render/engine/threads.h>

#include <cstddef>

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>

namespace glassbox {

namespace {

// oneTBB keeps to the smallest limit in force, so there is one for the whole program and not one for each arena. It starts no
// thread by itself.
void allow_more_threads_than_processors() {
  constexpr std::size_t kMost = 1024;
  static const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, kMost);
}

}  // namespace

int default_threads() {
  return tbb::info::default_concurrency();
}

void allow_threads(int threads) {
  if (threads > default_threads()) allow_more_threads_than_processors();
}

}  // namespace glassbox
