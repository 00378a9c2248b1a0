// Tests the tolerances: the fuzzy annotations of the web-platform-tests, and ulps.
#include "tests/support/catch.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <glassbox/base/random.h>

#include <glassbox/compare/pixels/tolerance.h>

namespace glassbox::test {
namespace {

Fuzzy parsed(const std::string& text) {
  INFO(text);
  const auto fuzzy = parse_fuzzy(text);
  REQUIRE(fuzzy);
  return *fuzzy;
}

Differences differences(std::uint32_t largest, std::uint64_t pixels) {
  Differences found;
  found.compared = 1u << 20;
  found.largest = largest;
  found.differing = pixels;
  return found;
}

TEST_CASE("an annotation is read with names, without, with one, in either order, and with blanks") {
  const Fuzzy expected{{0, 1}, {2, 4}};
  for (const char* text :
       {"maxDifference=0-1;totalPixels=2-4", "0-1;2-4", "totalPixels=2-4;maxDifference=0-1",
        "maxDifference=0-1;2-4", "0-1;totalPixels=2-4", "totalPixels=2-4;0-1",
        "2-4;maxDifference=0-1", " maxDifference = 0 - 1 ; totalPixels = 2 - 4 ",
        "\tmaxDifference=0-1;\ttotalPixels=2-4\r\n", "00-01;02-0004"}) {
    INFO(text);
    CHECK(parsed(text) == expected);
  }
}

TEST_CASE("a single number means exactly that number") {
  CHECK(parsed("maxDifference=3;totalPixels=7") == Fuzzy{{3, 3}, {7, 7}});
  CHECK(parsed("3;0-7") == Fuzzy{{3, 3}, {0, 7}});
  CHECK(!allows(parsed("3;7"), differences(2, 7)));
  CHECK(!allows(parsed("3;7"), differences(3, 6)));
  CHECK(!allows(parsed("3;7"), differences(4, 7)));
  CHECK(!allows(parsed("3;7"), differences(3, 8)));
  CHECK(allows(parsed("3;7"), differences(3, 7)));
}

TEST_CASE("what is no annotation is refused") {
  for (const char* text : {"",
                           ";",
                           "1",
                           "1;",
                           ";1",
                           "1;2;3",
                           "1,2",
                           "a;b",
                           "0-1",
                           "1-0;0",
                           "0;1-0",
                           "-1;0",
                           "0;-1",
                           "0--1;2",
                           "0-1-2;3",
                           "1-;2",
                           "1;2-",
                           "+1;2",
                           "1.0;2",
                           "1e3;2",
                           "0x1;2",
                           "1 2;3",
                           "1;2 3",
                           "maxDifference=1",
                           "maxDifference=1;maxDifference=2",
                           "totalPixels=1;totalPixels=2",
                           "maxdifference=1;totalPixels=2",
                           "MaxDifference=1;totalPixels=2",
                           "maxDifference:1;2",
                           "maxDifference==1;2",
                           "=1;2",
                           "other=1;2",
                           "maxDifference=;totalPixels=2",
                           "maxDifference=1;totalPixels",
                           "maxDifference 1;totalPixels 2",
                           "maxDifference=1;totalPixels=2;",
                           "\xd9\xa1;2",
                           "1\xc2\xa0;2"}) {
    INFO(text);
    const auto fuzzy = parse_fuzzy(text);
    REQUIRE(!fuzzy);
    CHECK(fuzzy.error().cause.find("not a tolerance") == 0);
    CHECK(!fuzzy.error().remedy.empty());
  }
  CHECK(!parse_fuzzy(std::string("1\0;2", 4)));
  CHECK(!parse_fuzzy(std::string("1;2\0", 4)));
}

TEST_CASE("counts go up to 2^64 - 1 and no further") {
  CHECK(parsed("0-18446744073709551615;0-18446744073709551615") ==
        Fuzzy{{0, ~std::uint64_t(0)}, {0, ~std::uint64_t(0)}});
  CHECK(!parse_fuzzy("0-18446744073709551616;0"));
  CHECK(!parse_fuzzy("0;99999999999999999999999999"));
}

TEST_CASE("a refusal of text from a file fits on a line") {
  const auto fuzzy = parse_fuzzy(std::string("a\nb\x1b[2J") + std::string(100000, 'x'));
  REQUIRE(!fuzzy);
  CHECK(fuzzy.error().message().find('\n') == std::string::npos);
  CHECK(fuzzy.error().message().find('\x1b') == std::string::npos);
  CHECK(fuzzy.error().message().size() < 500);
  const auto ulps = parse_max_ulp("1\n2");
  REQUIRE(!ulps);
  CHECK(ulps.error().message().find('\n') == std::string::npos);
}

TEST_CASE("an annotation survives being written") {
  Random random(31);
  for (int round = 0; round < 300; ++round) {
    const auto range = [&random]() -> CountRange {
      const std::uint64_t a = random.bits() >> random.integer(0, 63);
      const std::uint64_t b = random.bits() >> random.integer(0, 63);
      return {std::min(a, b), std::max(a, b)};
    };
    const Fuzzy fuzzy{range(), range()};
    INFO(to_string(fuzzy));
    CHECK(parsed(to_string(fuzzy)) == fuzzy);
  }
  CHECK(to_string(Fuzzy{{0, 1}, {4, 4}}) == "maxDifference=0-1;totalPixels=4");
}

TEST_CASE("both ends of a range are allowed, and nothing beyond them") {
  const Fuzzy fuzzy{{2, 5}, {10, 20}};
  for (std::uint32_t largest = 1; largest <= 7; ++largest) {
    for (std::uint64_t pixels = 8; pixels <= 22; ++pixels) {
      const bool within = largest >= 2 && largest <= 5 && pixels >= 10 && pixels <= 20;
      CHECK(allows(fuzzy, differences(largest, pixels)) == within);
    }
  }
}

TEST_CASE("pictures that are the same pass only where a range starts at nothing") {
  const Differences none = differences(0, 0);
  CHECK(allows({{0, 0}, {0, 0}}, none));
  CHECK(allows({{0, 3}, {0, 9}}, none));
  // In the web-platform-tests it is enough that one of the two ranges starts at 0.
  CHECK(allows({{0, 3}, {5, 9}}, none));
  CHECK(allows({{1, 3}, {0, 9}}, none));
  CHECK(!allows({{1, 3}, {5, 9}}, none));
}

TEST_CASE("the tightest annotation passes, and each that is tighter does not") {
  Random random(32);
  for (int round = 0; round < 300; ++round) {
    const auto largest = std::uint32_t(random.integer(1, 65535));
    const Differences found = differences(largest, std::uint64_t(random.integer(1, 1 << 20)));
    const Fuzzy tight = tightest_fuzzy(found);
    CHECK(allows(tight, found));
    CHECK(allows(parsed(to_string(tight)), found));
    // For ranges from 0, the upper ends are the smallest that pass. A range that starts above the
    // exact numbers fails too.
    const std::uint64_t steps = found.largest, pixels = found.differing;
    CHECK(allows({{0, steps}, {0, pixels}}, found));
    CHECK(!allows({{0, steps - 1}, {0, pixels}}, found));
    CHECK(!allows({{0, steps}, {0, pixels - 1}}, found));
    CHECK(!allows({{steps + 1, steps + 9}, {0, pixels}}, found));
    CHECK(!allows({{0, steps}, {pixels + 1, pixels + 9}}, found));
    CHECK(!allows(tight, differences(found.largest + 1, found.differing)));
    CHECK(!allows(tight, differences(found.largest, found.differing + 1)));
    CHECK(!allows(tight, differences(0, 0)));
  }
  CHECK(allows(tightest_fuzzy(differences(0, 0)), differences(0, 0)));
}

TEST_CASE("no range allows NaN or an infinity in place of a number") {
  const std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  CHECK(!allows({{0, most}, {0, most}}, differences(kUnbounded, 1)));
  CHECK(!allows({{kUnbounded, kUnbounded}, {1, 1}}, differences(kUnbounded, 1)));
  CHECK(allows({{0, most}, {0, most}}, differences(kUnbounded - 1, 1)));
}

TEST_CASE("ulps are whole numbers below the one that stands for no finite distance") {
  CHECK(parse_max_ulp("0") == 0u);
  CHECK(parse_max_ulp(" 4 ") == 4u);
  CHECK(parse_max_ulp("4294967294") == 4294967294u);
  for (const char* text : {"", " ", "-1", "+1", "1.5", "4294967295", "99999999999999999999", "4u",
                           "0x4", "1 2", "inf", "nan"}) {
    INFO(text);
    const auto ulps = parse_max_ulp(text);
    REQUIRE(!ulps);
    CHECK(!ulps.error().remedy.empty());
  }
}

}  // namespace
}  // namespace glassbox::test
