// Compares the regions that are found row by row with a flood fill of the whole picture.
#include "tests/support/catch.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include <glassbox/base/random.h>

#include <glassbox/compare/pixels/regions.h>

namespace glassbox::test {
namespace {

struct Steps {
  int width = 0, height = 0;
  std::vector<std::uint32_t> values;  // in row-major order

  Steps(int width_, int height_)
      : width(width_), height(height_), values(std::size_t(width_) * std::size_t(height_)) {}
  std::uint32_t& at(int x, int y) {
    return values[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }
  std::uint32_t at(int x, int y) const {
    return values[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }
};

// Reads rows of text: "." is 0 steps, a digit is that many steps.
Steps drawn(const std::vector<std::string>& rows) {
  Steps steps(int(rows[0].size()), int(rows.size()));
  for (int y = 0; y < steps.height; ++y) {
    for (int x = 0; x < steps.width; ++x) {
      const char c = rows[std::size_t(y)][std::size_t(x)];
      steps.at(x, y) = c == '.' ? 0 : std::uint32_t(c - '0');
    }
  }
  return steps;
}

// Returns the region of all pixels that are connected to (x, y), and sets them to 0 in `steps`.
Region fill(Steps& steps, int x, int y) {
  int left = x, right = x, top = y, bottom = y;
  Region region{{}, 0, 0, {x, y}};
  std::vector<PixelPosition> to_see{{x, y}};
  std::vector<PixelPosition> seen;
  std::vector<std::uint32_t> values{steps.at(x, y)};
  steps.at(x, y) = 0;
  while (!to_see.empty()) {
    const PixelPosition at = to_see.back();
    const std::uint32_t value = values.back();
    to_see.pop_back();
    values.pop_back();
    const bool earlier = std::tuple(at.y, at.x) < std::tuple(region.worst.y, region.worst.x);
    if (value > region.largest || (value == region.largest && earlier)) {
      region.largest = value;
      region.worst = at;
    }
    ++region.pixels;
    left = std::min(left, at.x), right = std::max(right, at.x);
    top = std::min(top, at.y), bottom = std::max(bottom, at.y);
    for (int near_y = std::max(at.y - 1, 0); near_y <= std::min(at.y + 1, steps.height - 1);
         ++near_y) {
      for (int near_x = std::max(at.x - 1, 0); near_x <= std::min(at.x + 1, steps.width - 1);
           ++near_x) {
        if (steps.at(near_x, near_y) == 0) continue;
        to_see.push_back({near_x, near_y});
        values.push_back(steps.at(near_x, near_y));
        steps.at(near_x, near_y) = 0;
      }
    }
  }
  region.box = {left, top, right - left + 1, bottom - top + 1};
  return region;
}

std::vector<Region> by_flood_fill(Steps steps) {
  std::vector<Region> regions;
  for (int y = 0; y < steps.height; ++y) {
    for (int x = 0; x < steps.width; ++x) {
      if (steps.at(x, y) > 0) regions.push_back(fill(steps, x, y));
    }
  }
  std::sort(regions.begin(), regions.end(), [](const Region& a, const Region& b) {
    if (a.largest != b.largest) return a.largest > b.largest;
    if (a.pixels != b.pixels) return a.pixels > b.pixels;
    return std::tuple(a.worst.y, a.worst.x) < std::tuple(b.worst.y, b.worst.x);
  });
  return regions;
}

std::vector<Region> by_rows(const Steps& steps, std::size_t kept, std::uint64_t* count = nullptr) {
  RegionFinder finder(steps.width, kept);
  for (int y = 0; y < steps.height; ++y) {
    finder.add_row(
        y, std::span(steps.values)
               .subspan(std::size_t(y) * std::size_t(steps.width), std::size_t(steps.width)));
  }
  auto regions = finder.worst();
  if (count) *count = finder.count();
  return regions;
}

bool same(const Region& a, const Region& b) {
  return a.box == b.box && a.pixels == b.pixels && a.largest == b.largest && a.worst == b.worst;
}

std::string text_of(const Steps& steps) {
  std::string text = "\n";
  for (int y = 0; y < steps.height; ++y) {
    for (int x = 0; x < steps.width; ++x) {
      text += steps.at(x, y) == 0 ? '.' : char('0' + int(steps.at(x, y) % 10));
    }
    text += '\n';
  }
  return text;
}

void check(const Steps& steps) {
  std::uint64_t count = 0;
  const auto found = by_rows(steps, steps.values.size(), &count);
  const auto expected = by_flood_fill(steps);
  INFO(text_of(steps));
  REQUIRE(count == expected.size());
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    INFO("region " << i);
    REQUIRE(same(found[i], expected[i]));
  }
  for (const std::size_t kept : {std::size_t(0), std::size_t(1), std::size_t(3)}) {
    const auto few = by_rows(steps, kept, &count);
    REQUIRE(count == expected.size());
    REQUIRE(few.size() == std::min(kept, expected.size()));
    for (std::size_t i = 0; i < few.size(); ++i) REQUIRE(same(few[i], expected[i]));
  }
}

TEST_CASE("random pictures of all densities have the regions that a flood fill finds") {
  Random random(21);
  for (int round = 0; round < 1500; ++round) {
    Steps steps{int(random.integer(1, 30)), int(random.integer(1, 20))};
    const double density = random.unit();
    const auto hottest = random.integer(1, 9);  // a small range makes ties likely
    for (std::uint32_t& value : steps.values) {
      if (random.unit() < density) value = std::uint32_t(random.integer(1, hottest));
    }
    INFO("seed 21, round " << round);
    check(steps);
  }
}

TEST_CASE("pictures of one row or one column have regions, too") {
  Random random(22);
  for (int round = 0; round < 300; ++round) {
    const int length = int(random.integer(1, 60));
    Steps steps(round % 2 == 0 ? length : 1, round % 2 == 0 ? 1 : length);
    for (std::uint32_t& value : steps.values) value = std::uint32_t(random.integer(0, 2));
    INFO("seed 22, round " << round);
    check(steps);
  }
}

TEST_CASE("all and nothing are one region and none") {
  Steps steps(9, 7);
  check(steps);
  CHECK(by_rows(steps, 10).empty());
  std::fill(steps.values.begin(), steps.values.end(), 4u);
  check(steps);
  const auto regions = by_rows(steps, 10);
  REQUIRE(regions.size() == 1);
  CHECK(regions[0].pixels == 63);
  CHECK(regions[0].box == PixelBox{0, 0, 9, 7});
  CHECK(regions[0].worst == PixelPosition{0, 0});
}

TEST_CASE("corners touch: a checkerboard is one region") {
  Steps steps(11, 8);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 11; ++x) steps.at(x, y) = std::uint32_t((x + y) % 2);
  }
  check(steps);
  CHECK(by_rows(steps, 10).size() == 1);
  check(drawn({"1..1", ".11.", "1..1"}));
  check(drawn({"1...1", ".1.1.", "..1..", ".1.1.", "1...1"}));
}

TEST_CASE("parts that meet only later are one region") {
  check(drawn({"1.1.1.1.1", "1.1.1.1.1", "111111111"}));  // a comb that points up
  check(drawn({"111111111", "1.1.1.1.1", "1.1.1.1.2"}));  // a comb that points down
  check(drawn({"1.1.1.1.1", "1.1.1.1.1", "3.111.1.1", "1....1.1"}));
  check(drawn({"1.......1", "1.1...1.1", "1.1.1.1.1", "1.1...1.1", "1.11111.1", "1.......1",
               "111111111"}));  // one region inside another
  check(drawn({"1.1.1.1.1", "11..1..11", ".1..1..1.", ".11.1.11.", "..1.1.1..", "..11111.."}));
  check(drawn({"..9..", ".1.1.", "1...1", ".1.1.", "..1.."}));  // a ring
  check(drawn({"..1..", ".1.1.", "1.5.1", ".1.1.", "..1.."}));  // a ring with a pixel inside
}

// Draws a line that turns inwards until there is no room left.
Steps spiral(int size) {
  Steps steps(size, size);
  int x = 0, y = 0, dx = 1, dy = 0;
  const auto free_at = [&](int at_x, int at_y) {
    return at_x < 0 || at_y < 0 || at_x >= size || at_y >= size || steps.at(at_x, at_y) == 0;
  };
  const auto inside = [&](int at_x, int at_y) {
    return at_x >= 0 && at_y >= 0 && at_x < size && at_y < size;
  };
  for (;;) {
    steps.at(x, y) = 1;
    const auto can_go = [&] {
      return inside(x + dx, y + dy) && free_at(x + dx, y + dy) && free_at(x + 2 * dx, y + 2 * dy);
    };
    if (!can_go()) {
      std::tie(dx, dy) = std::tuple(-dy, dx);
      if (!can_go()) return steps;
    }
    x += dx;
    y += dy;
  }
}

TEST_CASE("a spiral is one region, and its complement another") {
  for (const int size : {5, 12, 31}) {
    Steps steps = spiral(size);
    check(steps);
    CHECK(by_rows(steps, 10).size() == 1);
    for (std::uint32_t& value : steps.values) value = 1 - value;
    check(steps);
  }
}

TEST_CASE("regions come worst first: by largest step, then by pixels, then from the top left") {
  const Steps steps = drawn({"1.22.3", "......", "2.2.55", "......", "11.5.."});
  check(steps);
  const auto regions = by_rows(steps, 10);
  REQUIRE(regions.size() == 8);
  CHECK(regions[0].box == PixelBox{4, 2, 2, 1});  // step 5, two pixels
  CHECK(regions[1].box == PixelBox{3, 4, 1, 1});  // step 5, one pixel
  CHECK(regions[2].box == PixelBox{5, 0, 1, 1});  // step 3
  CHECK(regions[3].box == PixelBox{2, 0, 2, 1});  // step 2, two pixels
  CHECK(regions[4].box == PixelBox{0, 2, 1, 1});  // step 2, further left
  CHECK(regions[5].box == PixelBox{2, 2, 1, 1});
  CHECK(regions[6].box == PixelBox{0, 4, 2, 1});  // step 1, two pixels
  CHECK(regions[7].box == PixelBox{0, 0, 1, 1});
}

TEST_CASE("asking for the worst again gives the same") {
  RegionFinder finder(3, 2);
  const std::uint32_t row[] = {3, 0, 4};
  finder.add_row(0, row);
  const auto once = finder.worst();
  const auto twice = finder.worst();
  REQUIRE(once.size() == 2);
  REQUIRE(twice.size() == 2);
  CHECK(same(once[0], twice[0]));
  CHECK(same(once[1], twice[1]));
  CHECK(finder.count() == 2);
}

}  // namespace
}  // namespace glassbox::test
