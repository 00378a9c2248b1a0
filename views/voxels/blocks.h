// Divides work into parts for several threads.
#pragma once

#include <cstddef>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <glassbox/render/engine/threads.h>

namespace glassbox::views {

// Calls each(i) for i = 0 .. count - 1, in any order, with this many threads; 0: all of the
// machine's.
template <class Each>
void for_blocks(std::size_t count, int threads, const Each& each) {
  if (threads == 1 || count <= 1) {
    for (std::size_t i = 0; i < count; ++i) each(i);
    return;
  }
  const auto run = [&] { tbb::parallel_for(std::size_t(0), count, each); };
  if (threads == 0) {
    run();
  } else {
    allow_threads(threads);
    tbb::task_arena(threads).execute(run);
  }
}

}  // namespace glassbox::views
