// Runs independent work on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace glassbox::labs {

// Calls work(0) to work(count - 1), at most `max_threads` of them at the same time.
inline void run_in_parallel(std::size_t count, const std::function<void(std::size_t)>& work,
                            std::size_t max_threads = std::thread::hardware_concurrency()) {
  std::atomic<std::size_t> next{0};
  const auto run_next_items = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::jthread> threads;
  for (std::size_t i = 1; i < std::min(max_threads, count); ++i)
    threads.emplace_back(run_next_items);
  run_next_items();
}

}  // namespace glassbox::labs
