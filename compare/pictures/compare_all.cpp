#include <glassbox/compare/pictures/compare_all.h>

#include <algorithm>
#include <chrono>
#include <mutex>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace glassbox {
namespace {

Comparison timed_comparison(const PicturePaths& paths, const CompareOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  Comparison comparison = compare_pair(paths, options);
  comparison.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return comparison;
}

}  // namespace

std::vector<Comparison> compare_all(std::span<const PicturePaths> pairs,
                                    const CompareOptions& options,
                                    const std::function<void(std::size_t)>& on_start) {
  constexpr int kMaxThreads = 8;
  std::vector<Comparison> comparisons(pairs.size());
  std::mutex calls;
  const auto compare_one = [&](std::size_t i) {
    if (on_start) {
      const std::lock_guard lock(calls);
      on_start(i);
    }
    // A thread that waits for others inside of a comparison must not begin another one.
    tbb::this_task_arena::isolate([&] { comparisons[i] = timed_comparison(pairs[i], options); });
  };
  if (pairs.size() == 1) {  // may use all threads for itself
    compare_one(0);
    return comparisons;
  }
  tbb::task_arena arena(std::min(tbb::this_task_arena::max_concurrency(), kMaxThreads));
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, pairs.size(), compare_one, tbb::simple_partitioner());
  });
  return comparisons;
}

}  // namespace glassbox
