// A share of many tests (tests/support/daily_share.h) leaves no test out for longer than it
// promises.
#include "tests/support/daily_share.h"

#include <optional>
#include <vector>

#include "tests/support/catch.h"

namespace glassbox::test {

namespace {

// Sets the environment variable SEED, and restores it when destroyed.
class Said {
public:
  explicit Said(const char* seed) {
    if (const char* before = std::getenv("SEED")) before_ = before;
    seed == nullptr ? unsetenv("SEED") : setenv("SEED", seed, 1);
  }
  ~Said() { before_ ? setenv("SEED", before_->c_str(), 1) : unsetenv("SEED"); }
  Said(const Said&) = delete;
  Said& operator=(const Said&) = delete;

private:
  std::optional<std::string> before_;
};

}  // namespace

TEST_CASE("after as many seeds as a share has days every test has had its turn, once") {
  for (const std::size_t days : {1u, 3u, 8u}) {
    for (std::size_t size = 1; size <= 40; ++size) {
      for (const std::uint64_t first : {std::uint64_t(0), std::uint64_t(20783)}) {
        CAPTURE(days, size, first);
        std::vector<std::size_t> turns(size, 0);
        for (std::uint64_t seed = first; seed < first + days; ++seed) {
          std::size_t now = 0;
          for (std::size_t i = 0; i < size; ++i) {
            const std::size_t turn = DailyShare(days, seed).includes(i, size) ? 1 : 0;
            turns[i] += turn;
            now += turn;
          }
          CHECK(now > 0);
        }
        for (const std::size_t each : turns) CHECK(each >= 1);
        if (size >= days) CHECK(turns == std::vector<std::size_t>(size, 1));
      }
    }
  }
}

TEST_CASE("under every seed every group has a test, and a large group its share") {
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    for (std::size_t size = 1; size <= 40; ++size) {
      CAPTURE(seed, size);
      std::size_t now = 0;
      for (std::size_t i = 0; i < size; ++i) now += DailyShare(8, seed).includes(i, size) ? 1u : 0u;
      CHECK(now >= 1);
      CHECK(now >= size / 8);
      CHECK(now <= size / 8 + 1);
    }
  }
}

TEST_CASE("SEED repeats a share, and is refused where it is no number") {
  {
    const Said said("20783");
    CHECK(seed_of_shares() == 20783);
    CHECK(DailyShare(8).text() == "one in 8, SEED=20783");
  }
  {
    const Said said(nullptr);
    CHECK(seed_of_shares() >= 20000);  // the days up to October 2024
  }
  for (const char* wrong : {"", "-1", "12x", " 3", "9999999999999999999"}) {
    CAPTURE(wrong);
    const Said said(wrong);
    CHECK_THROWS_AS(seed_of_shares(), std::invalid_argument);
  }
}

}  // namespace glassbox::test
