// A replacement for the parts of oneTBB that the tile engine uses, for builds with ThreadSanitizer
// (preset `thread`). The library itself is compiled without the sanitizer, which therefore does not
// see how its threads wait for one another and reports every hand-over as a race. Here threads are
// started and joined, which the sanitizer sees, and nothing else orders what tasks do.
//
// It replaces what a source includes as <oneapi/tbb/...>. Sources that these builds do not test
// include <tbb/...>, and get the library.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <functional>
#include <iterator>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include <oneapi/tbb/blocked_range.h>

namespace tbb {

inline constexpr int kMaxThreads = 64;

struct Worker {
  int arena_size = 1;  // number of threads that work together
  int index = 0;       // index of this thread among them
};
inline thread_local Worker this_worker;

namespace info {
inline int default_concurrency() {
  return int(std::max(1u, std::thread::hardware_concurrency()));
}
}  // namespace info

class global_control {
public:
  enum parameter { max_allowed_parallelism };
  global_control(parameter, std::size_t) {}
};

class task_arena {
public:
  explicit task_arena(int threads) : threads_(std::min(threads, kMaxThreads)) {}

  template <class Work>
  void execute(const Work& work) const {
    const Worker before = this_worker;
    this_worker = {threads_, 0};
    work();
    this_worker = before;
  }

private:
  int threads_;
};

struct simple_partitioner {};

template <class Index, class Body>
void parallel_for(Index first, Index last, const Body& body, const simple_partitioner& = {}) {
  std::atomic<Index> next{first};
  const auto work = [&](Worker worker) {
    this_worker = worker;
    // Relaxed: a task must not be ordered after the one before it.
    for (Index i; (i = next.fetch_add(1, std::memory_order_relaxed)) < last;) body(i);
  };
  const int threads = this_worker.arena_size;
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(work, Worker{threads, i});
  work({threads, 0});
  for (std::thread& other : others) other.join();
}

// Splits the range into pieces of its grain size; each piece is one task.
template <class Index, class Body>
void parallel_for(const blocked_range<Index>& all, const Body& body,
                  const simple_partitioner& partitioner = {}) {
  const Index pieces = (all.size() + all.grainsize() - 1) / all.grainsize();
  const auto piece = [&](Index i) {
    const Index begin = all.begin() + i * all.grainsize();
    const Index end = std::min(begin + all.grainsize(), all.end());
    body(blocked_range<Index>(begin, end, all.grainsize()));
  };
  parallel_for(Index(0), pieces, piece, partitioner);
}

// One T for each thread that calls local().
template <class T>
class enumerable_thread_specific {
public:
  enumerable_thread_specific() : make_([] { return T(); }) {}
  template <class Make>
  explicit enumerable_thread_specific(Make make) : make_(std::move(make)) {}

  T& local() {
    std::optional<T>& own = all_[std::size_t(this_worker.index)];
    if (!own) own.emplace(make_());
    return *own;
  }

  void clear() { all_ = {}; }

  class iterator {
  public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = T*;
    using reference = T&;

    iterator() = default;
    iterator(std::optional<T>* at, std::optional<T>* end) : at_(at), end_(end) { skip(); }
    T& operator*() const { return **at_; }
    iterator& operator++() {
      ++at_;
      skip();
      return *this;
    }
    iterator operator++(int) {
      const iterator before = *this;
      ++*this;
      return before;
    }
    friend bool operator==(const iterator&, const iterator&) = default;

  private:
    void skip() {
      while (at_ != end_ && !*at_) ++at_;
    }
    std::optional<T>* at_ = nullptr;
    std::optional<T>* end_ = nullptr;
  };
  iterator begin() { return {all_.data(), all_.data() + all_.size()}; }
  iterator end() { return {all_.data() + all_.size(), all_.data() + all_.size()}; }

private:
  std::function<T()> make_;
  std::array<std::optional<T>, kMaxThreads> all_;
};

}  // namespace tbb
