// Runs independent work on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace glassbox::labs {

// Calls work(0) to work(count - 1), at most `hands` of them at the same time; `hands` is the number
// of processors unless it is given.
inline void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work,
                        std::size_t hands = std::thread::hardware_concurrency()) {
  std::atomic<std::size_t> next{0};
  const auto take = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::jthread> threads;
  for (std::size_t i = 1; i < std::min(hands, count); ++i) threads.emplace_back(take);
  take();
}

}  // namespace glassbox::labs
