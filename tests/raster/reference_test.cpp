// Coverage masks, and depths and weights at pixel centres, compared with exact tables that another
// program computed.
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <glassbox/raster/coverage.h>
#include <glassbox/raster/interpolate.h>

#include "tests/raster/exact.h"
#include "tests/support/catch.h"
#include "tests/support/skip.h"

namespace {

using namespace glassbox;
using namespace glassbox::test;

const std::string kTables = GLASSBOX_ASSETS_DIR "/golden/mesa-ref/share";

// The rows of tab-separated cells, without comments and without the row of column names.
std::vector<std::vector<std::string>> read_table(const std::string& name) {
  std::ifstream file(kTables + "/" + name);
  REQUIRE(file);
  std::vector<std::vector<std::string>> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#' || line.rfind("id\t", 0) == 0) continue;
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, '\t');) rows.back().push_back(cell);
  }
  REQUIRE(rows.size() >= 10);
  return rows;
}

}  // namespace

TEST_CASE(
    "coverage agrees with the exact masks of the reference table, in every row (C-43, C-44, "
    "C-47)") {
  if (!std::filesystem::exists(kTables)) SKIP_TEST("no assets at " << kTables);
  const auto rows = read_table("coverage.tsv");
  for (const auto& row : rows) {
    const auto at = [&](std::size_t k) { return std::int32_t(std::stol(row[k])); };
    const SnappedTriangle t{SnappedVertex{at(1), at(2)}, {at(3), at(4)}, {at(5), at(6)}};
    std::array<std::uint32_t, 32> mask{};
    std::int64_t pixels = 0;
    if (const auto setup = setup_triangle(screen_triangle(t))) {
      for_each_covered(*setup, {0, 0, 32, 32}, [&](const Coverage& c) {
        mask[std::size_t(c.y)] |= 0x80000000u >> c.x;
        ++pixels;
      });
    }
    std::istringstream expected(row[8]);
    CAPTURE(row[0], t);
    REQUIRE(pixels == at(7));
    for (std::size_t y = 0; y < 32; ++y) {
      std::string word;
      std::getline(expected, word, ',');
      REQUIRE(mask[y] == std::uint32_t(std::stoul(word, nullptr, 16)));
    }
  }
}

TEST_CASE(
    "depth and weights agree with the exact columns of the reference table, within the stated "
    "bounds") {
  if (!std::filesystem::exists(kTables)) SKIP_TEST("no assets at " << kTables);
  const auto triangles = read_table("interpolation_triangles.tsv");
  const auto rows = read_table("interpolation.tsv");
  // Positions are multiples of 1/256 px and all w are powers of two, so nothing is rounded before
  // the setup.
  std::map<std::string, TriangleSetup> setups;
  for (const auto& row : triangles) {
    std::array<ScreenVertex, 3> t;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = [&](std::size_t i) { return std::stof(row[1 + 4 * k + i]); };
      const float w = at(3);
      t[k] = {{(at(0) / w + 1) * 16, (at(1) / w + 1) * 16, (at(2) / w + 1) * 0.5f}, 1 / w};
      REQUIRE(t[k].position.x * 256 == std::floor(t[k].position.x * 256));
      REQUIRE(t[k].position.y * 256 == std::floor(t[k].position.y * 256));
    }
    const auto setup = setup_triangle(t);
    REQUIRE(setup);
    setups[row[0]] = *setup;
  }
  for (const auto& row : rows) {
    const TriangleSetup& setup = setups.at(row[0]);
    Coverage pixel{std::stoi(row[1]), std::stoi(row[2]), {}};
    for (std::size_t k = 0; k < 3; ++k) {
      pixel.edges[k] = setup.edges[k].at(pixel.x * 256 + 128, pixel.y * 256 + 128);
      REQUIRE(pixel.edges[k] > 0);
    }
    const Fragment fragment = interpolate(setup, pixel);
    // The table's doubles are rounded by 2^-53, which is far below the terms of higher order.
    const double u = 0x1p-24;
    const double depth = std::stod(row[3]);
    CAPTURE(row[0], pixel.x, pixel.y, fragment.depth, depth);
    REQUIRE(std::abs(double(fragment.depth) - depth) <= 8.1 * u * depth);
    for (std::size_t k = 0; k < 3; ++k) {
      const double weight = std::stod(row[std::size_t(4 + setup.order[k])]);
      REQUIRE(std::abs(double(fragment.weights[k]) - weight) <= 10.1 * u * weight);
    }
  }
}
