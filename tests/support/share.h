// A share of many tests of one kind, another one every day, so that all have had their turn after a
// few days. The environment variable SEED repeats the share of another day; tests/run.sh prints it.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace glassbox::test {

// What SEED says, a number without a sign; where it is not set, the days since 1 January 1970.
// Throws std::invalid_argument with a message where it is no such number.
inline std::uint64_t seed_of_shares() {
  const char* const said = std::getenv("SEED");
  if (said == nullptr) {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return std::uint64_t(std::chrono::floor<std::chrono::days>(now).count());
  }
  const std::string text = said;
  if (text.empty() || text.size() > 17 || text.find_first_not_of("0123456789") != std::string::npos)
    throw std::invalid_argument("SEED is '" + text +
                                "', which is not a number of 1 to 17 digits: give one, or none");
  return std::stoull(text);
}

class Share {
public:
  // One test in `days` under this seed, and every test under one of `days` seeds that follow each
  // other.
  explicit Share(std::size_t days, std::uint64_t seed = seed_of_shares())
      : days_(days), seed_(seed) {}
  static Share everything() { return Share(1, 0); }

  // Whether the test at `position`, from 0, of a group of `size` has its turn. Every group has at
  // least one turn under every seed, so no group is ever left out: a group that is smaller than
  // `days` takes its tests one after the other.
  bool has(std::size_t position, std::size_t size) const {
    const std::size_t step = size < days_ ? size : days_;
    return position % step == seed_ % step;
  }

  // For the message of a test that fails.
  std::string text() const {
    return days_ == 1 ? "all of them"
                      : "one in " + std::to_string(days_) + ", SEED=" + std::to_string(seed_);
  }

private:
  std::size_t days_;
  std::uint64_t seed_;
};

}  // namespace glassbox::test
