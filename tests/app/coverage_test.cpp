// Exact coverage in parallel projection: with extents and sizes that are powers of two, coordinates
// that are multiples of 1/256 px arrive unchanged. Whole runs of the program then cover exactly the
// pixels that integer arithmetic gives.
#include "tests/support/catch.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <glassbox/base/random.h>
#include "tests/app/working_directory.h"
#include "tests/support/skip.h"

namespace glassbox::test {
namespace {

struct Corner2 {
  std::int64_t x = 0, y = 0;  // 1/256 px, y down
};
using Triangle2 = std::array<Corner2, 3>;

// Whether the triangle owns the sample at the centre of pixel (i, j), by the top-left rule.
bool owns(Triangle2 t, int i, int j) {
  const Corner2 p{256 * std::int64_t(i) + 128, 256 * std::int64_t(j) + 128};
  const auto edge = [](const Corner2& a, const Corner2& b, const Corner2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  };
  const std::int64_t area = edge(t[0], t[1], t[2]);
  if (area == 0) return false;
  if (area < 0) std::swap(t[1], t[2]);  // make it clockwise as seen
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner2 a = t[k];
    const Corner2 b = t[(k + 1) % 3];
    const std::int64_t e = edge(a, b, p);
    const bool top_or_left = (b.y == a.y && b.x > a.x) || b.y < a.y;
    if (e < 0 || (e == 0 && !top_or_left)) return false;
  }
  return true;
}

// Returns the OBJ text for a picture of `side` x `side` pixels whose height is `extent` world
// units, both powers of two: pixel coordinates become world coordinates without rounding.
std::string obj_of(const std::vector<Triangle2>& triangles, int side, double extent) {
  std::string text;
  char line[120];
  for (std::size_t n = 0; n < triangles.size(); ++n) {
    for (const Corner2& c : triangles[n]) {
      const double x = (double(c.x) / 256 / side - 0.5) * extent;
      const double y = (0.5 - double(c.y) / 256 / side) * extent;
      std::snprintf(line, sizeof line, "v %.17g %.17g 0\n", x, y);
      text += line;
    }
    std::snprintf(line, sizeof line, "f %zu %zu %zu\n", 3 * n + 1, 3 * n + 2, 3 * n + 3);
    text += line;
  }
  return text;
}

Plane ids(const WorkingDirectory& here, const std::vector<Triangle2>& triangles, int side,
          double extent) {
  here.write("triangles.obj", obj_of(triangles, side, extent));
  std::ostringstream command;
  command
      << "render triangles.obj --cull none --eye 0,0,1 --look-at 0,0,0 --near 0.5 --far 2 --size "
      << side << "x" << side << " --ortho " << extent << " --id-out ids.pfm";
  const Outcome outcome = here.run(command.str());
  INFO(command.str() << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return parse_pfm(here.read("ids.pfm"));
}

std::string text_of(const Triangle2& t) {
  std::ostringstream text;
  for (const Corner2& c : t) text << " (" << c.x << ", " << c.y << ")";
  return text.str() + " / 256 px";
}

constexpr int kTile = 32;  // px

// Many triangles in one picture, one in each tile.
struct TriangleGrid {
  int tiles;  // in each direction
  std::vector<Triangle2> triangles;

  Triangle2 placed_triangle(std::size_t n) const {
    Triangle2 t = triangles[n];
    for (Corner2& c : t) {
      c.x += std::int64_t(n % std::size_t(tiles)) * kTile * 256;
      c.y += std::int64_t(n / std::size_t(tiles)) * kTile * 256;
    }
    return t;
  }
};

// Checks every pixel of the grid: it has the number of its tile's triangle if `covered` returns
// true, and 0 otherwise.
template <class Covered>
void check_grid(const TriangleGrid& grid, double extent, const Covered& covered) {
  const WorkingDirectory here;
  std::vector<Triangle2> placed;
  for (std::size_t n = 0; n < grid.triangles.size(); ++n) placed.push_back(grid.placed_triangle(n));
  const Plane plane = ids(here, placed, grid.tiles * kTile, extent);
  for (std::size_t n = 0; n < placed.size(); ++n) {
    const int x0 = int(n % std::size_t(grid.tiles)) * kTile;
    const int y0 = int(n / std::size_t(grid.tiles)) * kTile;
    int wrong = 0;
    for (int j = 0; j < kTile; ++j) {
      for (int i = 0; i < kTile; ++i) {
        const float expected = covered(n, i, j) ? float(n + 1) : 0.0f;
        if (plane.at(x0 + i, y0 + j) != expected) ++wrong;
      }
    }
    INFO("triangle " << n << text_of(grid.triangles[n]) << ", extent " << extent);
    CHECK(wrong == 0);
  }
}

// Returns a random corner; corners at the centres and corners of pixels are frequent.
Corner2 random_corner(Random& random) {
  const std::int64_t grid = std::array<std::int64_t, 4>{1, 1, 128, 256}[random.bits() % 4];
  return {random.integer(0, kTile * 256 / grid) * grid,
          random.integer(0, kTile * 256 / grid) * grid};
}

TEST_CASE(
    "random triangles on the 1/256 px grid cover what integers say, at any power-of-two scale") {
  constexpr std::uint64_t kSeed = 20;
  INFO("seed " << kSeed);
  Random random(kSeed);
  for (const double extent : {512.0, 1.0, 0x1p-10, 0x1p+20}) {
    TriangleGrid grid{16, {}};
    for (int n = 0; n < 256; ++n) {
      grid.triangles.push_back(
          {random_corner(random), random_corner(random), random_corner(random)});
    }
    check_grid(grid, extent,
               [&](std::size_t n, int i, int j) { return owns(grid.triangles[n], i, j); });
  }
}

// ---- the rational reference masks, where they are present ----

struct Row {
  std::string id;
  Triangle2 triangle;
  std::array<std::uint32_t, kTile> mask{};  // bit 31 is column 0
  bool covers(int i, int j) const { return (mask[std::size_t(j)] >> (31 - i) & 1u) != 0; }
  bool inside_tile() const {
    for (const Corner2& c : triangle) {
      if (c.x < 0 || c.y < 0 || c.x > kTile * 256 || c.y > kTile * 256) return false;
    }
    return true;
  }
};

std::vector<Row> read_rows(const std::string& path) {
  std::vector<Row> rows;
  std::ifstream in(path);
  for (std::string text; std::getline(in, text);) {
    if (text.empty() || text[0] == '#' || text.rfind("id\t", 0) == 0) continue;
    std::istringstream fields(text);
    Row row;
    std::string pixels, mask;
    fields >> row.id;
    for (Corner2& c : row.triangle) fields >> c.x >> c.y;
    fields >> pixels >> mask;
    std::istringstream words(mask);
    for (std::uint32_t& line : row.mask) {
      std::string word;
      std::getline(words, word, ',');
      line = std::uint32_t(std::stoul(word, nullptr, 16));
    }
    rows.push_back(row);
  }
  return rows;
}

TEST_CASE("whole runs agree with the exact coverage masks of the reference table") {
  const std::string path = std::string(GLASSBOX_ASSETS_DIR) + "/golden/mesa-ref/share/coverage.tsv";
  if (!std::filesystem::exists(path)) SKIP_TEST("no assets at " << path);
  std::vector<Row> inside, outside;
  for (const Row& row : read_rows(path)) (row.inside_tile() ? inside : outside).push_back(row);
  REQUIRE(inside.size() > 100);
  // Triangles within the picture are drawn 256 in a grid.
  for (std::size_t first = 0; first < inside.size(); first += 256) {
    TriangleGrid grid{16, {}};
    for (std::size_t n = first; n < std::min(first + 256, inside.size()); ++n) {
      grid.triangles.push_back(inside[n].triangle);
    }
    check_grid(grid, 512,
               [&](std::size_t n, int i, int j) { return inside[first + n].covers(i, j); });
  }
  // Triangles that extend beyond the picture are drawn alone. Only some of them, because each needs
  // a run of the program.
  const std::size_t step = std::max<std::size_t>(1, outside.size() / 100);
  for (std::size_t n = 0; n < outside.size(); n += step) {
    const Row& row = outside[n];
    INFO("row " << row.id);
    check_grid({1, {row.triangle}}, 32,
               [&](std::size_t, int i, int j) { return row.covers(i, j); });
  }
}

}  // namespace
}  // namespace glassbox::test
