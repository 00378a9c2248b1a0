// All configurations in which this machine can compute a picture: with each instruction set, and
// with one, two and three threads. All of them must give the same bytes.
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

struct Configuration {
  Target target = Target::kScalar;
  int threads = 1;
};

inline std::string in_words(const Configuration& configuration) {
  return std::string(name_of(configuration.target)) + ", " + std::to_string(configuration.threads) +
         " threads";
}

// The first configuration is plain C++ on one thread.
inline std::vector<Configuration> all_configurations() {
  std::vector<Configuration> configurations;
  for (const Target target : available_targets()) {
    for (const int threads : {1, 2, 3}) configurations.push_back({target, threads});
  }
  return configurations;
}

// A result, as named rows of bytes.
class RunResult {
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
  std::string difference_from(const RunResult& other) const {
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

// Sets the target and the number of threads of a configuration, for functions that have no option
// for them, as long as the object exists.
class ConfigurationScope {
public:
  explicit ConfigurationScope(const Configuration& configuration) {
    allow_threads(configuration.threads);
    prefer_target(configuration.target);
    prefer_threads(configuration.threads);
  }
  ~ConfigurationScope() {
    prefer_target({});
    prefer_threads({});
  }
  ConfigurationScope(const ConfigurationScope&) = delete;
  ConfigurationScope& operator=(const ConfigurationScope&) = delete;
};

// Runs make(configuration) in this configuration; oneTBB's own loops use the same number of
// threads.
template <class Make>
auto result_in(const Configuration& configuration, const Make& make) {
  const ConfigurationScope scope(configuration);
  tbb::task_arena arena(configuration.threads);
  return arena.execute([&] { return make(configuration); });
}

// Where the results of make(configuration) differ between two configurations, in words; empty if
// they do not. make(configuration) returns a RunResult that must contain bytes.
template <class Make>
std::string difference_of_configurations(const Make& make) {
  const std::vector<Configuration> configurations = all_configurations();
  const RunResult expected = result_in(configurations.front(), make);
  if (expected.bytes() == 0) return "nothing was made";
  for (const Configuration& configuration : std::span(configurations).subspan(1)) {
    const std::string difference = result_in(configuration, make).difference_from(expected);
    if (!difference.empty())
      return in_words(configuration) + ": " + difference + ", from " +
             in_words(configurations.front());
  }
  return "";
}

template <class Make>
void check_same_result(std::uint64_t seed, const Make& make) {
  const std::string difference = difference_of_configurations(make);
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
