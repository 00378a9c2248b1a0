// All ways in which this machine can compute a picture: with each instruction set, and with one,
// two and three threads. All of them must give the same bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <tbb/task_arena.h>

#include <glassbox/images/image.h>
#include <glassbox/raster/lanes/preferred_target.h>
#include <glassbox/render/engine/preferred_threads.h>
#include <glassbox/render/engine/threads.h>

#include "tests/support/catch.h"

namespace glassbox::test {

struct Way {
  Target target = Target::kScalar;
  int threads = 1;
};

inline std::string in_words(const Way& way) {
  return std::string(name_of(way.target)) + ", " + std::to_string(way.threads) + " threads";
}

// The first way is plain C++ on one thread.
inline std::vector<Way> all_ways() {
  std::vector<Way> ways;
  for (const Target target : available_targets()) {
    for (const int threads : {1, 2, 3}) ways.push_back({target, threads});
  }
  return ways;
}

// A result, as named rows of bytes.
class Made {
public:
  void add(const char* name, std::span<const std::byte> bytes) {
    parts_.emplace_back(name, std::vector<std::byte>(bytes.begin(), bytes.end()));
  }
  // Every byte of an element must be part of its value: padding might differ for no reason.
  template <class Element, class Allocator>
  void add(const char* name, const std::vector<Element, Allocator>& elements) {
    static_assert(std::has_unique_object_representations_v<Element> ||
                  std::is_floating_point_v<Element>);
    add(name, std::as_bytes(std::span(elements)));
  }
  template <class Pixel>
  void add(const char* name, const Image<Pixel>& image) {
    add_number(name, std::uint64_t(image.width) << 32 | std::uint64_t(image.height));
    add(name, image.pixels);
  }
  void add(const char* name, const std::string& text) { add(name, std::as_bytes(std::span(text))); }
  template <class Number>
  void add_number(const char* name, Number number) {
    add(name, std::vector<Number>{number});
  }

  std::size_t bytes() const {
    std::size_t sum = 0;
    for (const auto& part : parts_) sum += part.second.size();
    return sum;
  }

  // The first part that differs in `other`, in words; empty if none does.
  std::string difference_from(const Made& other) const {
    if (parts_.size() != other.parts_.size()) return "other parts";
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const auto& [name, bytes] = parts_[i];
      const auto& expected = other.parts_[i].second;
      if (bytes.size() != expected.size())
        return name + ": " + std::to_string(bytes.size()) + " bytes instead of " +
               std::to_string(expected.size());
      std::size_t count = 0, first = 0;
      for (std::size_t k = 0; k < bytes.size(); ++k) {
        if (bytes[k] == expected[k]) continue;
        if (count++ == 0) first = k;
      }
      if (count > 0)
        return name + ": " + std::to_string(count) + " bytes of " + std::to_string(bytes.size()) +
               " differ, first the one at " + std::to_string(first);
    }
    return "";
  }

private:
  std::vector<std::pair<std::string, std::vector<std::byte>>> parts_;
};

// Sets the target and the number of threads of a way, for functions that have no option for them,
// as long as the object exists.
class Going {
public:
  explicit Going(const Way& way) {
    allow_threads(way.threads);
    prefer_target(way.target);
    prefer_threads(way.threads);
  }
  ~Going() {
    prefer_target({});
    prefer_threads({});
  }
  Going(const Going&) = delete;
  Going& operator=(const Going&) = delete;
};

// Runs make(way) in this way; oneTBB's own loops use the same number of threads.
template <class Make>
auto made_in(const Way& way, const Make& make) {
  const Going going(way);
  tbb::task_arena arena(way.threads);
  return arena.execute([&] { return make(way); });
}

// Where the results of make(way) differ between two ways, in words; empty if they do not. make(way)
// returns a Made that must contain bytes.
template <class Make>
std::string difference_of_ways(const Make& make) {
  const std::vector<Way> ways = all_ways();
  const Made expected = made_in(ways.front(), make);
  if (expected.bytes() == 0) return "nothing was made";
  for (const Way& way : std::span(ways).subspan(1)) {
    const std::string difference = made_in(way, make).difference_from(expected);
    if (!difference.empty())
      return in_words(way) + ": " + difference + ", from " + in_words(ways.front());
  }
  return "";
}

template <class Make>
void check_all_ways(std::uint64_t seed, const Make& make) {
  const std::string difference = difference_of_ways(make);
  if (!difference.empty()) FAIL_CHECK("seed " << seed << ": " << difference);
}

// The sum of check(seed) for the seeds from 0 to count - 1, which says how much was compared.
template <class Check>
std::size_t sum_over_seeds(std::uint64_t count, const Check& check) {
  std::size_t sum = 0;
  for (std::uint64_t seed = 0; seed < count; ++seed) sum += check(seed);
  return sum;
}

}  // namespace glassbox::test
