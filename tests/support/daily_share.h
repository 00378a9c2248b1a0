// A share of many similar tests, a different one every day, so that after a few days all tests have
// run. The environment variable SEED, which tests/run.sh prints, repeats the share of another day.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace glassbox::test {

// Returns the value of SEED, a number without a sign, or, if it is not set, the days since 1
// January 1970. Throws std::invalid_argument with a message if SEED is not such a number.
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

class DailyShare {
public:
  // Chooses one of `days` tests for this seed. Over `days` consecutive seeds every test is chosen.
  explicit DailyShare(std::size_t days, std::uint64_t seed = seed_of_shares())
      : days_(days), seed_(seed) {}
  static DailyShare everything() { return DailyShare(1, 0); }

  // Whether the test at `position`, from 0, of a group of `size` runs. At least one test of every
  // group runs for every seed, so no group is ever left out: in a group that is smaller than
  // `days`, the tests run one after the other.
  bool includes(std::size_t position, std::size_t size) const {
    const std::size_t step = size < days_ ? size : days_;
    return position % step == seed_ % step;
  }

  // Describes the share in the message of a test that fails.
  std::string text() const {
    return days_ == 1 ? "all of them"
                      : "one in " + std::to_string(days_) + ", SEED=" + std::to_string(seed_);
  }

private:
  std::size_t days_;
  std::uint64_t seed_;
};

}  // namespace glassbox::test
