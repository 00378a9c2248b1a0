#include "study/extremes/common/coverage.h"
#include "study/extremes/common/drawn_coverage.h"
#include "study/extremes/common/extreme_case.h"
#include "study/naive/coverage.h"

#include <glassbox/base/random.h>

namespace glassbox::study {
namespace c43 {

// The example in the rules of Direct3D. A rectangle from (1, 1) to (3, 5), where pixel centres have
// integer coordinates, is one from (1.5, 1.5) to (3.5, 5.5) where they are at halves. Its corners
// are pixel centres; columns 1 and 2 of rows 1 to 4 must be covered, once each. The two triangles
// of the square from (0, 0) to (5, 5) have 15 and 10 pixels.
std::int64_t fixture_faults(const CoverageFunction& covers) {
  const auto v = [](double x, double y) { return screen_vertex(x, y); };
  const Image<int> rectangle = times_covered(
      covers, {{v(1.5, 1.5), v(3.5, 1.5), v(3.5, 5.5)}, {v(1.5, 1.5), v(3.5, 5.5), v(1.5, 5.5)}}, 8,
      8);
  std::int64_t wrong = 0;
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const int right = x >= 1 && x <= 2 && y >= 1 && y <= 4 ? 1 : 0;
      wrong += rectangle.at(x, y) != right;
    }
  }
  const auto pixels = [&](const ScreenTriangle& t) {
    std::int64_t count = 0;
    covers(t, {0, 0, 8, 8}, [&](int, int) { ++count; });
    return count;
  };
  wrong += pixels({v(0, 0), v(5, 0), v(5, 5)}) != 15;
  wrong += pixels({v(0, 5), v(0, 0), v(5, 5)}) != 10;
  return wrong;
}

Outcome measure_error(const CoverageFunction& covers) {
  CoverageFaults faults;
  Random random(43);
  for (int i = 0; i < 20000; ++i) {
    SnappedTriangle t;
    for (SnappedVertex& v : t) {
      v = {std::int32_t(random.integer(0, 7)) * 256 + 128,
           std::int32_t(random.integer(0, 7)) * 256 + 128};
    }
    compare_coverage(covers, screen_triangle(t), {0, 0, 8, 8}, faults);
  }
  Outcome outcome = faults.outcome();
  outcome.error += double(fixture_faults(covers));
  return outcome;
}

Image<int> drawn(const CoverageFunction& covers) {
  const auto v = [](double x, double y) { return screen_vertex(x, y); };
  return times_covered(covers, {{v(0, 0), v(8, 0), v(8, 8)}, {v(0, 8), v(0, 0), v(8, 8)}}, 8, 8);
}

// 4,096 triangles with corners at pixel centres, side by side in one picture.
Outcome measure_drawn_error(const TestedEngine& engine) {
  static const CoverageReference cells(
      [] {
        Random random(143);
        std::vector<ScreenTriangle> triangles;
        for (int cell = 0; cell < 4096; ++cell) {
          const auto centre = [&](int at) { return at * 8 + double(random.integer(0, 7)) + 0.5; };
          const auto corner = [&] {
            const double x = centre(cell % 64), y = centre(cell / 64);
            return screen_vertex(x, y);
          };
          triangles.push_back({corner(), corner(), corner()});
        }
        return triangles;
      }(),
      512);
  return cells.measure_error(engine);
}

}  // namespace c43

ExtremeCase c43_centre_on_edge() {
  using namespace c43;
  const auto with = [](const naive::CoverageParts& parts) {
    return [parts] { return measure_error(naive::covers_with(parts)); };
  };
  return {
      .id = "C-43",
      .name = "Pixel centres on edges and vertices",
      .construction =
          "20,000 random triangles with vertices at pixel centres of an 8 x 8 picture; the "
          "rectangle (1.5,1.5)-(3.5,5.5); the halves of the square (0,0)-(5,5), which have 15 and "
          "10 pixels",
      .stage = "coverage",
      .right_answer =
          "no pixel differs from the top-left rule, which is tested with a sample moved by (e, "
          "e^2) in 128 bits",
      .unit = "pixels",
      .oracle = Oracle::kInteger,
      .ours = {"integer edge functions, top-left rule",
               [] { return measure_error(pipeline_covers); }},
      .naive = {"float cross products, >= 0", [] { return measure_error(naive::float_covers); }},
      .mutants = {{"the tie rule is missing: no triangle owns an edge",
                   with({.owns = naive::owns_none})},
                  {"every triangle owns all pixel centres on its edges",
                   with({.owns = naive::owns_all})},
                  {"the bottom-right rule in place of the top-left rule",
                   with({.owns = naive::bottom_right})},
                  {"horizontal top edges own no pixel centres", with({.owns = naive::left_only})}},
      .drawn = measure_drawn_error,
      .pictures = {{"naive", [] { return coverage_png(drawn(naive::float_covers), 32); }},
                   {"ours", [] { return coverage_png(drawn(pipeline_covers), 32); }}},
  };
}

}  // namespace glassbox::study
